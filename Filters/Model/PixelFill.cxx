#include "Filters/Model/PixelFill.h"

#include "Filters/Model/VerticalLaw.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// The nearest sheet of the disc at (x, y); false where there is none.
bool sheetAt(const DiskInverse& inverse, double x, double y, DiskSheet& sheet)
{
  DiskInverse::Sheets sheets;
  const bool found = inverse.find(x, y, sheets) > 0;
  sheet = found ? sheets[0] : sheet;
  return found;
}

/// Places one particle.
class Filler
{
public:
  Filler(const LightMap& map, const TiltedDisk& disk, const DiskInverse& inverse, float weight)
    : map(map)
    , disk(disk)
    , inverse(inverse)
    , weight(weight)
  {
  }

  /// Seen at the fractions (u, v) of the pixel, `height` kpc over the disc.
  void fill(std::size_t i, std::uint32_t pixel, double u, double v,
    const std::function<double(double r)>& heightAt, const ParticleWriter& writer) const
  {
    PixelPosition at = this->map.pointIn(pixel, u, v);
    DiskSheet sheet;
    if (!sheetAt(this->inverse, at.x, at.y, sheet))
    {
      // At the disc's edge: the middle of the pixel does show it.
      at = this->map.pointIn(pixel, 0.5, 0.5);
      sheetAt(this->inverse, at.x, at.y, sheet);
    }
    RingFrame ring = this->disk.frame(sheet.r);
    const double highest = normalFocalHeight(ring);
    const double wanted = std::clamp(heightAt(sheet.r), -highest, highest);
    double z = 0;
    if (sheetAt(this->inverse, at.x - wanted * ring.n.x, at.y - wanted * ring.n.y, sheet))
    {
      z = wanted;
      ring = this->disk.frame(sheet.r);
    }
    const Vec3 p =
      sheet.r * sheet.cosTheta * ring.a + sheet.r * sheet.sinTheta * ring.b + z * ring.n;
    constexpr std::uint8_t white[3] = { 255, 255, 255 };
    // The normal has turned a little on the way: along the sky the pixel decides.
    writer.write(i, { at.x, at.y, p.z }, this->weight, white,
      ringVelocity(ring, sheet.cosTheta, sheet.sinTheta));
  }

private:
  const LightMap& map;
  const TiltedDisk& disk;
  const DiskInverse& inverse;
  float weight;
};
} // namespace

void fillPixels(const std::vector<std::uint32_t>& pixels, const LightMap& map,
  const TiltedDisk& disk, const DiskInverse& inverse, const VerticalLayer& layer,
  const RandomKey& key, float weight, const ParticleWriter& writer)
{
  const Filler filler(map, disk, inverse, weight);
#pragma omp parallel for schedule(static)
  for (std::size_t first = 0; first < pixels.size(); first += deviatesAtOnce)
  {
    const std::size_t last = std::min<std::size_t>(pixels.size(), first + deviatesAtOnce);
    Deviates across{}, along{}, heights{};
    for (std::size_t i = first; i < last; ++i)
    {
      Random random(key, RandomStream::PixelFill, pixels[i]);
      across[i - first] = 0.25 + 0.5 * random.uniform();
      along[i - first] = 0.25 + 0.5 * random.uniform();
      heights[i - first] = std::clamp(2 * random.uniform() - 1, -1 + 0x1p-31, 1 - 0x1p-31);
    }
    sharesToHeights(layer.law, heights);
    for (std::size_t i = first; i < last; ++i)
    {
      const double height = heights[i - first];
      filler.fill(
        i, pixels[i], across[i - first], along[i - first],
        [&](double r) { return height * layer.scaleHeight(r); }, writer);
    }
  }
}
} // namespace galaxy
