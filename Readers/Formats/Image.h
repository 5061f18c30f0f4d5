#ifndef galaxy_Image_h
#define galaxy_Image_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace galaxy
{
/// One plane of a FITS image with everything its header says about it.
struct Image
{
  std::string file;
  int width = 0;                      ///< pixels along x
  int height = 0;                     ///< pixels along y
  std::array<int, 2> axes = { 1, 2 }; ///< the FITS axis numbers of x and y, from 1
  std::vector<double> values;         ///< width*height, x fastest; NaN where the image is blank
  std::string unit;                   ///< BUNIT, empty where absent
  std::string note;                   ///< what reading did or left out; empty where nothing
  std::vector<std::uint8_t> bad;      ///< 1 where a pixel is to be replaced; empty where none is
  std::string cards; ///< the header: 80-character cards, one after the other, without END

  /// The value at zero-based pixel (column, row).
  double at(int column, int row) const
  {
    return this->values[static_cast<std::size_t>(row) * this->width + column];
  }
};
} // namespace galaxy

#endif
