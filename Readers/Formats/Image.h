#ifndef galaxy_Image_h
#define galaxy_Image_h

#include <cstddef>
#include <string>
#include <vector>

namespace galaxy
{
/// One plane of a FITS image with everything its header says about it.
struct Image
{
  std::string file;
  int width = 0;              ///< pixels along FITS axis 1
  int height = 0;             ///< pixels along FITS axis 2
  std::vector<double> values; ///< width*height, axis 1 fastest; NaN where the image is blank
  std::string unit;           ///< BUNIT, empty where absent
  std::string cards;          ///< the header: 80-character cards, one after the other, without END

  /// The value at zero-based pixel (column, row).
  double at(int column, int row) const
  {
    return this->values[static_cast<std::size_t>(row) * this->width + column];
  }
};
} // namespace galaxy

#endif
