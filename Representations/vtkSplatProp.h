/**
 * @class   vtkSplatProp
 * @brief   draws the splat engine's picture of particles into a view
 *
 * The picture is computed on the CPU for the renderer's camera, then laid over what the renderer
 * has drawn: first the destination times the transmittance, then plus the tone-mapped radiance,
 * each per channel. Of several such props in a renderer the first draws the particles of all, in
 * one depth order, each with its own exposure and component factors; the stretch, the gamma and the
 * kernel are the first's. What takes long fires vtkCommand::ProgressEvent with the fraction done,
 * and can be aborted by its observers; what only betters a picture that is there stops where the
 * window's vtkCommand::AbortCheckEvent says so. Drawn in the overlay stage, so that it neither
 * enters nor disturbs depth peeling; opaque geometry hides the particles behind it through the
 * depth buffer, and what is translucent is seen behind all particles. What several processes draw
 * is put together first.
 */
#ifndef vtkSplatProp_h
#define vtkSplatProp_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkProp.h"
#include "vtkSmartPointer.h" // for the settings

#include <memory> // for the picture kept between renderings
#include <string> // for the statistics
#include <vector> // for the props drawn together

class vtkPolyData;
class vtkRenderer;
class vtkSplatSettings;

namespace galaxy
{
class SplatCanvas;
class SplatPicture;
struct Camera;
struct ShownPicture;
struct ToneMap;
}

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSplatProp : public vtkProp
{
public:
  static vtkSplatProp* New();
  vtkTypeMacro(vtkSplatProp, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The particles, arrays as vtkSplatImage takes them; null draws nothing.
  void SetParticles(vtkPolyData* particles);

  /// What the picture depends on besides particles and camera.
  vtkSplatSettings* GetSettings();

  ///@{
  /// Factor on the radiance before it is stretched. Default 1.
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}
  ///@{
  /// Softening Q of the asinh stretch; 0 is linear. Default 10.
  vtkSetMacro(Stretch, double);
  vtkGetMacro(Stretch, double);
  ///@}
  ///@{
  /// Displayed value is the stretched value to the power 1/Gamma. Default 1.
  vtkSetMacro(Gamma, double);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /// Exposed light that is shown as black and as white, by channel: of [black, white] the stretch
  /// makes [0, 1]. Default 0 and 1; white must be above black.
  vtkSetVector3Macro(BlackPoint, double);
  vtkGetVector3Macro(BlackPoint, double);
  vtkSetVector3Macro(WhitePoint, double);
  vtkGetVector3Macro(WhitePoint, double);
  ///@}

  ///@{
  /// While the view moves, a preview of what would take longer than PreviewTime is shown.
  vtkSetMacro(Interactive, bool);
  vtkGetMacro(Interactive, bool);
  ///@}

  ///@{
  /// Whether the view is drawn by other processes than this one, or by several: the picture is then
  /// laid over it by LayLast(), when what they have drawn has been put together and smoothed. That
  /// of the first process, who has all particles, is taken; a client gets it from there.
  vtkSetMacro(IsLaidLast, bool);
  vtkGetMacro(IsLaidLast, bool);
  ///@}
  /// To be called on all of them after each rendering of a renderer that has this prop.
  void LayLast(vtkObject* renderer, unsigned long, void*);
  /// To be called when the window has been rendered: whoever renders it next without ParaView's
  /// view does so without the other processes.
  void EndWindow() { this->IsLaidLast = false; }

  ///@{
  /// Whether Refine() will be called when the view rests: the first picture is then the last
  /// preview. Else it is the whole one.
  vtkSetMacro(Refining, bool);
  vtkGetMacro(Refining, bool);
  ///@}
  /// Lets the next picture of a view that rests be a better one, of four times the time and at last
  /// of all particles. False if there is none.
  bool Refine();

  /// To be called by an observer of ProgressEvent: the picture is given up. What was shown of the
  /// same scene stays; else there is a preview.
  void AbortPicture() { this->Aborted = true; }

  ///@{
  /// What the last picture called for and what it cost.
  const char* GetActiveEffects() { return this->ActiveEffects.c_str(); }
  const char* GetRenderStatistics() { return this->RenderStatistics.c_str(); }
  ///@}

  double* GetBounds() VTK_SIZEHINT(6) override;
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSplatProp();
  ~vtkSplatProp() override;

private:
  vtkSplatProp(const vtkSplatProp&) = delete;
  void operator=(const vtkSplatProp&) = delete;

  /// The same ones on all processes.
  static std::vector<vtkSplatProp*> Visible(vtkRenderer* renderer);
  /// The props that the renderer draws particles of, the first of which draws all of them.
  std::vector<vtkSplatProp*> DrawnTogether(vtkRenderer* renderer);
  void UpdatePicture(vtkRenderer* renderer, const galaxy::Camera& camera,
    std::vector<float>&& opaqueDepth, const std::vector<vtkSplatProp*>& props);
  /// On the first process; elsewhere none.
  galaxy::ShownPicture PictureOfAllProcesses(vtkRenderer* renderer);
  galaxy::ShownPicture ShownPicture() const;
  /// Warns, once, where galaxies are drawn together that the sky has in different places.
  void HintAtPlaces(const std::vector<vtkSplatProp*>& props);
  /// Says how much of the picture is done; false if it is not wanted any more.
  bool ReportProgress(double fraction);
  galaxy::ToneMap GetToneMap() const;
  /// When the particles or the settings changed last.
  vtkMTimeType InputTime();

  vtkSmartPointer<vtkPolyData> Particles;
  vtkTimeStamp ParticlesTime;
  vtkSmartPointer<vtkSplatSettings> Settings;
  double Exposure = 1;
  double Stretch = 10;
  double Gamma = 1;
  double BlackPoint[3] = { 0, 0, 0 };
  double WhitePoint[3] = { 1, 1, 1 };
  bool Interactive = false;
  bool Refining = false;
  bool IsLaidLast = false;
  bool Aborted = false;
  double Bounds[6];
  vtkMTimeType BoundsTime = 0;
  std::string ActiveEffects;
  std::string RenderStatistics;
  std::string PlacesHint; ///< what was warned of last

  std::unique_ptr<galaxy::SplatPicture> Picture;
  std::unique_ptr<galaxy::SplatCanvas> Canvas;
};

#endif
