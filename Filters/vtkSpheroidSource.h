/**
 * @class   vtkSpheroidSource
 * @brief   a Gaussian spheroid of particles
 *
 * A bulge, a globular cluster, a halo or a round dwarf galaxy: particles of equal light, normally
 * distributed about the centre (Dykes et al., the galactic bulge).
 */
#ifndef vtkSpheroidSource_h
#define vtkSpheroidSource_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSpheroidSource : public vtkPolyDataAlgorithm
{
public:
  static vtkSpheroidSource* New();
  vtkTypeMacro(vtkSpheroidSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Profiles
  {
    GAUSSIAN = 0,
  };
  ///@{
  /// The radial law. Default Gaussian.
  vtkSetClampMacro(Profile, int, GAUSSIAN, GAUSSIAN);
  vtkGetMacro(Profile, int);
  ///@}
  ///@{
  /// How many particles share the light. Default 100000.
  vtkSetMacro(NumberOfParticles, int);
  vtkGetMacro(NumberOfParticles, int);
  ///@}
  ///@{
  /// Standard deviations along X, Y, Z and the centre, kpc.
  vtkSetVector3Macro(Sigma, double);
  vtkGetVector3Macro(Sigma, double);
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}
  ///@{
  /// Radiance in the middle, seen along Z. Default 1.
  vtkSetMacro(CentralBrightness, double);
  vtkGetMacro(CentralBrightness, double);
  ///@}
  ///@{
  /// Colour of the particles, 0 to 1. Default white.
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}
  ///@{
  /// h, kpc; 0 (default): from the mean distance between the particles.
  vtkSetMacro(SmoothingLength, double);
  vtkGetMacro(SmoothingLength, double);
  ///@}
  ///@{
  /// Another seed gives other particles. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}

protected:
  vtkSpheroidSource();
  ~vtkSpheroidSource() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSpheroidSource(const vtkSpheroidSource&) = delete;
  void operator=(const vtkSpheroidSource&) = delete;

  int Profile = GAUSSIAN;
  int NumberOfParticles = 100000;
  double Sigma[3] = { 0.3, 0.3, 0.2 };
  double Center[3] = { 0, 0, 0 };
  double CentralBrightness = 1;
  double Color[3] = { 1, 1, 1 };
  double SmoothingLength = 0;
  int RandomSeed = 1;
};

#endif
