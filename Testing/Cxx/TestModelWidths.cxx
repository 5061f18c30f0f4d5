#include "Filters/Model/PixelFill.h"
#include "Filters/Model/VerticalLaw.h"
#include "Testing/Cxx/HardCaseFixtures.h"

// How thick whole models are, from their particles alone.

namespace galaxy
{
namespace
{
/// Where a particle stands over the disc, kpc.
struct Place
{
  double r; ///< of its ring
  double z; ///< along the ring's normal
};

/// The ring of a point below the focus of the normals, by iteration, which halves the error at
/// least.
Place placeOver(const TiltedDisk& disk, const Vec3& p)
{
  Place place = { length(p), 0 };
  for (int k = 0; k < 50; ++k)
  {
    place.z = dot(p, disk.frame(place.r).n);
    place.r = std::sqrt(std::max(0.0, dot(p, p) - place.z * place.z));
  }
  return place;
}

std::vector<Place> placesOf(
  const RingTable& rings, const Particles& particles, std::size_t first = 0)
{
  const TiltedDisk disk(rings, m83Distance);
  std::vector<Place> places;
  for (std::size_t i = first; i < particles.size(); ++i)
  {
    places.push_back(placeOver(disk, seenFromEarth(particles, i).place));
  }
  return places;
}

/// The full width at half maximum of a normal layer, from the half of its heights that lie nearest;
/// relative to `width` at each one's radius.
double widthOver(const std::vector<Place>& places, double inner, double outer,
  const std::function<double(double r)>& width)
{
  std::vector<double> heights;
  for (const Place& place : places)
  {
    if (place.r >= inner && place.r < outer)
    {
      heights.push_back(std::abs(place.z) / width(place.r));
    }
  }
  EXPECT_GT(heights.size(), 4000u) << inner;
  std::nth_element(heights.begin(), heights.begin() + heights.size() / 2, heights.end());
  return heights[heights.size() / 2] / 0.674490 * 2.354820;
}

double flare(double r, double v)
{
  return std::min(4.0, 189 / v * (r <= 10 ? 0.3 + 0.05 * r : 0.8 * std::exp((r - 10) / 17.4)));
}

/// Rings whose normals swing to and fro so quickly that they meet 3.4 kpc above the plane.
RingTable ripples()
{
  RingTable table;
  for (int k = 0; k <= 45; ++k)
  {
    table.rings.push_back(ring(10 * k, 200, 0, k % 2 == 0 ? -2 : 2, 0));
  }
  return table;
}

/// The share, from 0 to 1, of a normal layer of rms height h below z, cut where ripples' normals
/// meet half way.
double cutShare(double z, double h)
{
  const double highest = 0.5 / (4 * degree / (10 * m83Kpc)) / h;
  const double share = std::erf(std::min(std::abs(z) / h, highest) * std::sqrt(0.5)) /
    std::erf(highest * std::sqrt(0.5));
  return 0.5 + std::copysign(0.5 * share, z);
}

std::vector<double> heightsOf(const std::vector<Place>& places)
{
  std::vector<double> heights;
  for (const Place& place : places)
  {
    heights.push_back(place.z);
  }
  return heights;
}
} // namespace

TEST(ModelWidths, AreThoseOfTheModelsAtEveryRadiusAndInclination)
{
  struct Case
  {
    RingTable rings;
    double pixel; ///< arcsec
    double outer; ///< kpc
  };
  for (const Case& c : { Case{ flatDisk(10, 0), 15, 10 }, Case{ flatDisk(10, 45, 30), 15, 10 },
         Case{ flatDisk(10, 65, 120), 15, 10 }, Case{ m83Rings(), 75, 2230 * m83Kpc } })
  {
    for (const ThicknessModel model : { ThicknessModel::Flared, ThicknessModel::Tapered })
    {
      ComponentDescription layer = ofPoints(thickLayer(model));
      layer.particles = 20000;
      layer.thickness.children = 6;
      layer.thickness.scaleLength = 1e9;
      const Particles particles = buildGalaxy(galaxyOf(c.rings, { layer }, evenLight, c.pixel));
      const std::vector<Place> places = placesOf(c.rings, particles);
      const double bins = 4;
      for (double bin = 0; bin < bins; ++bin)
      {
        // Of equal area: about 30000 particles each, and 1.2/sqrt(30000) = 0.7 % were they drawn
        // independently.
        const double inner = c.outer * std::sqrt(bin / bins);
        const double outer = c.outer * std::sqrt((bin + 1) / bins);
        const double ratio = widthOver(places, inner, outer, [&](double r) {
          return model == ThicknessModel::Flared ? flare(r, 200) : 0.3 * 2.354820;
        });
        EXPECT_NEAR(ratio, 1, 0.02) << int(model) << ' ' << c.rings.rings.size() << ' '
                                    << c.rings.rings[0].inclination << ' ' << bin;
      }
    }
  }
}

TEST(ModelWidths, AFlareDoesNotRiseInwardWhereTheRotationFallsToZero)
{
  RingTable fromZero;
  fromZero.rings = { ring(0, 0, 0, 0, 0), ring(100, 180, 0, 0, 0), ring(420, 200, 0, 0, 0) };
  RingTable fromFar;
  fromFar.rings = { ring(60, 160, 0, 0, 0), ring(420, 200, 0, 0, 0) };
  for (const RingTable& rings : { fromZero, fromFar })
  {
    for (const VelocityScaling scaling : { VelocityScaling::Maximum, VelocityScaling::Local })
    {
      ComponentDescription gas = ofPoints(thickLayer(ThicknessModel::Flared));
      gas.particles = 30000;
      gas.profile = DiskProfile::Exponential;
      gas.scaleLength = 0.6;
      gas.outerRadius = 5;
      gas.thickness.velocityScaling = scaling;
      const std::vector<Place> places = placesOf(rings, buildGalaxy(galaxyOf(rings, { gas })));
      for (const double inner : { 0.0, 0.3, 0.6, 1.0, 1.5 })
      {
        const double outer = inner + 0.5;
        EXPECT_NEAR(
          widthOver(places, inner, outer, [](double r) { return flare(r, 200); }), 1, 0.04)
          << inner;
      }
    }
  }
}

TEST(ModelWidths, NoLayerPilesUpWhereTheNormalsMeet)
{
  const RingTable rings = ripples();
  const double h = 1.5;
  ASSERT_LT(std::erf(0.5 / (4 * degree / (10 * m83Kpc)) / h * std::sqrt(0.5)), 0.76);
  const auto expectCut = [&](const Particles& particles, std::size_t first, const char* what) {
    const std::vector<double> heights = heightsOf(placesOf(rings, particles, first));
    EXPECT_GT(heights.size(), 1000u) << what;
    EXPECT_LT(kolmogorov(heights, [&](double z) { return cutShare(z, h); }), 1.95) << what;
  };

  // Seeds drawn evenly leave many pixels out.
  ComponentDescription layer = ofPoints(thickLayer());
  layer.sampling = SeedSampling::SurfaceUniform;
  layer.particles = 9000;
  layer.thickness.children = 1;
  layer.thickness.scaleHeight = h;
  BuildReport report;
  const Particles thick = buildGalaxy(galaxyOf(rings, { layer }, evenLight, 9, 100), {}, &report);
  expectCut(thick, thick.size() - report.components[0].filled, "filled pixels");

  ComponentDescription dust = ofPoints(thickLayer());
  dust.role = ComponentRole::Absorbs;
  dust.hasDust = true;
  dust.dust.steps = 1;
  dust.dust.scaleHeight = h;
  expectCut(buildGalaxy(galaxyOf(rings, { dust })), 0, "dust");
}
} // namespace galaxy
