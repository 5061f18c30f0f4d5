#ifndef galaxy_PlaceOnSky_h
#define galaxy_PlaceOnSky_h

#include "Readers/Formats/Galaxy.h"
#include "Readers/Formats/SkyFrame.h"

class vtkImageData;

namespace galaxy
{
/// Lays an image into the plane Z = 0 of the galaxy's frame, kpc, by the linear part of its world
/// coordinates about its middle, so that it is seen behind the rings where it belongs. Left at its
/// pixel coordinates where it has no place on the galaxy's sky.
void placeOnSky(const Image& image, const ImageDescription& description, const SkyFrame& frame,
  vtkImageData* output);
}

#endif
