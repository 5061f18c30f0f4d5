#include "Testing/Cxx/HardCaseFixtures.h"

// How thick discs are drawn: light is where the kernels are, not in their centres.
namespace galaxy
{
namespace
{
/// The variance along an axis of the kernel exp(-9 x^2/h^2) - exp(-9), |x| < h, for h = 1, by
/// quadrature.
double kernelVariance()
{
  double sum = 0, squares = 0;
  for (int k = 0; k < 2000; ++k)
  {
    const double x = (k + 0.5) / 2000, weight = std::exp(-9 * x * x) - std::exp(-9);
    sum += weight;
    squares += weight * x * x;
  }
  return squares / sum;
}

double fade(double x, double y)
{
  return std::exp(-std::hypot(x, y) / 5);
}

/// The rms height of the light over a flat disc of this normal, between two radii.
double drawnHeight(const Particles& particles, const Vec3& n, double inner, double outer)
{
  double light = 0, squares = 0;
  const double ofKernel = kernelVariance();
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const auto [p, h, L] = seenFromEarth(particles, i);
    const double z = dot(p, n), r = std::sqrt(dot(p, p) - z * z);
    if (r >= inner && r < outer)
    {
      light += L;
      squares += L * (z * z + ofKernel * h * h);
    }
  }
  EXPECT_GT(light, 0);
  return std::sqrt(squares / light);
}

struct Case
{
  const char* name;
  ComponentDescription component;
  std::function<double(double r)> rms; ///< of the law, kpc
};

std::vector<Case> cases()
{
  std::vector<Case> all;
  ComponentDescription layer = thickLayer();
  layer.particles = 40000;
  layer.thickness.scaleHeight = 0.15;
  layer.thickness.scaleLength = 1e9;
  for (const auto& [law, unit] :
    { std::pair(LayerLaw::Gaussian, 1.0), { LayerLaw::Sech2, pi / std::sqrt(12) },
      { LayerLaw::Exponential, std::sqrt(2) }, { LayerLaw::Box, 1 / std::sqrt(3) } })
  {
    layer.thickness.law = law;
    all.push_back({ "tapered", layer, [unit](double) { return 0.15 * unit; } });
  }
  layer.thickness.law = LayerLaw::Gaussian;
  layer.thickness.taperThickness = true;
  layer.thickness.scaleLength = 12;
  layer.thickness.scaleHeight = 0.3;
  all.push_back({ "tapering", layer, [](double r) { return 0.3 * std::exp(-r / 12); } });
  layer = thickLayer(ThicknessModel::Gaussian);
  layer.particles = 40000;
  layer.thickness.sigma = 0.12;
  layer.thickness.compression = 1;
  all.push_back({ "Gaussian", layer, [](double) { return 0.12; } });
  layer = thickLayer(ThicknessModel::Flared);
  layer.particles = 40000;
  layer.thickness.sigma = 0.05;
  all.push_back({ "flared", layer,
    [](double r) { return 189 / 200.0 * (0.3 + 0.05 * r) / std::sqrt(8 * std::log(2)); } });
  ComponentDescription dust = thickLayer();
  dust.particles = 25000;
  dust.role = ComponentRole::Absorbs;
  dust.hasDust = true;
  dust.dust.steps = 6;
  all.push_back({ "dust", dust, [](double) { return 0.1; } });
  dust.dust.model = DustModel::Fractal;
  dust.dust.contrast = 0;
  all.push_back({ "clouds", dust, [](double) { return 0.1; } });
  return all;
}
} // namespace

TEST(DrawnLayer, IsAsThickAsItsModelWhateverTheNumberOfParticles)
{
  for (const Case& c : cases())
  {
    for (const auto& [scale, inclination] :
      { std::pair(0.3, 65.0), { 1.0, 0.0 }, { 1.0, 65.0 }, { 4.0, 0.0 } })
    {
      const Galaxy input = galaxyOf(flatDisk(10, inclination, 30), { c.component }, fade);
      BuildOptions options;
      options.particleScale = scale;
      BuildReport report;
      const Particles particles = buildGalaxy(input, options, &report);
      const Vec3 n = TiltedDisk(input.rings, m83Distance).frame(0).n;
      const std::string where = std::string(c.name) + ", scale " + std::to_string(scale) +
        ", inclined by " + std::to_string(inclination) + " degrees, at kpc ";
      for (const double r : { 1.0, 3.0, 5.0, 7.0 })
      {
        EXPECT_NEAR(drawnHeight(particles, n, r - 0.5, r + 0.5) / c.rms(r), 1, 0.05) << where << r;
      }
      // What the report says of its ranges of 1.25 kpc.
      const std::vector<LayerHeight>& heights = report.components[0].layer;
      ASSERT_EQ(heights.size(), 8u);
      for (int k = 0; k < 8; ++k)
      {
        const double r = heights[k].radius;
        EXPECT_NEAR(r, 1.25 * (k + 0.5), 0.4);
        EXPECT_NEAR(
          heights[k].drawn / drawnHeight(particles, n, 1.25 * k, k < 7 ? 1.25 * (k + 1) : 20), 1,
          0.02)
          << where << r;
        EXPECT_NEAR(heights[k].model / c.rms(r), 1, 0.01) << where << r;
      }
    }
  }
}
} // namespace galaxy
