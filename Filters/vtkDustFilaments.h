/**
 * @class   vtkDustFilaments
 * @brief   filaments of dust from the seeds of a disc
 *
 * From every seed a random walk of absorbing particles along the velocity of its ring or along the
 * disc's rotation (Dykes et al., dust models 1 and 2), held to the plane by an oscillator in
 * thermal equilibrium. Input: seeds from vtkDiskSeeds. Output: particles whose Intensity is an
 * absorption cross-section in kpc^2. With Model FROM_DESCRIPTION the .galaxy file decides and the
 * other parameters are unused.
 */
#ifndef vtkDustFilaments_h
#define vtkDustFilaments_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKGALAXYRECONSTRUCTION_EXPORT vtkDustFilaments : public vtkPolyDataAlgorithm
{
public:
  static vtkDustFilaments* New();
  vtkTypeMacro(vtkDustFilaments, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Models
  {
    FROM_DESCRIPTION = -1,
    RING_VELOCITY = 0,
    DISK_ROTATION = 1,
  };
  ///@{
  /// The dust model. Default FROM_DESCRIPTION.
  vtkSetClampMacro(Model, int, FROM_DESCRIPTION, DISK_ROTATION);
  vtkGetMacro(Model, int);
  ///@}
  ///@{
  /// Particles of a filament. Default 60.
  vtkSetMacro(Steps, int);
  vtkGetMacro(Steps, int);
  ///@}
  ///@{
  /// Length of a step, kpc. Default 0.03.
  vtkSetMacro(StepLength, double);
  vtkGetMacro(StepLength, double);
  ///@}
  ///@{
  /// sigma_v in the plane, km/s. Default 10.
  vtkSetMacro(VelocityDispersion, double);
  vtkGetMacro(VelocityDispersion, double);
  ///@}
  ///@{
  /// sigma_w across the plane, km/s. Default 6.
  vtkSetMacro(VerticalDispersion, double);
  vtkGetMacro(VerticalDispersion, double);
  ///@}
  ///@{
  /// Root mean square height, kpc. Default 0.1.
  vtkSetMacro(ScaleHeight, double);
  vtkGetMacro(ScaleHeight, double);
  ///@}
  ///@{
  /// Time in which a random velocity is forgotten, Myr. Default 10.
  vtkSetMacro(DampingTime, double);
  vtkGetMacro(DampingTime, double);
  ///@}
  ///@{
  /// Another seed gives other filaments. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}

protected:
  vtkDustFilaments() = default;
  ~vtkDustFilaments() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDustFilaments(const vtkDustFilaments&) = delete;
  void operator=(const vtkDustFilaments&) = delete;

  int Model = FROM_DESCRIPTION;
  int Steps = 60;
  double StepLength = 0.03;
  double VelocityDispersion = 10;
  double VerticalDispersion = 6;
  double ScaleHeight = 0.1;
  double DampingTime = 10;
  int RandomSeed = 1;
};

#endif
