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
    RINGS = 4,
  };
  ///@{
  /// The thickness model; RINGS: the ring table's own scale height and law. Default
  /// FROM_DESCRIPTION.
  vtkSetClampMacro(Model, int, FROM_DESCRIPTION, RINGS);
  vtkGetMacro(Model, int);
  ///@}
  ///@{
  /// Vertical law of all but Gaussian, TiRiFiC's LTYPE: 1 Gaussian (default), 2 sech^2, 3
  /// exponential, 4 Lorentzian, 5 box.
  vtkSetMacro(Law, int);
  vtkGetMacro(Law, int);
  ///@}
  ///@{
  /// Mean number of children: at intensity 1 (Gaussian) or at R = 0 (the others). Default 1.
  vtkSetMacro(Children, double);
  vtkGetMacro(Children, double);
  ///@}
  ///@{
  /// Standard deviation, kpc: along every axis (Gaussian) or in the plane. Default 0.1.
  vtkSetMacro(Sigma, double);
  vtkGetMacro(Sigma, double);
  ///@}
  ///@{
  /// Radial scale length H_r, kpc (Tapered, Hydrostatic). Default 2.5.
  vtkSetMacro(ScaleLength, double);
  vtkGetMacro(ScaleLength, double);
  ///@}
  ///@{
  /// Axial scale height H_z, kpc (Tapered, Hydrostatic). Default 0.34.
  vtkSetMacro(ScaleHeight, double);
  vtkGetMacro(ScaleHeight, double);
  ///@}
  ///@{
  /// Full width at half maximum at the centre, kpc (Flared). Default 0.3.
  vtkSetMacro(FWHMCentre, double);
  vtkGetMacro(FWHMCentre, double);
  ///@}
  ///@{
  /// The same at the stellar disc's edge, kpc (Flared). Default 0.8.
  vtkSetMacro(FWHMEdge, double);
  vtkGetMacro(FWHMEdge, double);
  ///@}
  ///@{
  /// Radius of the stellar disc's edge, kpc (Flared). Default 10.
  vtkSetMacro(EdgeRadius, double);
  vtkGetMacro(EdgeRadius, double);
  ///@}
  ///@{
  /// Length of the exponential flare beyond the edge, kpc (Flared). Default 17.4.
  vtkSetMacro(FlareLength, double);
  vtkGetMacro(FlareLength, double);
  ///@}
  ///@{
  /// Rotation velocity at which the widths hold, km/s (Flared). Default 189.
  vtkSetMacro(ReferenceVelocity, double);
  vtkGetMacro(ReferenceVelocity, double);
  ///@}
  ///@{
  /// Velocity dispersion of the gas, km/s (Hydrostatic). Default 8.
  vtkSetMacro(GasDispersion, double);
  vtkGetMacro(GasDispersion, double);
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
  int Law = 1;
  double Children = 1;
  double Sigma = 0.1;
  double ScaleLength = 2.5;
  double ScaleHeight = 0.34;
  double FWHMCentre = 0.3;
  double FWHMEdge = 0.8;
  double EdgeRadius = 10;
  double FlareLength = 17.4;
  double ReferenceVelocity = 189;
  double GasDispersion = 8;
  int RandomSeed = 1;
};

#endif
