#ifndef galaxy_ExponentialSeeds_h
#define galaxy_ExponentialSeeds_h

#include "Filters/Model/Seeds.h"

namespace galaxy
{
/// Seeds of a disc without an image, whose light falls as exp(-r/scale_length) in the disc's own
/// plane: ImageDriven in proportion to it, SurfaceUniform over the warped surface with it as their
/// light. Fills `seeds`, whose number of draws and radii are set, with the draws of the range;
/// their light is kpc^2 times the colour's intensity, 2 pi times the integral of r exp(-r/h) dr in
/// sum. Throws Error (file, component) where nothing of that is left at the inner radius.
void sampleExponential(const TiltedDisk& disk, const ComponentDescription& component,
  const RandomKey& key, const DrawRange& range, const std::string& file, Seeds& seeds);
} // namespace galaxy

#endif
