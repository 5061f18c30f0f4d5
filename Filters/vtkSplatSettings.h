/**
 * @class   vtkSplatSettings
 * @brief   what a splatted picture depends on besides the particles and the camera
 *
 * Shared by vtkSplatImage and the Splats representation, so that both offer the same choices.
 * Components are addressed by name; a name that the particles do not have is ignored, so that
 * settings survive a change of galaxy.
 */
#ifndef vtkSplatSettings_h
#define vtkSplatSettings_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkObject.h"

#include <array>  // for colours
#include <map>    // for the factors by component name
#include <string> // for component names
#include <vector> // for the component table

namespace galaxy
{
struct ComponentInfo;
}

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSplatSettings : public vtkObject
{
public:
  static vtkSplatSettings* New();
  vtkTypeMacro(vtkSplatSettings, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Kernels
  {
    GAUSSIAN = 0,
    CUBIC_SPLINE = 1,
  };
  ///@{
  /// The particles' profile: Gaussian (default) or CubicSpline; both end at the smoothing length.
  vtkSetClampMacro(Kernel, int, GAUSSIAN, CUBIC_SPLINE);
  vtkGetMacro(Kernel, int);
  ///@}

  enum AccuracyLevels
  {
    OVERLAPPING = 0,
    SORTED = 1,
    BOUNDED = 2,
    PREVIEW = 3,
  };
  ///@{
  /// What is computed: Overlapping, the transfer integral of particles that share their path, slow;
  /// Sorted, the paper's model, one slab a particle in strict depth order; Bounded (default), the
  /// same within Tolerance; Preview, the same of a random part of the particles.
  vtkSetClampMacro(Accuracy, int, OVERLAPPING, PREVIEW);
  vtkGetMacro(Accuracy, int);
  ///@}
  ///@{
  /// Bounded: the largest error on the display, a share of white (default 1/512, from 0 to 1).
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}
  ///@{
  /// Preview: seconds that a picture may take (default 0.1, from 0.01 to 10).
  vtkSetClampMacro(PreviewTime, double, 0.01, 10.0);
  vtkGetMacro(PreviewTime, double);
  ///@}
  ///@{
  /// Overlapping: slices of depth to a third of the smallest absorber's smoothing length (default
  /// 4, from 0.25 to 64); the error falls with their square.
  vtkSetClampMacro(Slices, double, 0.25, 64.0);
  vtkGetMacro(Slices, double);
  ///@}

  enum Looks
  {
    AS_DESCRIBED = 0,
    OPTICAL = 1,
    H_ALPHA = 2,
    ATOMIC_GAS = 3,
    ULTRAVIOLET = 4,
    DUST_ONLY = 5,
    FALSE_COLOR = 6,
  };
  ///@{
  /// Which components are shown and in which colours (Filters/Model/Looks.h): AsDescribed (default)
  /// shows all as they are. What is said of single components comes on top of it.
  vtkSetClampMacro(Look, int, AS_DESCRIBED, FALSE_COLOR);
  vtkGetMacro(Look, int);
  ///@}

  ///@{
  /// A factor on the smoothing length of one component (default 1).
  void SetComponentSize(const char* component, double factor);
  void ClearComponentSize();
  ///@}
  ///@{
  /// A factor on the emission, or the opacity, of one component (default 1).
  void SetComponentBrightness(const char* component, double factor);
  void ClearComponentBrightness();
  ///@}
  ///@{
  /// Draws a component's light in this colour, each channel from 0 to 1, in place of its particles'
  /// Color; an absorber's are what it takes from each channel. Light that the particles' Emission
  /// and Absorption give keeps its colour.
  void SetComponentColor(const char* component, double red, double green, double blue);
  void ClearComponentColor();
  ///@}
  ///@{
  /// Whether a component is drawn (default: all are).
  void SetComponentVisibility(const char* component, int visible);
  void ClearComponentVisibility();
  ///@}

  /// The names given to the methods above that are not among these components, comma separated.
  std::string UnknownNames(const std::vector<galaxy::ComponentInfo>& components) const;

  /// Applies the factors to a component table and says which components are drawn.
  void Apply(std::vector<galaxy::ComponentInfo>& components, std::vector<bool>& visible) const;

protected:
  vtkSplatSettings() = default;
  ~vtkSplatSettings() override = default;

private:
  vtkSplatSettings(const vtkSplatSettings&) = delete;
  void operator=(const vtkSplatSettings&) = delete;

  using FactorMap = std::map<std::string, double>;
  void SetFactor(FactorMap& factors, const char* component, double factor);
  void ClearFactors(FactorMap& factors);

  int Kernel = GAUSSIAN;
  int Accuracy = BOUNDED;
  double Tolerance = 1.0 / 512;
  double PreviewTime = 0.1;
  double Slices = 4;
  int Look = AS_DESCRIBED;
  FactorMap Sizes;
  FactorMap Brightnesses;
  FactorMap Visibilities;
  std::map<std::string, std::array<double, 3>> Colors;
};

/// The methods through which a class with a member `vtkSplatSettings* Settings` (or smart pointer)
/// offers its settings as server-manager properties. Where a method is added here, change the
/// headers that use this as well: what VTK wraps of them is made anew only then.
#define vtkForwardSplatSettingsMacro                                                               \
  void SetKernel(int kernel)                                                                       \
  {                                                                                                \
    this->Settings->SetKernel(kernel);                                                             \
  }                                                                                                \
  void SetAccuracy(int accuracy)                                                                   \
  {                                                                                                \
    this->Settings->SetAccuracy(accuracy);                                                         \
  }                                                                                                \
  void SetTolerance(double tolerance)                                                              \
  {                                                                                                \
    this->Settings->SetTolerance(tolerance);                                                       \
  }                                                                                                \
  void SetPreviewTime(double seconds)                                                              \
  {                                                                                                \
    this->Settings->SetPreviewTime(seconds);                                                       \
  }                                                                                                \
  void SetSlices(double slices)                                                                    \
  {                                                                                                \
    this->Settings->SetSlices(slices);                                                             \
  }                                                                                                \
  void SetLook(int look)                                                                           \
  {                                                                                                \
    this->Settings->SetLook(look);                                                                 \
  }                                                                                                \
  void SetComponentSize(const char* component, double factor)                                      \
  {                                                                                                \
    this->Settings->SetComponentSize(component, factor);                                           \
  }                                                                                                \
  void ClearComponentSize()                                                                        \
  {                                                                                                \
    this->Settings->ClearComponentSize();                                                          \
  }                                                                                                \
  void SetComponentBrightness(const char* component, double factor)                                \
  {                                                                                                \
    this->Settings->SetComponentBrightness(component, factor);                                     \
  }                                                                                                \
  void ClearComponentBrightness()                                                                  \
  {                                                                                                \
    this->Settings->ClearComponentBrightness();                                                    \
  }                                                                                                \
  void SetComponentColor(const char* component, double red, double green, double blue)             \
  {                                                                                                \
    this->Settings->SetComponentColor(component, red, green, blue);                                \
  }                                                                                                \
  void ClearComponentColor()                                                                       \
  {                                                                                                \
    this->Settings->ClearComponentColor();                                                         \
  }                                                                                                \
  void SetComponentVisibility(const char* component, int visible)                                  \
  {                                                                                                \
    this->Settings->SetComponentVisibility(component, visible);                                    \
  }                                                                                                \
  void ClearComponentVisibility()                                                                  \
  {                                                                                                \
    this->Settings->ClearComponentVisibility();                                                    \
  }

#endif
