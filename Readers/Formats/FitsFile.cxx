#include "Readers/Formats/FitsFile.h"

#include "Readers/Formats/AsinhScale.h"
#include "Readers/Formats/AvailableMemory.h"
#include "Readers/Formats/ClassicLocale.h"
#include "Readers/Formats/FitsBytes.h"
#include "Readers/Formats/FitsCube.h"
#include "Readers/Formats/FitsHandle.h"
#include "Readers/Formats/FitsPixels.h"
#include "Readers/Formats/FitsTiles.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace galaxy
{
namespace
{
const std::string cure = "cut out or bin the image first";

std::string readCards(const FitsHandle& fits)
{
  char* header = nullptr;
  int count = 0;
  int status = 0;
  fits_convert_hdr2str(fits, 0, nullptr, 0, &header, &count, &status);
  if (status != 0)
  {
    // CFITSIO reads some tile-compressed images whose header it fails to translate; the table's
    // own header then serves, which has the same coordinates.
    status = 0;
    std::free(header);
    fits_clear_errmsg();
    fits_hdr2str(fits, 0, nullptr, 0, &header, &count, &status);
  }
  fits.check(status, "header");
  std::string cards(header);
  fits_free_memory(header, &status);
  const std::size_t end = cards.size() / FitsHeader::cardLength;
  if (end > 0 && cards.compare((end - 1) * FitsHeader::cardLength, 8, "END     ") == 0)
  {
    cards.resize((end - 1) * FitsHeader::cardLength);
  }
  return cards;
}

/// What the image's users may want to know of how it was read.
std::string noteOf(const FitsHeader& header)
{
  std::string note =
    AsinhScale::of(header) ? "asinh magnitudes made linear (BSOFTEN, BOFFSET)" : "";
  for (const char* keyword : { "CPDIS1", "CPDIS2", "D2IMDIS1", "D2IMDIS2" })
  {
    if (upperCase(header.text(keyword).value_or("")) == "LOOKUP")
    {
      note += std::string(note.empty() ? "" : "; ") + "distortion table " + keyword + " left out";
    }
  }
  return note;
}

/// The image without its values. Throws Error where they would be too many.
Image emptyImage(const std::string& file, const FitsHdu& hdu, const FitsPlan& plan)
{
  const long long width = hdu.axes[static_cast<std::size_t>(plan.axes[0] - 1)];
  const long long height = hdu.axes[static_cast<std::size_t>(plan.axes[1] - 1)];
  constexpr long long longest = std::numeric_limits<int>::max();
  if (width > longest || height > longest)
  {
    throw Error(
      file, "NAXIS", "an axis is longer than " + std::to_string(longest) + " pixels; " + cure);
  }
  // The values, and the weights of a sum.
  constexpr double bytesPerPixel = 2 * sizeof(double);
  requireMemory(bytesPerPixel * static_cast<double>(width) * static_cast<double>(height), file,
    "NAXIS", "the image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
    cure);
  Image image;
  image.file = file;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.axes = plan.axes;
  image.note = noteOf(hdu.header);
  image.unit = hdu.header.text("BUNIT").value_or("");
  if (!plan.unitSuffix.empty())
  {
    image.unit += (image.unit.empty() ? "" : " ") + plan.unitSuffix;
  }
  return image;
}
} // namespace

Image readFitsImage(
  const std::string& file, const FitsSelection& selection, const Progress& progress)
{
  const ClassicLocale classic;
  try
  {
    constexpr double unpackingShare = 0.5; // where it is gzipped
    FitsBytes bytes(file, partOf(progress, 0, unpackingShare));
    const double unpacked = bytes.unpacked().empty() ? 0 : unpackingShare;
    const FitsHdu hdu = findFitsImage(bytes, selection);
    const FitsPlan plan = planOf(file, hdu, selection);
    Image image = emptyImage(file, hdu, plan);
    FitsHandle fits(bytes);
    fits.moveTo(hdu);
    if (hdu.compressed)
    {
      checkTiles(fits, hdu);
    }
    image.cards = readCards(fits);
    readPixels(fits, hdu, plan, selection.maskValues, partOf(progress, unpacked, 1), image);
    return image;
  }
  catch (const std::bad_alloc&)
  {
    throw Error(file, "NAXIS", "not enough memory for the image; " + cure);
  }
}
} // namespace galaxy
