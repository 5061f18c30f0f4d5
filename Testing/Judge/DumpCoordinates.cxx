// Where the project puts the pixels of headers, for an independent judge to compare.
//
// Usage: DumpCoordinates < HEADERS
// Of each line, the cards of a header one behind the other, it prints the ICRS positions of 5 x 5
// pixels of an image of 100 x 100 in a line of JSON, null where a pixel is off the sky; or the
// message with which the header was refused.

#include "Readers/Formats/Error.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <cstdio>
#include <iostream>
#include <string>

namespace
{
constexpr int size = 100;

void printPositions(const galaxy::WorldCoordinates& coordinates)
{
  constexpr int points = 5;
  constexpr double step = (size - 1) / (points - 1.0);
  for (int k = 0; k < points * points; ++k)
  {
    galaxy::SkyPosition sky;
    const bool found =
      coordinates.pixelToSky({ 1 + step * (k % points), 1 + step * (k / points) }, sky);
    std::printf(k == 0 ? "[" : ", ");
    found ? std::printf("[%.17g, %.17g]", sky.ra, sky.dec) : std::printf("null");
  }
  std::printf("]\n");
}
}

int main()
{
  for (std::string cards; std::getline(std::cin, cards);)
  {
    try
    {
      printPositions(galaxy::WorldCoordinates("header", cards, size, size));
    }
    catch (const galaxy::Error& error)
    {
      std::printf("\"%s\"\n", error.what());
    }
  }
  return 0;
}
