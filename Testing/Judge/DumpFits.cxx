// What the project reads of a FITS image, for an independent judge to compare.
//
// Usage: DumpFits FILE VALUES [EXTENSION]
// Writes the values (float64, rows from the bottom up) to VALUES and prints one line of JSON: the
// size, and the ICRS positions of the four corner pixels and the middle where the image has any; or
// the message with which the file or its coordinates were refused.

#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsFile.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <string>

namespace
{
std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const unsigned char c : text)
  {
    if (c == '"' || c == '\\')
    {
      result += '\\';
    }
    result += c < ' ' || c > '~' ? ' ' : static_cast<char>(c);
  }
  return result + "\"";
}

void printPositions(const galaxy::Image& image)
{
  try
  {
    const galaxy::WorldCoordinates coordinates(
      image.file, image.cards, image.width, image.height, image.axes);
    const double w = image.width, h = image.height;
    const std::array<galaxy::PixelPosition, 5> pixels = { { { 1, 1 }, { w, 1 }, { 1, h }, { w, h },
      { (w + 1) / 2, (h + 1) / 2 } } };
    std::printf(", \"positions\": [");
    for (std::size_t k = 0; k < pixels.size(); ++k)
    {
      galaxy::SkyPosition sky;
      const bool found = coordinates.pixelToSky(pixels[k], sky);
      std::printf(k ? ", " : "");
      found ? std::printf("[%.17g, %.17g]", sky.ra, sky.dec) : std::printf("null");
    }
    std::printf("]");
  }
  catch (const galaxy::Error& error)
  {
    std::printf(", \"no_positions\": %s", quoted(error.what()).c_str());
  }
}
}

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::fprintf(stderr, "usage: DumpFits FILE VALUES [EXTENSION]\n");
    return 2;
  }
  try
  {
    galaxy::FitsSelection selection;
    selection.extension = argc > 3 ? argv[3] : "";
    const galaxy::Image image = galaxy::readFitsImage(argv[1], selection);
    std::ofstream(argv[2], std::ios::binary)
      .write(reinterpret_cast<const char*>(image.values.data()),
        static_cast<std::streamsize>(image.values.size() * sizeof(double)));
    std::printf("{\"width\": %d, \"height\": %d", image.width, image.height);
    printPositions(image);
    std::printf("}\n");
  }
  catch (const galaxy::Error& error)
  {
    std::printf("{\"refused\": %s}\n", quoted(error.what()).c_str());
  }
  return 0;
}
