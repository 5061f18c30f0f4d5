/**
 * @class   vtkDiskThickness
 * @brief   particles from the seeds of a disc
 *
 * Spreads every seed into children by one of the thickness models (Dykes et al., models 1 to 3;
 * hydrostatic equilibrium). The children of a seed share its light and keep its colour. Input:
 * seeds from vtkDiskSeeds. Output: particles. With Model FROM_DESCRIPTION the .galaxy file decides
 * and the other parameters are unused. A parameter out of its range is an error that names it as
 * the .galaxy file does: ScaleLength is scale_length.
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
  vtkSetMacro(Model, int);
  vtkGetMacro(Model, int);
  ///@}
  ///@{
  /// Vertical law of Tapered, Flared and Hydrostatic, TiRiFiC's LTYPE: 1 Gaussian (default), 2
  /// sech^2, 3 exponential, 4 Lorentzian, 5 box. RINGS has the ring table's.
  vtkSetMacro(Law, int);
  vtkGetMacro(Law, int);
  ///@}
  ///@{
  /// Of the paper's formula (Tapered): 0 (default) the children fall as exp(-R/H_r), 1 to the
  /// letter as exp(-R/H_z); both are H_z thick.
  vtkSetMacro(Reading, int);
  vtkGetMacro(Reading, int);
  ///@}
  ///@{
  /// Whether the children of a seed share its light, 0 (default), or have all of it each, 1.
  vtkSetMacro(ChildLight, int);
  vtkGetMacro(ChildLight, int);
  ///@}
  ///@{
  /// Mean number of children: at intensity 1 (Gaussian) or at R = 0 (the others). 0
  /// (default): 15 (Tapered) or 1.
  vtkSetMacro(Children, double);
  vtkGetMacro(Children, double);
  ///@}
  ///@{
  /// Most children of a seed. Default 1000.
  vtkSetMacro(MaximumChildren, int);
  vtkGetMacro(MaximumChildren, int);
  ///@}
  ///@{
  /// Exponent from the image's intensity to the seed's, 0 to 1 (Gaussian). Default 0.5.
  vtkSetMacro(Compression, double);
  vtkGetMacro(Compression, double);
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
  /// Whether the thickness falls as exp(-R/H_r) too (Tapered). Default off.
  vtkSetMacro(TaperThickness, bool);
  vtkGetMacro(TaperThickness, bool);
  vtkBooleanMacro(TaperThickness, bool);
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
  /// Largest full width at half maximum, kpc (Flared). Default 4.
  vtkSetMacro(FWHMMaximum, double);
  vtkGetMacro(FWHMMaximum, double);
  ///@}
  ///@{
  /// The rotation velocity that the widths are inverse to (Flared): 0 (default) the disc's fastest,
  /// 1 the fastest from each radius outward. A disc of unknown rotation is not scaled.
  vtkSetMacro(VelocityScaling, int);
  vtkGetMacro(VelocityScaling, int);
  ///@}
  ///@{
  /// Rotation velocity of a galaxy that has these widths, km/s (Flared). Default 189.
  vtkSetMacro(ReferenceVelocity, double);
  vtkGetMacro(ReferenceVelocity, double);
  ///@}
  ///@{
  /// Exponent of reference over rotation velocity (Flared). Default 1.
  vtkSetMacro(VelocityExponent, double);
  vtkGetMacro(VelocityExponent, double);
  ///@}
  ///@{
  /// File of rows of radius and full width at half maximum, kpc, in place of the formula (Flared);
  /// none by default.
  vtkSetFilePathMacro(ProfileTable);
  vtkGetFilePathMacro(ProfileTable);
  ///@}
  ///@{
  /// Velocity dispersion of the gas, km/s (Hydrostatic). Default 8.
  vtkSetMacro(GasDispersion, double);
  vtkGetMacro(GasDispersion, double);
  ///@}
  ///@{
  /// Surface density of the stars at the centre, Msun/pc^2 (Hydrostatic). Default 500.
  vtkSetMacro(StellarSurfaceDensity, double);
  vtkGetMacro(StellarSurfaceDensity, double);
  ///@}
  ///@{
  /// Surface density of the gas, Msun/pc^2 (Hydrostatic). Default 10.
  vtkSetMacro(GasSurfaceDensity, double);
  vtkGetMacro(GasSurfaceDensity, double);
  ///@}
  ///@{
  /// Another seed gives other particles. Default 1.
  vtkSetMacro(RandomSeed, int);
  vtkGetMacro(RandomSeed, int);
  ///@}
  ///@{
  /// Whether particles get a Velocity (km/s). Default false.
  vtkSetMacro(Velocities, bool);
  vtkGetMacro(Velocities, bool);
  vtkBooleanMacro(Velocities, bool);
  ///@}

protected:
  vtkDiskThickness() = default;
  ~vtkDiskThickness() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDiskThickness(const vtkDiskThickness&) = delete;
  void operator=(const vtkDiskThickness&) = delete;

  int Model = FROM_DESCRIPTION;
  int Law = 1;
  int Reading = 0;
  int ChildLight = 0;
  double Children = 0;
  int MaximumChildren = 1000;
  double Compression = 0.5;
  double Sigma = 0.1;
  double ScaleLength = 2.5;
  double ScaleHeight = 0.34;
  bool TaperThickness = false;
  double FWHMCentre = 0.3;
  double FWHMEdge = 0.8;
  double EdgeRadius = 10;
  double FlareLength = 17.4;
  double FWHMMaximum = 4;
  int VelocityScaling = 0;
  double ReferenceVelocity = 189;
  double VelocityExponent = 1;
  char* ProfileTable = nullptr;
  double GasDispersion = 8;
  double StellarSurfaceDensity = 500;
  double GasSurfaceDensity = 10;
  int RandomSeed = 1;
  bool Velocities = false;
};

#endif
