/**
 * @class   vtkSpheroidSource
 * @brief   a spheroid of particles
 *
 * A bulge, a globular cluster or a system of them, a halo, an elliptical or a round dwarf galaxy:
 * particles of equal light, distributed about the centre by one of the usual radial laws, the first
 * of them the paper's (Dykes et al., the galactic bulge). A property whose value is out of range is
 * refused by its name, or that of its key in a .galaxy file; there are then no particles.
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
    CORED,       ///< (1 + s^2)^(-Slope/2); 3.9 is that of the Milky Way's globular clusters
  };
  enum Presets
  {
    NONE = 0,
    BULGE,
    STELLAR_HALO,
    DARK_HALO,
    ELLIPTICAL,
    DWARF_SPHEROIDAL,
    DWARF_ELLIPTICAL,
    DWARF_IRREGULAR,
  };
  ///@{
  /// A kind of spheroid, as in a .galaxy file: its radial law with all lengths and numbers, and its
  /// axis ratios. With a preset the properties from Profile to AxisRatios are unused. A DARK_HALO
  /// has no light unless Luminosity is given. Default NONE.
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  ///@}
  ///@{
  /// The radial law of the density. Default Gaussian.
  vtkSetMacro(Profile, int);
  vtkGetMacro(Profile, int);
  ///@}
  ///@{
  /// Standard deviations of the Gaussian along the three axes, kpc. Default 0.3, 0.3, 0.2.
  vtkSetVector3Macro(Sigma, double);
  vtkGetVector3Macro(Sigma, double);
  ///@}
  ///@{
  /// Sersic: the projected radius of half of the light (kpc, default 0.5) and the index n, 0.5 to
  /// 10 (default 2).
  vtkSetMacro(EffectiveRadius, double);
  vtkGetMacro(EffectiveRadius, double);
  vtkSetMacro(SersicIndex, double);
  vtkGetMacro(SersicIndex, double);
  ///@}
  ///@{
  /// The scale of the other laws, kpc. Default 2.
  vtkSetMacro(ScaleRadius, double);
  vtkGetMacro(ScaleRadius, double);
  ///@}
  ///@{
  /// Cored: the exponent of the density's fall outside the core, 3.1 to 20. Default 3.9.
  vtkSetMacro(Slope, double);
  vtkGetMacro(Slope, double);
  ///@}
  ///@{
  /// NFW and Cored end at this many ScaleRadius where there is no Truncation. Default 10.
  vtkSetMacro(Concentration, double);
  vtkGetMacro(Concentration, double);
  ///@}
  ///@{
  /// Where the spheroid ends along its first axis, kpc. 0 (default): 5 Sigma (Gaussian), 20
  /// EffectiveRadius (Sersic), 40 (Hernquist), 15 (Exponential) or 20 (Plummer) ScaleRadius, or as
  /// Concentration says. Luminosity is all that lies within.
  vtkSetMacro(Truncation, double);
  vtkGetMacro(Truncation, double);
  ///@}
  ///@{
  /// The second and third axis relative to the first, above 0 to 1, all but Gaussian.
  vtkSetVector2Macro(AxisRatios, double);
  vtkGetVector2Macro(AxisRatios, double);
  ///@}
  ///@{
  /// How many particles share the light. Default 100000.
  vtkSetMacro(NumberOfParticles, int);
  vtkGetMacro(NumberOfParticles, int);
  ///@}
  ///@{
  /// Whether the axes lie by the two angles below rather than along X, Y and Z. Default false.
  vtkSetMacro(Oriented, bool);
  vtkGetMacro(Oriented, bool);
  vtkBooleanMacro(Oriented, bool);
  ///@}
  ///@{
  /// Of Oriented, degrees: of the first axis, which lies in the sky, North (Y) through East (-X);
  /// and of the plane of the first and the second, -180 to 180, 0 being the sky's. Default 0.
  vtkSetMacro(PositionAngle, double);
  vtkGetMacro(PositionAngle, double);
  vtkSetMacro(Inclination, double);
  vtkGetMacro(Inclination, double);
  ///@}
  ///@{
  /// File of nested ellipsoids: semi_major, axis_ratio_b, axis_ratio_c, position_angle,
  /// inclination, in place of AxisRatios and Oriented. Default none.
  vtkSetFilePathMacro(Shells);
  vtkGetFilePathMacro(Shells);
  ///@}
  ///@{
  /// Star clusters that stand by the radial law and share the particles, each a Plummer sphere of
  /// ClusterRadius (kpc, default 0.005); 0 (default): a smooth body.
  vtkSetMacro(Clusters, int);
  vtkGetMacro(Clusters, int);
  vtkSetMacro(ClusterRadius, double);
  vtkGetMacro(ClusterRadius, double);
  ///@}
  ///@{
  /// File of star clusters, columns x, y, z (kpc about the centre), luminosity (relative) and
  /// radius (kpc), in place of Clusters; it needs Luminosity. Default none.
  vtkSetFilePathMacro(ClusterList);
  vtkGetFilePathMacro(ClusterList);
  ///@}
  ///@{
  /// The centre, kpc.
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}
  ///@{
  /// Radiance in the middle, seen along the third axis; where that is infinite, at EffectiveRadius
  /// (Sersic) or at the radius of half of the mass (Hernquist, NFW). Default 1.
  vtkSetMacro(CentralBrightness, double);
  vtkGetMacro(CentralBrightness, double);
  ///@}
  ///@{
  /// The whole light, radiance times kpc^2; 0 (default): from CentralBrightness.
  vtkSetMacro(Luminosity, double);
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
  ~vtkSpheroidSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSpheroidSource(const vtkSpheroidSource&) = delete;
  void operator=(const vtkSpheroidSource&) = delete;

  int Preset = NONE;
  int Profile = GAUSSIAN;
  double Sigma[3] = { 0.3, 0.3, 0.2 };
  double EffectiveRadius = 0.5;
  double SersicIndex = 2;
  double ScaleRadius = 2;
  double Slope = 3.9;
  double Concentration = 10;
  double Truncation = 0;
  double AxisRatios[2] = { 1, 1 };
  int NumberOfParticles = 100000;
  bool Oriented = false;
  double PositionAngle = 0;
  double Inclination = 0;
  char* Shells = nullptr;
  int Clusters = 0;
  double ClusterRadius = 0.005;
  char* ClusterList = nullptr;
  double Center[3] = { 0, 0, 0 };
  double CentralBrightness = 1;
  double Luminosity = 0;
  double Color[3] = { 1, 1, 1 };
  double SmoothingLength = 0;
  int RandomSeed = 1;
};

#endif
