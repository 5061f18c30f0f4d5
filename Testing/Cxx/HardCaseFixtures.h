#ifndef galaxy_HardCaseFixtures_h
#define galaxy_HardCaseFixtures_h

#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/GalaxyBuilder.h"
#include "Readers/Formats/BadPixels.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/LightFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
constexpr double picturePixel = 15; ///< arcsec
constexpr int pictureSide = 60;     ///< pixels: a little more than a disc of 10 kpc at M83
constexpr double pictureKpc = picturePixel * m83Kpc;

inline double evenLight(double, double)
{
  return 0.5;
}

/// A component of one image whose children leave the plane only along its normal.
inline ComponentDescription thickLayer(ThicknessModel model = ThicknessModel::Tapered)
{
  ComponentDescription component;
  component.name = "stars";
  component.particles = 5000;
  component.layers = { clippedLayer() };
  component.thickness.model = model;
  component.thickness.children = 3;
  component.thickness.sigma = 0;
  component.thickness.scaleHeight = 0.3;
  return component;
}

/// Of points, nearly: the heights of the particles are those of the layer.
inline ComponentDescription ofPoints(ComponentDescription component)
{
  component.smoothing.model = SmoothingModel::Constant;
  component.smoothing.length = 1e-4;
  return component;
}

/// A galaxy at M83's place of one image, `picture`.
inline Galaxy galaxyOf(const RingTable& rings, const std::vector<ComponentDescription>& components,
  const std::function<double(double, double)>& f = evenLight, double pixel = picturePixel,
  int side = pictureSide)
{
  Galaxy input;
  input.rings = rings;
  input.images = { skyPicture(side, f, pixel) };
  input.description.file = "hard.galaxy";
  input.description.centre = m83Centre;
  input.description.distance = m83Distance;
  input.description.images = { pictureDescription("picture", pixel) };
  input.description.components = components;
  return input;
}

inline Vec3 positionOf(const Particles& particles, std::size_t i)
{
  const float* p = &particles.position[3 * i];
  return { p[0], p[1], p[2] };
}

inline Vec3 velocityOf(const Particles& particles, std::size_t i)
{
  const float* v = &particles.velocity[3 * i];
  return { v[0], v[1], v[2] };
}

inline BuildOptions withVelocities()
{
  BuildOptions options;
  options.velocities = true;
  return options;
}

/// As it is seen from Earth.
inline double lightOf(const Particles& particles)
{
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    sum += seenFromEarth(particles, i).light;
  }
  return sum;
}

inline void expectFinite(const Particles& particles)
{
  for (const Buffer<float>* values :
    { &particles.position, &particles.smoothingLength, &particles.intensity, &particles.velocity })
  {
    EXPECT_TRUE(std::all_of(
      values->begin(), values->end(), [](float value) { return std::isfinite(value); }));
  }
}

inline std::string messageOf(const Galaxy& input)
{
  return errorOf([&] { buildGalaxy(input); });
}

/// The picture's pixels as the particles show them from Earth, found by the picture's own world
/// coordinates, beside what the picture has.
class EarthView
{
public:
  EarthView(const Galaxy& input, const Particles& particles)
    : image(input.images[0])
    , world(coordinatesOf(image, input.description.images[0]))
    , frame(input.description.centre, input.description.distance)
    , light(image.values.size(), 0)
  {
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      const SeenParticle seen = seenFromEarth(particles, i, input.description.distance);
      PixelPosition at;
      if (this->world.skyToPixel(this->frame.planeToSky(seen.place.x, seen.place.y), at) &&
        at.x >= 0.5 && at.y >= 0.5 && at.x < this->image.width + 0.5 &&
        at.y < this->image.height + 0.5)
      {
        this->light[static_cast<int>(at.y - 0.5) * this->image.width +
          static_cast<int>(at.x - 0.5)] += seen.light;
      }
    }
    this->compare(input.rings, input.description);
  }

  const Image& image;

private:
  WorldCoordinates world;
  SkyFrame frame;

  Vec3 planeAt(double column, double row) const
  {
    SkyPosition sky;
    Vec3 p = { 0, 0, 0 };
    EXPECT_TRUE(this->world.pixelToSky({ column, row }, sky));
    EXPECT_TRUE(this->frame.skyToPlane(sky, p.x, p.y));
    return p;
  }

  void compare(const RingTable& rings, const GalaxyDescription& galaxy)
  {
    const TiltedDisk disk(
      rings, galaxy.distance, galaxy.spin, galaxy.interpolation, galaxy.beyondLastRing);
    const DiskInverse inverse(disk, 0, outerRadiusOf(galaxy.components[0], disk));
    for (std::size_t k = 0; k < this->light.size(); ++k)
    {
      const double column = 1.0 + k % this->image.width, row = 1.0 + k / this->image.width;
      const double value = this->image.values[k];
      const Vec3 centre = this->planeAt(column, row);
      if (value > 0 && inverse.covers(centre.x, centre.y))
      {
        const Vec3 right = this->planeAt(column + 0.5, row) - this->planeAt(column - 0.5, row);
        const Vec3 up = this->planeAt(column, row + 0.5) - this->planeAt(column, row - 0.5);
        const double expected = value * std::abs(cross(right, up).z);
        ++this->covered;
        this->flux += expected;
        this->worst = std::max(this->worst, std::abs(this->light[k] / expected - 1));
      }
    }
  }

public:
  std::vector<double> light; ///< of every pixel
  int covered = 0;           ///< pixels with light that show the disc
  double flux = 0;           ///< of those, by the picture
  double worst = 0;          ///< the largest relative error among those
};

/// Every lit pixel that shows the disc has its flux.
inline void expectPictureKept(const Galaxy& input, const Particles& particles)
{
  const EarthView view(input, particles);
  EXPECT_GT(view.covered, 0);
  EXPECT_LT(view.worst, 2e-4);
}
} // namespace galaxy

#endif
