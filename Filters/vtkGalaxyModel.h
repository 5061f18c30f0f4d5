/**
 * @class   vtkGalaxyModel
 * @brief   every component of a galaxy as particles
 *
 * Input: a galaxy from vtkGalaxyReader. Output: particles (kpc) with `SmoothingLength`,
 * `Intensity`, `Color`, `Component`, optionally `Velocity`; in the field data the component table,
 * GalaxyName, SkyCentre (degrees) and SkyDistance (kpc), and where the galaxy is looked at from
 * (Filters/ViewpointData.h). The same file, scale and seed give the same particles, bit for bit,
 * for any number of threads.
 */
#ifndef vtkGalaxyModel_h
#define vtkGalaxyModel_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the report

class VTKGALAXYRECONSTRUCTION_EXPORT vtkGalaxyModel : public vtkPolyDataAlgorithm
{
public:
  static vtkGalaxyModel* New();
  vtkTypeMacro(vtkGalaxyModel, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// A factor on the number of particles of every component, at least 0; the light stays.
  /// Default 1.
  vtkSetMacro(ParticleScale, double);
  vtkGetMacro(ParticleScale, double);
  ///@}
  ///@{
  /// Another seed, at least 0, gives other particles of the same galaxy. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}
  ///@{
  /// Whether particles get a Velocity (km/s). Default false.
  vtkSetMacro(Velocities, bool);
  vtkGetMacro(Velocities, bool);
  ///@}
  ///@{
  /// Side of the pixels that the model will be seen with, kpc: components of particles = "Auto" are
  /// made no finer than that. 0 (default): as fine as their images.
  vtkSetMacro(ViewPixel, double);
  vtkGetMacro(ViewPixel, double);
  ///@}
  ///@{
  /// Seeds, particles, light, seconds and images by component of the last execution: in words, and
  /// as a JSON list with the seconds by stage.
  const char* GetReport() { return this->Report.c_str(); }
  const char* GetReportJSON() { return this->ReportJSON.c_str(); }
  ///@}

protected:
  vtkGalaxyModel() = default;
  ~vtkGalaxyModel() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGalaxyModel(const vtkGalaxyModel&) = delete;
  void operator=(const vtkGalaxyModel&) = delete;

  double ParticleScale = 1;
  int RandomSeed = 1;
  bool Velocities = false;
  double ViewPixel = 0;
  std::string Report;
  std::string ReportJSON;
};

#endif
