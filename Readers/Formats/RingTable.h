#ifndef galaxy_RingTable_h
#define galaxy_RingTable_h

#include <map>
#include <string>
#include <vector>

namespace galaxy
{
/// The program whose conventions a ring table follows; decides the default spin (physics of 1.3).
enum class RingCode
{
  Plain,
  Rotcur,  ///< GIPSY ROTCUR, 3DBarolo and DiskFit
  Tirific, ///< TiRiFiC and FAT
};

/// The vertical density law that a ring's scale height belongs to (TiRiFiC's LTYPE 1 to 5).
enum class LayerLaw
{
  FromFile = 0, ///< only as an option: what the file says, or its program's default
  Gaussian = 1,
  Sech2 = 2,
  Exponential = 3,
  Lorentzian = 4,
  Box = 5,
};

/// One ring of a tilted-ring model, in the units that such models are published in.
struct Ring
{
  double radius = 0;            ///< arcsec
  double rotationVelocity = 0;  ///< km/s
  double scaleHeight = 0;       ///< arcsec
  double inclination = 0;       ///< degrees, 0 is face-on
  double positionAngle = 0;     ///< degrees, North through East to the receding major axis
  double surfaceBrightness = 1; ///< the model's own unit; 1 where it has none
  double expansionVelocity = 0; ///< km/s, outward positive
  double systemicVelocity = 0;  ///< km/s
};

/// A column that the geometry has no use for: dispersions, errors, centres, ...
struct RingColumn
{
  std::string name;           ///< as the file has it
  std::string unit;           ///< as the file has it; empty where it tells none
  std::vector<double> values; ///< one a ring, NaN where the file has no number
};

/// A tilted-ring model: rings by increasing radius. Equal radii are a step (the later ring holds
/// at and beyond the radius). Angles are unwrapped: 350 and 10 degrees read as 350 and 370.
struct RingTable
{
  std::string file;
  RingCode code = RingCode::Plain;
  LayerLaw layerLaw = LayerLaw::Sech2;
  std::vector<Ring> rings;
  std::vector<RingColumn> columns;
};

/// Which of two half discs (approaching and receding side) stands for the whole disc.
enum class RingSides
{
  First,  ///< the chosen disk's own values
  Second, ///< those of its other half
  Mean,   ///< the mean of both, ring by ring
};

/// What a file leaves to its user.
struct RingOptions
{
  int disk = 1; ///< of a TiRiFiC file with NDISKS > 1
  RingSides sides = RingSides::First;
  double distance = 0;                    ///< Mpc, for lengths in pc and kpc; 0: unknown
  double pixelScale = 0;                  ///< arcsec, for lengths in pixels; 0: unknown
  LayerLaw layerLaw = LayerLaw::FromFile; ///< in place of the file's
  std::string galaxyName; ///< whose rows of a table with several galaxies; empty: it has one
  /// What the table calls the column of a quantity (r, vrot, Z0, i, PA, SBR, vrad, vsys) or of the
  /// galaxies' names (name), where it is not the usual.
  std::map<std::string, std::string> columns;
};

/// Reads a tilted-ring model, recognising the format from the content:
///  - TiRiFiC and FAT .def: KEYWORD= values, as TirificKeywords reads them. A value list shorter
///    than NUR holds its last value; disk n has the keywords KEYWORD_n. Two disks with AZ1W = 180
///    whose AZ1P differ by 180 degrees are the two sides of one disc, each of which is read as a
///    whole one.
///  - GIPSY ROTCUR and NEMO rotcur: see RingRotcur.cxx;
///  - DiskFit velocity fits (.out): see RingDiskFit.cxx for its warp;
///  - columns named by a heading, in any order, as TextTable reads them: 3DBarolo, CSV, ECSV, IPAC,
///    VizieR, CDS, LaTeX, or text under a comment. Without units lengths are arcsec, velocities
///    km/s and angles degrees. A heading of which a needed column is not understood is refused. Of
///    tables with a column Name or Galaxy, options.galaxyName chooses the rows.
///  - plain: five columns r vrot Z0 i PA.
/// Lengths become arcsec: those in pc and kpc need options.distance, those in pixels
/// options.pixelScale. Throws Error naming the file and the line, keyword or column.
RingTable readRingTable(const std::string& file, const RingOptions& options = {});
/// The same from text already in memory; `file` only names it in messages.
RingTable parseRingTable(
  const std::string& text, const std::string& file, const RingOptions& options = {});
} // namespace galaxy

#endif
