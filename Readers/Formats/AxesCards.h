#ifndef galaxy_AxesCards_h
#define galaxy_AxesCards_h

#include "Readers/Formats/CardWriter.h"
#include "Readers/Formats/FitsHeader.h"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace galaxy
{
/// The cards of one description of an image's two celestial axes, looked up in a header and written
/// anew with the axes numbered 1 and 2 (see CoordinateCards).
class AxesCards
{
public:
  /// `file` is named in errors; `version` is the description's letter or empty.
  AxesCards(const std::string& file, const FitsHeader& header, const std::array<int, 2>& axes,
    const std::string& version);

  /// Throws Error where a keyword is no number, or a distortion is not known.
  std::string write();

private:
  /// The number and letter of image axis k, from 0.
  std::string named(int k) const;
  /// The keyword of a parameter of the projection.
  std::string parameter(int k, int m) const;
  std::optional<double> numberOf(const std::string& keyword) const;
  void copy(const std::string& from, const std::string& to);

  void writeTypes();
  /// The name of the projection whose parameters the header has.
  std::string knownProjection() const;
  void writeLinearPart();
  void requireKnownDistortions() const;
  bool hasSip() const;
  void writeSip();
  void writeWat();
  void writeParameters();

  const std::string& file;
  const FitsHeader& header;
  const std::array<int, 2> axes;
  const std::string version;
  std::string projection;                          ///< "TAN"; empty where the axes are linear
  int longitude = 0;                               ///< the image axis that it is, from 0
  std::array<std::map<int, double>, 2> parameters; ///< of the projection, by image axis
  CardWriter out;
};

/// "PC", 1 and 2 are "PC1_2".
std::string indexedKeyword(const std::string& root, int i, int j);
} // namespace galaxy

#endif
