#ifndef galaxy_FitsFixtures_h
#define galaxy_FitsFixtures_h

#include "Readers/Formats/FitsFile.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/TemporaryFolder.h"

#include <fitsio.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace galaxy::testing
{
/// A folder of FITS files.
class FitsFolder : public TemporaryFolder
{
protected:
  /// Writes a file through CFITSIO; `fill` does the rest after its creation.
  std::string write(const std::string& name, const std::function<void(fitsfile*, int*)>& fill) const
  {
    fitsfile* file = nullptr;
    int status = 0;
    fits_create_diskfile(&file, this->path(name).c_str(), &status);
    fill(file, &status);
    fits_close_file(file, &status);
    EXPECT_EQ(status, 0) << name;
    return this->path(name);
  }
};

inline constexpr long width = 3, height = 2;

/// An image of these values in HDU order, stored as they are.
inline void addImage(fitsfile* file, int bitpix, std::vector<double> values, int* status,
  std::vector<long> axes = { width, height })
{
  fits_create_img(file, bitpix, static_cast<int>(axes.size()), axes.data(), status);
  fits_write_img(file, TDOUBLE, 1, static_cast<LONGLONG>(values.size()), values.data(), status);
}

inline std::string messageOf(const std::string& file, const galaxy::FitsSelection& selection = {})
{
  return errorOf([&] { galaxy::readFitsImage(file, selection); });
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
} // namespace galaxy::testing

#endif
