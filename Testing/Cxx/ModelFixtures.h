#ifndef galaxy_ModelFixtures_h
#define galaxy_ModelFixtures_h

#include "Filters/Model/Particles.h"
#include "Filters/Model/SkyGrid.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"
#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/Vec3.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace galaxy
{
constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180;
/// M83's distance (Mpc), and kpc per arcsec there.
constexpr double m83Distance = 4.90;
constexpr double m83Kpc = 1000 * m83Distance * degree / 3600;

inline Ring ring(double radius, double velocity, double height, double inclination, double angle)
{
  Ring made;
  made.radius = radius;
  made.rotationVelocity = velocity;
  made.scaleHeight = height;
  made.inclination = inclination;
  made.positionAngle = angle;
  return made;
}

/// The rings of M83 printed in the paper, without the last, which lies far outside.
inline RingTable m83Rings()
{
  RingTable table;
  table.file = "m83.txt";
  table.rings = { ring(0, 150, 29.9, 23.7, 227), ring(172, 196, 29.9, 23.7, 227),
    ring(343, 200, 29.9, 24.7, 226), ring(515, 195, 29.9, 34.2, 219),
    ring(686, 192, 29.9, 44.8, 209), ring(858, 190, 29.9, 50.6, 201),
    ring(1030, 189, 29.9, 51.0, 196), ring(1200, 189, 29.9, 50.8, 192),
    ring(1370, 189, 29.9, 50.1, 188), ring(1540, 189, 29.9, 48.9, 188),
    ring(1720, 190, 29.9, 43.3, 188), ring(1890, 189, 29.9, 36.9, 182),
    ring(2060, 189, 29.9, 30.6, 174), ring(2230, 189, 29.9, 24.9, 165) };
  return table;
}

/// A flat disc of the given radius (kpc) at M83's distance.
inline RingTable flatDisk(double radius, double inclination = 0, double angle = 0)
{
  RingTable table;
  table.file = "flat.txt";
  table.rings = { ring(radius / m83Kpc, 200, 10, inclination, angle) };
  return table;
}

constexpr SkyPosition m83Centre = { 204.2504, -29.8678 };

/// A square tangent image about M83 whose pixels hold f(X, Y) of their centres (kpc).
inline Image skyPicture(int size, const std::function<double(double, double)>& f, double pixel)
{
  Image image;
  image.file = "picture.fits";
  image.width = image.height = size;
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const double toKpc = pixel * m83Kpc;
      image.values.push_back(
        f((column - (size - 1) / 2.0) * toKpc, (row - (size - 1) / 2.0) * toKpc));
    }
  }
  return image;
}

/// The description of such an image of `pixel` arcsec.
inline ImageDescription pictureDescription(const std::string& name, double pixel)
{
  ImageDescription description;
  description.name = name;
  description.suppliesCoordinates = true;
  description.coordinates.centre = m83Centre;
  description.coordinates.pixelScale = pixel;
  return description;
}

/// The largest distance between the sample's distribution and `cdf`, times sqrt N: above 1.95 in
/// one of 1000 samples (Kolmogorov).
inline double kolmogorov(std::vector<double> sample, const std::function<double(double)>& cdf)
{
  std::sort(sample.begin(), sample.end());
  double largest = 0;
  const double n = static_cast<double>(sample.size());
  for (std::size_t i = 0; i < sample.size(); ++i)
  {
    const double expected = cdf(sample[i]);
    largest = std::max({ largest, std::abs(expected - i / n), std::abs(expected - (i + 1) / n) });
  }
  return largest * std::sqrt(n);
}

template <typename T>
bool equalBits(const Buffer<T>& p, const Buffer<T>& q)
{
  return p.size() == q.size() && std::equal(p.begin(), p.end(), q.begin());
}

/// A particle as a pinhole camera at the Earth, `distance` Mpc from the galaxy, sees it in the
/// plane of the sky through the galaxy's centre: there it is in X and Y, as large and as bright as
/// it looks. Z is its own.
struct SeenParticle
{
  Vec3 place;
  double smoothingLength;
  double light;
};

inline SeenParticle seenFromEarth(
  const Particles& particles, std::size_t i, double distance = m83Distance)
{
  const float* p = &particles.position[3 * i];
  const double away = 1000 * distance - p[2]; // along the line of sight to the centre
  const double larger = 1000 * distance / away;
  return { { p[0] * larger, p[1] * larger, p[2] }, particles.smoothingLength[i] * larger,
    particles.intensity[i] * larger * larger };
}

/// All of them.
inline Particles allSeenFromEarth(Particles particles, double distance = m83Distance)
{
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const SeenParticle seen = seenFromEarth(particles, i, distance);
    particles.position[3 * i] = static_cast<float>(seen.place.x);
    particles.position[3 * i + 1] = static_cast<float>(seen.place.y);
    particles.smoothingLength[i] = static_cast<float>(seen.smoothingLength);
    particles.intensity[i] = static_cast<float>(seen.light);
  }
  return particles;
}

/// A tangent grid about M83 of `pixel` arcsec, turned by `angle` degrees.
inline SkyGrid tangentGrid(int size, double pixel, double angle, double east = 0)
{
  SuppliedCoordinates supplied;
  supplied.centre = { m83Centre.ra + east / std::cos(m83Centre.dec * degree), m83Centre.dec };
  supplied.pixelScale = pixel;
  supplied.positionAngle = angle;
  SkyGrid grid;
  grid.coordinates = std::make_shared<const WorldCoordinates>(supplied, size, size);
  grid.width = grid.height = size;
  return grid;
}

/// The summed light of an image of `pixel` arcsec, blank pixels left out.
inline double fluxOf(const std::vector<float>& values, double pixel)
{
  double sum = 0;
  for (const float value : values)
  {
    sum += std::isnan(value) ? 0 : value;
  }
  return sum * pixel * pixel;
}
} // namespace galaxy

#endif
