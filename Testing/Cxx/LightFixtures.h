#ifndef galaxy_LightFixtures_h
#define galaxy_LightFixtures_h

#include "Filters/Model/IntensityScale.h"
#include "Filters/Model/LightMap.h"
#include "Testing/Cxx/ModelFixtures.h"

namespace galaxy
{
inline const SkyFrame m83Frame(m83Centre, m83Distance);

/// Intensity equal to the image's value, 0 to 1.
inline LayerDescription clippedLayer()
{
  LayerDescription layer;
  layer.image = "picture";
  layer.clips = true;
  return layer;
}

inline SeedLayer layerOf(const SkyImage& image, const LayerDescription& description)
{
  const IntensityScale scale(description, image.values(), "test.galaxy");
  return { &image, [scale](double value, double, double) { return scale(value); },
    description.threshold, description.weight, description.color };
}

/// A square image about M83 of `pixel` arcsec whose values are f(X, Y) of their centres (kpc).
inline SkyImage skyImage(int size, const std::function<double(double, double)>& f, double pixel)
{
  return SkyImage(skyPicture(size, f, pixel), pictureDescription("picture", pixel), m83Frame, 100);
}

/// The map of such an image alone.
inline LightMap lightMap(int size, const std::function<double(double, double)>& f, double pixel,
  const ComponentDescription& component = {})
{
  const SkyImage image = skyImage(size, f, pixel);
  return LightMap({ layerOf(image, clippedLayer()) }, component, 100, "test.galaxy");
}
} // namespace galaxy

#endif
