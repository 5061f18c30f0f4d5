/**
 * @class   vtkSpheroidSource
 * @brief   a spheroid of particles
 *
 * A bulge, a globular cluster or a system of them, a halo, an elliptical or a round dwarf galaxy:
 * particles of equal light, distributed about the centre by one of the usual radial laws, the first
 * of them the paper's (Dykes et al., the galactic bulge).
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
    SERSIC,      ///< deprojected after Prugniel and Simien
    HERNQUIST,   ///< 1/(s (1 + s)^3), s = r/ScaleRadius here and below
    EXPONENTIAL, ///< exp(-s)
    PLUMMER,     ///< (1 + s^2)^(-5/2)
    NFW,         ///< 1/(s (1 + s)^2)
    CORED,       ///< (1 + s^2)^(-1.95): the globular clusters of the Milky Way
  };
  ///@{
  /// The radial law of the density. Default Gaussian.
  vtkSetClampMacro(Profile, int, GAUSSIAN, CORED);
  vtkGetMacro(Profile, int);
  ///@}
  ///@{
  /// How many particles share the light. Default 100000.
  vtkSetMacro(NumberOfParticles, int);
  vtkGetMacro(NumberOfParticles, int);
  ///@}
  ///@{
  /// Sersic: the projected radius of half of the light (kpc) and the index n.
  vtkSetClampMacro(EffectiveRadius, double, 1e-6, 1e6);
  vtkGetMacro(EffectiveRadius, double);
  vtkSetClampMacro(SersicIndex, double, 0.5, 10);
  vtkGetMacro(SersicIndex, double);
  ///@}
  ///@{
  /// The scale of the other laws, kpc. Default 2.
  vtkSetClampMacro(ScaleRadius, double, 1e-6, 1e6);
  vtkGetMacro(ScaleRadius, double);
  ///@}
  ///@{
  /// NFW and Cored end at this many ScaleRadius where there is no Truncation. Default 10.
  vtkSetClampMacro(Concentration, double, 0.01, 1e6);
  vtkGetMacro(Concentration, double);
  ///@}
  ///@{
  /// Where the spheroid ends along X, kpc; 0 (default): nowhere.
  vtkSetClampMacro(Truncation, double, 0, 1e6);
  vtkGetMacro(Truncation, double);
  ///@}
  ///@{
  /// The axes along Y and Z relative to that along X, all but Gaussian.
  vtkSetVector2Macro(AxisRatios, double);
  vtkGetVector2Macro(AxisRatios, double);
  ///@}
  ///@{
  /// Star clusters that stand by the radial law and share the particles, each a Plummer sphere of
  /// ClusterRadius (kpc); 0 (default): a smooth body.
  vtkSetClampMacro(Clusters, int, 0, 1 << 24);
  vtkGetMacro(Clusters, int);
  vtkSetClampMacro(ClusterRadius, double, 0, 1e6);
  vtkGetMacro(ClusterRadius, double);
  ///@}
  ///@{
  /// Standard deviations of the Gaussian along X, Y, Z and the centre, kpc.
  vtkSetVector3Macro(Sigma, double);
  vtkGetVector3Macro(Sigma, double);
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}
  ///@{
  /// Radiance in the middle, seen along Z; where that is infinite, at EffectiveRadius (Sersic) or
  /// at the radius of half of the mass (Hernquist, NFW). Default 1.
  vtkSetMacro(CentralBrightness, double);
  vtkGetMacro(CentralBrightness, double);
  ///@}
  ///@{
  /// The whole light, radiance times kpc^2; 0 (default): from CentralBrightness.
  vtkSetClampMacro(Luminosity, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(Luminosity, double);
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
  double EffectiveRadius = 0.5;
  double SersicIndex = 2;
  double ScaleRadius = 2;
  double Concentration = 10;
  double Truncation = 0;
  double AxisRatios[2] = { 1, 1 };
  int Clusters = 0;
  double ClusterRadius = 0.005;
  double Center[3] = { 0, 0, 0 };
  double CentralBrightness = 1;
  double Luminosity = 0;
  double Color[3] = { 1, 1, 1 };
  double SmoothingLength = 0;
  int RandomSeed = 1;
};

#endif
