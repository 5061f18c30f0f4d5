#ifndef galaxy_GalaxyDescription_h
#define galaxy_GalaxyDescription_h

#include "Readers/Formats/FitsFile.h"
#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/SpheroidDescription.h"
#include "Readers/Formats/TextFile.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace galaxy
{
using Color = std::array<double, 3>; ///< red, green, blue; linear light, 1 is full

enum class SpinSense
{
  FromCode,         ///< what the ring table's program means by its angles
  Clockwise,        ///< on the sky, North through West
  CounterClockwise, ///< on the sky, North through East
};
enum class RingInterpolation
{
  LinearAngles, ///< inclination and unwrapped position angle linear in radius
  Slerp,        ///< the normals along great circles
};
enum class BeyondLastRing
{
  Drop,
  HoldLast,
};
enum class IntensityStretch
{
  Linear,
  Sqrt,
  Asinh,
  Density, ///< of photographic plates, the logarithm of light
  Log,
};
enum class ComponentType
{
  Disk,
  Spheroid,
};
enum class ComponentRole
{
  Emits,
  Absorbs,
};
enum class DiskProfile
{
  Images,      ///< brightness from the component's layers
  Exponential, ///< exp(-r / scale_length)
};
enum class SeedSampling
{
  ImageDriven,    ///< in proportion to the light
  SurfaceUniform, ///< the paper's: evenly over the disc's surface, the dark ones culled
};
enum class NormalizeAt
{
  Child, ///< the particles seen on a pixel share its flux
  Seed,  ///< the seeds of a pixel share its flux, children that of their seed
  None,  ///< the paper's rule: a seed has its pixel's intensity, however many share it
};
enum class ThicknessModel
{
  Gaussian,    ///< paper's model 1
  Tapered,     ///< paper's model 2
  Flared,      ///< paper's model 3
  Hydrostatic, ///< vertical equilibrium of gas in the disc's and halo's gravity
  Rings,       ///< the rings' own scale height and law
};
enum class TaperReading
{
  RadialScale, ///< children as exp(-R/H_r), scale height H_z
  Literal,     ///< the paper's formula: children as exp(-R/H_z), scale height H_z too
};
enum class VelocityScaling
{
  Maximum, ///< by the fastest rotation of the disc
  Local,   ///< by the fastest rotation at R and beyond
};
enum class ChildLight
{
  Share,   ///< the children of a seed share its light
  Inherit, ///< every child has the seed's light
};
/// A row of a profile_table.
struct WidthAtRadius
{
  double radius = 0; ///< kpc
  double fwhm = 0;   ///< kpc
};
enum class DustModel
{
  RingVelocity, ///< paper's dust model 1: the seed's velocity, frozen
  DiskRotation, ///< paper's dust model 2: follows the rotation
  Fractal,      ///< a layer of clouds: fractal noise in the disc's own coordinates
};
enum class FractalKind
{
  FBm,    ///< fractional Brownian motion: clouds
  Ridged, ///< 1 - |n| of each octave: a web of thin walls
};
enum class ExtinctionLaw
{
  Custom,   ///< the component's own `absorption`
  CCM89,    ///< Cardelli, Clayton & Mathis 1989, of the Milky Way
  Calzetti, ///< Calzetti et al. 2000, of starbursts
  Grey,
};
enum class DepthCalibration
{
  Given,     ///< optical_depth times intensity, along the line of sight where images give that
  FaceOn,    ///< optical_depth times intensity, across the disc's plane
  PAH8um,    ///< in proportion to an 8 um image, scaled to a mean
  Gas,       ///< from the column density of hydrogen
  Dust250um, ///< from dust emission at 250 um
};
enum class DustGeometry
{
  Sheet, ///< a thin sheet of dust halfway through the light
  Mixed, ///< dust and light mixed evenly
};

enum class BrightnessConversion
{
  None,
  SurfaceBrightness, ///< per arcsec^2
  ColumnDensity,     ///< H I atoms per cm^2
};

/// [image.NAME]: a FITS image of the galaxy, or one that is made of others.
struct ImageDescription
{
  std::string name;
  std::string file; ///< as written; relative to the .galaxy file
  FitsSelection selection;
  bool suppliesCoordinates = false; ///< true where pixel_scale is given
  SuppliedCoordinates coordinates;  ///< in place of the header's WCS
  bool automaticBackground = false; ///< background = "Auto": the sky's level
  double background = 0;            ///< subtracted, in the image's unit
  double maskStarsAbove = std::numeric_limits<double>::infinity(); ///< see mask_stars_above
  std::string mask;    ///< FITS file of bad pixels, relative; empty: none
  std::string regions; ///< DS9 or CASA file of bad regions, relative; empty: none
  double beam = 0;     ///< resolution (FWHM), arcsec; 0: the header's
  std::string unit;    ///< in place of the header's BUNIT; empty: the header's
  BrightnessConversion convert = BrightnessConversion::None; ///< of the values, when read
  std::vector<std::string> combine; ///< images that this is made of, sharpest first; then no file
  /// What counts as signal in the sharper images, in the first one's unit; NaN: "Auto"
  double signalAbove = std::numeric_limits<double>::quiet_NaN();
};

/// One entry of a component's `layers`: an image, how its values become intensities, its colour.
struct LayerDescription
{
  std::string image;
  Color color = { 1, 1, 1 };
  double weight = 1;
  bool clips = false;                    ///< false: from the image's own minimum 0 and maximum
  std::array<double, 2> clip = { 0, 1 }; ///< values that become intensity 0 and 1
  bool clipsByPercentile = false;        ///< in place of clip; never both
  std::array<double, 2> clipPercentile = { 0, 100 }; ///< of the valid pixels
  double threshold = 0;                              ///< I_t: seeds of lower intensity are culled
  IntensityStretch stretch = IntensityStretch::Linear;
};

/// [component.thickness]: kpc and km/s throughout.
struct ThicknessDescription
{
  ThicknessModel model = ThicknessModel::Gaussian;
  LayerLaw law = LayerLaw::Gaussian; ///< vertical law of Tapered, Flared and Hydrostatic
  TaperReading reading = TaperReading::RadialScale; ///< of the paper's model 2 (Tapered)
  ChildLight childLight = ChildLight::Share;
  double children = 1; ///< N_star at intensity 1 (Gaussian) or at R = 0; rounded stochastically
  int maximumChildren = 1000;     ///< cap on N_star; the light is kept
  double sigma = 0.1;             ///< sigma_xyz (Gaussian) or the in-plane sigma_xy (the others)
  double compression = 0.5;       ///< gamma of I_s = I_p^gamma, 0 to 1 (Gaussian)
  double scaleLength = 2.5;       ///< H_r (Tapered); stellar H_r (Hydrostatic)
  double scaleHeight = 0.34;      ///< H_z (Tapered); stellar z0 (Hydrostatic)
  bool taperThickness = false;    ///< sigma_z = H_z exp(-R/H_r) in place of H_z (Tapered)
  double fwhmCentre = 0.3;        ///< F0 (Flared)
  double fwhmEdge = 0.8;          ///< Fb at the stellar edge (Flared)
  double edgeRadius = 10;         ///< Rb, the stellar disc's edge (Flared)
  double flareLength = 17.4;      ///< L of the exponential part (Flared)
  double fwhmMaximum = 4;         ///< cap (Flared)
  double referenceVelocity = 189; ///< v_ref of (v_ref/v_rot)^beta (Flared)
  double velocityExponent = 1;    ///< beta (Flared)
  bool rotationKnown = true;      ///< false where v_rot is but a default: then no scaling (Flared)
  /// What v_rot is (Flared)
  VelocityScaling velocityScaling = VelocityScaling::Maximum;
  /// Widths by increasing radius, in place of all the formula of Flared; empty: none
  std::vector<WidthAtRadius> profileTable;
  std::string profileFile;            ///< that holds them, relative; empty: none
  double gasDispersion = 8;           ///< sigma_g, km/s (Hydrostatic)
  double stellarSurfaceDensity = 500; ///< Sigma_0, Msun/pc^2 at R = 0 (Hydrostatic)
  double gasSurfaceDensity = 10;      ///< Sigma_g, Msun/pc^2 (Hydrostatic)
};

/// [component.dust]: the filament walk, or the clouds.
struct DustDescription
{
  DustModel model = DustModel::DiskRotation;
  int steps = 60;                 ///< particles a filament
  double stepLength = 0.03;       ///< kpc
  double velocityDispersion = 10; ///< sigma_v in the plane, km/s
  double verticalDispersion = 6;  ///< sigma_w, km/s
  double scaleHeight = 0.1;       ///< h_d: rms height, kpc
  double dampingTime = 10;        ///< 1/gamma, Myr
  FractalKind noise = FractalKind::FBm;
  int octaves = 5;
  double lacunarity = 2;   ///< of an octave's scale to the next one's
  double hurst = 0.33;     ///< H: an octave's amplitude is lacunarity^-H of the one before
  double contrast = 1;     ///< s of the weight exp(s g), g the noise, of unit variance
  double noiseScale = 0.5; ///< the largest structure, kpc
  double winding = 0;      ///< shear d theta/d ln r far out; positive: trailing the rotation
  int children = 8;        ///< particles a seed
  double spread = 0.05;    ///< of a seed's children in the plane on each axis, rms, kpc
};

/// How the optical depth of an absorber follows from its image.
struct DepthDescription
{
  DepthCalibration calibration = DepthCalibration::Given;
  double referenceDepth = 1; ///< tau_ref: the mean within referenceRadius (PAH8um)
  double referenceRadius = std::numeric_limits<double>::infinity(); ///< kpc (PAH8um)
  std::string stellarImage;          ///< of 3.6 um, whose light is taken off (PAH8um); empty: none
  std::string molecularImage;        ///< of CO(1-0) or H2, added (Gas); empty: none
  double coToH2 = 2e20;              ///< X_CO: H2 per cm^2 per K km/s (Gas)
  double dustToGas = 1;              ///< in units of the Milky Way's (Gas)
  double dustTemperature = 20;       ///< K (Dust250um)
  double extinctionOver250um = 6500; ///< in V, over the absorption at 250 um (Dust250um)
};

enum class SmoothingModel
{
  Density,    ///< from counts of particles in cells
  Neighbours, ///< from the distance to the k-th nearest
  Constant,
  Brightness, ///< by a particle's light
};

/// [component.smoothing]: h, the radius at which a particle's footprint ends.
struct SmoothingDescription
{
  SmoothingModel model = SmoothingModel::Density;
  double factor = 1.5;       ///< h over the mean distance d (Density, Neighbours)
  int neighbours = 32;       ///< particles that d is taken over (Density, Neighbours)
  double length = 0.1;       ///< kpc: h (Constant), its mean by light (Brightness)
  double exponent = 1.0 / 3; ///< p of h ~ I^p (Brightness)
  double minimum = 0;        ///< kpc
  double maximum = std::numeric_limits<double>::infinity(); ///< kpc
};

/// [[component]]: one population of particles.
struct ComponentDescription
{
  std::string name;
  ComponentType type = ComponentType::Disk;
  ComponentRole role = ComponentRole::Emits;
  long long particles = 100000; ///< seeds N_p of a disk before culling; particles of a spheroid
  bool automaticCount = false;  ///< particles = "Auto": from the image and the noise below
  double noise = 0.1;           ///< of the light in a beam, where the light is; for "Auto"
  SeedSampling sampling = SeedSampling::ImageDriven;
  NormalizeAt normalizeAt = NormalizeAt::Child;
  DiskProfile profile = DiskProfile::Images;
  double scaleLength = 1;                                       ///< of profile = "Exponential", kpc
  double innerRadius = 0;                                       ///< kpc
  double outerRadius = std::numeric_limits<double>::infinity(); ///< kpc; the last ring ends it too
  Color color = { 1, 1, 1 };                                    ///< where no layer gives one
  std::vector<LayerDescription> layers;
  SmoothingDescription smoothing;
  double size = 1;         ///< factor on h when drawn
  double brightness = 1;   ///< factor on emission (or on opacity) when drawn
  double opticalDepth = 1; ///< absorbers: tau in V at intensity 1, see DepthCalibration
  Color absorption = { 0.834, 1.0, 1.319 };              ///< RGB_A: CCM89, R_V = 3.1, bands R, V, B
  ExtinctionLaw extinction = ExtinctionLaw::Custom;      ///< what `absorption` was made from
  double totalToSelective = 0;                           ///< R_V; 0: the law's own
  std::array<double, 3> bands = { 0.641, 0.545, 0.438 }; ///< of red, green and blue, um
  DepthDescription depth;
  std::string deredden; ///< absorbing component whose reddening the image carries; empty: none
  DustGeometry dustGeometry = DustGeometry::Sheet;
  double velocityDispersion = 0; ///< of the particles on every axis, km/s
  ThicknessDescription thickness;
  bool hasDust = false; ///< true where [component.dust] stands: a filament walk, not a thickness
  DustDescription dust;
  SpheroidDescription spheroid;
};

/// Whether images say how bright a component is.
inline bool usesImages(const ComponentDescription& component)
{
  return component.type == ComponentType::Disk && component.profile == DiskProfile::Images;
}

/// The texts of files, by their paths as the file that names them has them.
using NamedTexts = std::map<std::string, std::string>;

/// A whole .galaxy file.
struct GalaxyDescription
{
  std::string file;
  std::string text;  ///< what it was parsed from
  NamedTexts tables; ///< what its tables of widths, clusters and shells were read from
  std::string name;
  SkyPosition centre;
  double distance = 0;     ///< Mpc
  std::string rings;       ///< file, relative to the .galaxy file; empty: the flat disc below
  RingOptions ringOptions; ///< of that file; the distance is the galaxy's
  double inclination = 0;
  double positionAngle = 0;
  double rotationVelocity = 100; ///< km/s
  double radius = 10;            ///< kpc
  SpinSense spin = SpinSense::FromCode;
  RingInterpolation interpolation = RingInterpolation::LinearAngles;
  BeyondLastRing beyondLastRing = BeyondLastRing::Drop;
  bool mock = false; ///< pictures made of it say so
  std::string credit;
  std::vector<ImageDescription> images;
  std::vector<ComponentDescription> components;
};

/// One [[member]] of a .galaxygroup file.
struct GroupMember
{
  std::string galaxy;       ///< .galaxy file, relative to the .galaxygroup file
  double magnification = 1; ///< S_size of this member, times the group's
};

/// A whole .galaxygroup file.
struct GroupDescription
{
  std::string file;
  std::string name;
  double magnification = 1;         ///< S_size: each galaxy about its own centre
  double separation = 1;            ///< S_sep: the positions about the origin galaxy
  std::vector<GroupMember> members; ///< the first is the origin, its sky frame the group's
};

/// Reads a description. An unknown key is an Error that suggests the nearest known one; a value
/// of the wrong type or out of range names its key and line.
GalaxyDescription readGalaxyDescription(const std::string& file);
/// The same from text already in memory; `file` names it in messages and anchors relative paths.
GalaxyDescription parseGalaxyDescription(const std::string& text, const std::string& file);
/// The same with its tables in memory too, as GalaxyDescription has them: no file is looked at.
GalaxyDescription parseGalaxyDescription(
  const std::string& text, const std::string& file, const NamedTexts& tables);
GroupDescription readGroupDescription(const std::string& file);
GroupDescription parseGroupDescription(const std::string& text, const std::string& file);

/// All keys of .galaxy and .galaxygroup files as a Markdown table: section, key, type and unit,
/// default, meaning. Made from the table that the files are read by.
std::string describeKeys();

/// Children a seed where nobody says how many: enough that their number is seen to fall (Tapered),
/// or one.
constexpr double usualChildren(ThicknessModel model)
{
  return model == ThicknessModel::Tapered ? 15 : 1;
}
/// Throws Error (file, component) naming the first key of a thickness whose value is out of range.
void requireInRange(
  const ThicknessDescription& thickness, const std::string& file, const std::string& component);
/// The same for smoothing.
void requireInRange(
  const SmoothingDescription& smoothing, const std::string& file, const std::string& component);
/// The same for dust.
void requireInRange(
  const DustDescription& dust, const std::string& file, const std::string& component);
/// The same for a spheroid.
void requireInRange(
  const SpheroidDescription& spheroid, const std::string& file, const std::string& component);

/// `path` as seen from the folder of `file`, unchanged where absolute.
std::string besideFile(const std::string& file, const std::string& path);

/// The rings of a described galaxy: its ring file, or one flat disc.
RingTable readRings(const GalaxyDescription& galaxy);
} // namespace galaxy

#endif
