#ifndef galaxy_RingTable_h
#define galaxy_RingTable_h

#include <string>
#include <vector>

namespace galaxy
{
/// The program whose conventions a ring table follows; decides the default spin (physics of 1.3).
enum class RingCode
{
  Plain,
  Rotcur,  ///< GIPSY ROTCUR and its descendants
  Tirific, ///< TiRiFiC and FAT
};

/// The vertical density law that a ring's scale height belongs to (TiRiFiC's LTYPE 1 to 5).
enum class LayerLaw
{
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

/// A tilted-ring model: rings by increasing radius. Equal radii are a step (the later ring holds
/// at and beyond the radius).
struct RingTable
{
  std::string file;
  RingCode code = RingCode::Plain;
  LayerLaw layerLaw = LayerLaw::Sech2;
  std::vector<Ring> rings;
};

/// Reads a tilted-ring model, recognising the format from the content:
///  - plain: columns r vrot Z0 i PA (arcsec, km/s, arcsec, degrees, degrees), `#`/`!` comments;
///  - GIPSY ROTCUR: columns radius, width, vsys, err, vrot, err, vexp, err, PA, err, i, err, ...;
///  - TiRiFiC .def: KEYWORD= values, `#` comments; the first disk.
/// Throws Error naming the file and the line or keyword.
RingTable readRingTable(const std::string& file);
/// The same from text already in memory; `file` only names it in messages.
RingTable parseRingTable(const std::string& text, const std::string& file);
} // namespace galaxy

#endif
