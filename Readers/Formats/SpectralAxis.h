#ifndef galaxy_SpectralAxis_h
#define galaxy_SpectralAxis_h

#include "Readers/Formats/FitsHdu.h"

#include <array>
#include <string>

namespace galaxy
{
/// The velocities of a cube's channels, km/s.
///
/// VELO*, VRAD and VOPT are velocities, linear in the channel, in the CUNIT's m/s or km/s (m/s
/// where it has none). FREQ becomes a velocity by the radio convention, v = c (1 - nu / nu_0), nu_0
/// the RESTFRQ or RESTFREQ. VOPT-F2W and AIPS's FELO are optical velocities, v = c (nu_0 / nu - 1),
/// of channels linear in frequency (FITS paper III: Greisen et al. 2006, A&A 446, 747).
class SpectralAxis
{
public:
  /// The first spectral axis that is not one of the image's two. Throws Error where there is none,
  /// or it is not linear, has no increment, or no rest frequency.
  SpectralAxis(const std::string& file, const FitsHdu& hdu, const std::array<int, 2>& image);

  std::size_t index() const { return this->axis; } ///< zero-based
  long channels() const { return this->count; }

  /// At a channel counted from 1.
  double velocity(double channel) const;
  /// Between a channel's two edges; positive.
  double width(double channel) const;

private:
  enum class Law
  {
    Velocity,
    RadioOfFrequency,
    OpticalOfFrequency,
  };
  void readLaw(const std::string& file, const FitsHdu& hdu);
  void readScale(const std::string& file, const FitsHdu& hdu);

  std::size_t axis = 0;
  long count = 0;
  Law law = Law::Velocity;
  double reference = 0; ///< CRVAL: km/s, or Hz
  double increment = 0; ///< CDELT: km/s, or Hz
  double pixel = 0;     ///< CRPIX
  double rest = 0;      ///< Hz
};
} // namespace galaxy

#endif
