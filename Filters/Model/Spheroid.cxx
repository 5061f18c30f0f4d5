#include "Filters/Model/Spheroid.h"

#include <algorithm>
#include <cstdint>

namespace galaxy
{
void placeSpheroid(const TiltedDisk& disk, const ComponentDescription& component,
  const RandomKey& key, std::size_t count, double lightFactor, const ParticleWriter& writer)
{
  constexpr double twoPi = 6.283185307179586;
  const SpheroidDescription& spheroid = component.spheroid;
  const std::array<double, 3>& sigma = spheroid.sigma;
  const RingFrame ring = disk.frame(0);
  const Vec3 x = sigma[0] * (spheroid.tilted ? ring.a : Vec3{ 1, 0, 0 });
  const Vec3 y = sigma[1] * (spheroid.tilted ? ring.b : Vec3{ 0, 1, 0 });
  const Vec3 z = sigma[2] * (spheroid.tilted ? ring.n : Vec3{ 0, 0, 1 });

  const double largest = *std::max_element(component.color.begin(), component.color.end());
  std::array<std::uint8_t, 3> color{};
  for (int c = 0; c < 3; ++c)
  {
    const double ratio = largest > 0 ? component.color[c] / largest : 0;
    color[c] = static_cast<std::uint8_t>(255 * std::clamp(ratio, 0.0, 1.0) + 0.5);
  }
  const double shown = component.role == ComponentRole::Absorbs ? 1 : largest;
  const double total =
    lightFactor * shown * spheroid.centralBrightness * twoPi * sigma[0] * sigma[1];
  const auto light = static_cast<float>(total / count);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < count; ++i)
  {
    Random random(key, RandomStream::SpheroidPlace, i);
    const auto [u, v] = random.normalPair();
    writer.write(i, u * x + v * y + random.normal() * z, light, color.data(), {});
  }
}
} // namespace galaxy
