#ifndef galaxy_CoordinateCards_h
#define galaxy_CoordinateCards_h

#include "Readers/Formats/FitsHeader.h"

#include <array>
#include <string>
#include <vector>

namespace galaxy
{
/// The celestial coordinates in a header, as cards for WCSLIB. Its parser believes every keyword
/// that it knows, and a legal card of another type, a stray one, or a text without its closing
/// quote can end the program there. So nothing of the header reaches it but what is looked up here:
/// the keywords of the image's two axes, each with a value of its type, written anew.
///
/// The axes are numbered 1 and 2 in what is written; the further ones of a cube stand at their
/// first pixel, and what the matrix adds for them goes into the reference pixel. Distortions are
/// SIP, where both orders are given; TPV, also under the name that early SCAMP gave it on TAN axes,
/// and out of the way where SIP describes it as well (as astropy has it); IRAF's TNX and ZPX; the
/// plate solution of the Digitized Sky Survey, where it is whole. HST's tables (LOOKUP) are left
/// out where the header says that they move no place by more than a pixel.
class CoordinateCards
{
public:
  /// `cards` are the header's (Image::cards), `axes` the FITS axes, from 1, of the image's x and y.
  CoordinateCards(
    const std::string& file, const std::string& cards, const std::array<int, 2>& axes);

  /// The descriptions that name both axes: "", the primary one, and the letters of alternates.
  const std::vector<std::string>& versions() const { return this->described; }

  /// Throws Error where a keyword of the description is no number, or a distortion is not known.
  std::string axesOf(const std::string& version) const;

  /// The plate solution; empty where it is not whole.
  std::string plate() const;

  /// What the header says the image's axes are, for messages: " (FREQ, DEC--TAN)"; empty where it
  /// says nothing.
  std::string types() const;

  const FitsHeader& header() const { return this->all; }

private:
  FitsHeader all;
  std::string file;
  std::array<int, 2> axes;
  std::vector<std::string> described;
};
} // namespace galaxy

#endif
