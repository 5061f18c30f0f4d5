/**
 * @class   vtkSplatImage
 * @brief   a picture of particles in linear light, without a display
 *
 * Input: any points (Filters/ParticleSets.h), of all processes, with point array `SmoothingLength`
 * (kpc) and either `Intensity`, `Color`,
 * `Component` with a component table, or `Emission` and `Absorption`. Output: vtkImageData with
 * the point arrays `Radiance` (float32 x 3, luminosity per kpc^2 of projected area, the pixel's
 * mean) and `Transmittance` (float32 x 3), rows from the bottom up; the camera, by the
 * names of the properties, and GalaxyName, SkyCentre and SkyDistance, where the particles have
 * them, in the field data. Of several processes the first one has the picture.
 *
 * The model is that of Dykes et al., equation for I_after, in the form that is stable for every
 * optical depth: I <- I exp(-t) + e (1 - exp(-t))/t with e and t the column emission and optical
 * depth of a particle, in the order of the centres' distance (Accuracy Sorted), or, where particles
 * overlap, the transfer integral by slices of depth (Overlapping).
 */
#ifndef vtkSplatImage_h
#define vtkSplatImage_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"  // for the settings
#include "vtkSplatSettings.h" // for the forwarding macro

#include <memory> // for what is kept
#include <string> // for the statistics

namespace galaxy
{
struct ParticleView;
struct PictureCamera;
struct RenderedImage;
struct RenderOptions;
}
class vtkImageData;
class vtkPolyData;

class VTKGALAXYRECONSTRUCTION_EXPORT vtkSplatImage : public vtkImageAlgorithm
{
public:
  static vtkSplatImage* New();
  vtkTypeMacro(vtkSplatImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Width and height in pixels. Default 1024 x 1024.
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}
  ///@{
  /// The camera, as ParaView's views name it; kpc and degrees.
  vtkSetVector3Macro(CameraPosition, double);
  vtkGetVector3Macro(CameraPosition, double);
  vtkSetVector3Macro(CameraFocalPoint, double);
  vtkGetVector3Macro(CameraFocalPoint, double);
  vtkSetVector3Macro(CameraViewUp, double);
  vtkGetVector3Macro(CameraViewUp, double);
  vtkSetMacro(CameraParallelProjection, bool);
  vtkGetMacro(CameraParallelProjection, bool);
  vtkBooleanMacro(CameraParallelProjection, bool);
  ///@}
  ///@{
  /// Half the image's height in kpc under parallel projection.
  vtkSetMacro(CameraParallelScale, double);
  vtkGetMacro(CameraParallelScale, double);
  ///@}
  ///@{
  /// The vertical field in degrees under perspective projection.
  vtkSetMacro(CameraViewAngle, double);
  vtkGetMacro(CameraViewAngle, double);
  ///@}
  enum Projections
  {
    CAMERA = 0,          ///< parallel or perspective, as the properties of the camera say
    EQUIRECTANGULAR = 1, ///< all the sky around CameraPosition, 360 x 180 degrees
    DOME = 2,            ///< fisheye about the line of sight, the angle growing with the radius
  };
  ///@{
  /// Default CAMERA. Of a panorama CameraFocalPoint is in the middle, CameraViewUp is up.
  vtkSetClampMacro(Projection, int, CAMERA, DOME);
  vtkGetMacro(Projection, int);
  ///@}
  ///@{
  /// Degrees across a dome's circle, from 1 to 360. Default 180.
  vtkSetClampMacro(DomeAngle, double, 1.0, 360.0);
  vtkGetMacro(DomeAngle, double);
  ///@}
  ///@{
  /// The radiance that will be shown as white, luminosity per kpc^2: Tolerance is a share of it.
  /// Default 0: not known; a pixel may then be off by Tolerance times its own light.
  vtkSetMacro(White, double);
  vtkGetMacro(White, double);
  ///@}
  ///@{
  /// See vtkSplatSettings.
  vtkForwardSplatSettingsMacro;
  ///@}

  ///@{
  /// What the last picture called for and what it cost.
  const char* GetActiveEffects() { return this->ActiveEffects.c_str(); }
  const char* GetRenderStatistics() { return this->RenderStatistics.c_str(); }
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkSplatImage();
  ~vtkSplatImage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSplatImage(const vtkSplatImage&) = delete;
  void operator=(const vtkSplatImage&) = delete;

  void Draw(vtkPolyData* particles, vtkImageData* output);
  galaxy::RenderedImage Render(
    const galaxy::ParticleView& view, const galaxy::RenderOptions& options);
  galaxy::PictureCamera PictureCamera() const;

  int ImageSize[2] = { 1024, 1024 };
  double CameraPosition[3] = { 0, 0, 1 };
  double CameraFocalPoint[3] = { 0, 0, 0 };
  double CameraViewUp[3] = { 0, 1, 0 };
  bool CameraParallelProjection = false;
  double CameraParallelScale = 1;
  double CameraViewAngle = 30;
  int Projection = CAMERA;
  double DomeAngle = 180;
  double White = 0;
  vtkSmartPointer<vtkSplatSettings> Settings;
  std::string ActiveEffects;
  std::string RenderStatistics;

  struct Memory; // what pictures are made in, kept for the next
  std::unique_ptr<Memory> Splatting;
};

#endif
