/**
 * @class   vtkDiskThickness
 * @brief   particles from the seeds of a disc
 *
 * Spreads every seed into children by one of the thickness models (Dykes et al., models 1 to 3;
 * hydrostatic equilibrium). The children of a seed share its light and keep its colour. Input:
 * seeds from vtkDiskSeeds. Output: particles. With Model FROM_DESCRIPTION the .galaxy file decides
 * and the other parameters are unused.
 */
#ifndef vtkDiskThickness_h
#define vtkDiskThickness_h

#include "vtkGalaxyReconstructionModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKGALAXYRECONSTRUCTION_EXPORT vtkDiskThickness : public vtkPolyDataAlgorithm
{
public:
  static vtkDiskThickness* New();
  vtkTypeMacro(vtkDiskThickness, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Models
  {
    FROM_DESCRIPTION = -1,
    GAUSSIAN = 0,
    TAPERED = 1,
    FLARED = 2,
    HYDROSTATIC = 3,
  };
  ///@{
  /// The thickness model. Default FROM_DESCRIPTION.
  vtkSetClampMacro(Model, int, FROM_DESCRIPTION, HYDROSTATIC);
  vtkGetMacro(Model, int);
  ///@}
  ///@{
  /// Mean number of children at intensity 1 (Gaussian) or R = 0 (Tapered). Default 1.
  vtkSetMacro(Children, double);
  vtkGetMacro(Children, double);
  ///@}
  ///@{
  /// Standard deviation, kpc: isotropic (Gaussian) or in the plane. Default 0.1.
  vtkSetMacro(Sigma, double);
  vtkGetMacro(Sigma, double);
  ///@}
  ///@{
  /// H_r, kpc. Default 2.5.
  vtkSetMacro(ScaleLength, double);
  vtkGetMacro(ScaleLength, double);
  ///@}
  ///@{
  /// H_z, kpc. Default 0.34.
  vtkSetMacro(ScaleHeight, double);
  vtkGetMacro(ScaleHeight, double);
  ///@}
  ///@{
  /// Another seed gives other particles. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}

protected:
  vtkDiskThickness() = default;
  ~vtkDiskThickness() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDiskThickness(const vtkDiskThickness&) = delete;
  void operator=(const vtkDiskThickness&) = delete;

  int Model = FROM_DESCRIPTION;
  double Children = 1;
  double Sigma = 0.1;
  double ScaleLength = 2.5;
  double ScaleHeight = 0.34;
  int RandomSeed = 1;
};

#endif
