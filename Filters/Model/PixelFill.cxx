#include "Filters/Model/PixelFill.h"

#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/SheetsInPixel.h"
#include "Filters/Model/VerticalLaw.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace galaxy
{
namespace
{
/// Of the sheets at (x, y) the one whose radius is nearest to r; false where there is none.
bool sheetNear(const DiskInverse& inverse, double x, double y, double r, DiskSheet& sheet)
{
  DiskInverse::Sheets sheets;
  const int found = inverse.find(x, y, sheets);
  const auto* nearest = std::min_element(sheets.data(), sheets.data() + found,
    [r](const DiskSheet& a, const DiskSheet& b) { return std::abs(a.r - r) < std::abs(b.r - r); });
  sheet = found > 0 ? *nearest : sheet;
  return found > 0;
}

/// What chance decides of where a particle is seen.
struct Draw
{
  double u, v;   ///< fractions of the pixel
  double chosen; ///< among sheets
};

/// Where a pixel shows the disc.
struct Seen
{
  PixelPosition at;
  DiskSheet sheet;
  RingFrame ring;
  double scaleHeight; ///< kpc
};

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

  Seen look(std::uint32_t pixel, const Draw& draw, const VerticalLayer& layer) const
  {
    SeenSheets seen;
    std::size_t near = 0;
    findInPixel(this->map, this->inverse, pixel, draw.u, draw.v, near, seen);
    const DiskSheet sheet = seen.byShare(draw.chosen);
    return { seen.at, sheet, this->disk.frame(sheet.r), layer.scaleHeight(sheet.r) };
  }

  /// `height`: in scale heights.
  void fill(std::size_t i, const Seen& seen, double height, const Vec3& motion,
    const ParticleWriter& writer) const
  {
    const PixelPosition at = seen.at;
    DiskSheet sheet = seen.sheet;
    RingFrame ring = seen.ring;
    const double wanted = height * seen.scaleHeight;
    double z = 0;
    if (sheetNear(
          this->inverse, at.x - wanted * ring.n.x, at.y - wanted * ring.n.y, sheet.r, sheet))
    {
      z = wanted;
      ring = this->disk.frame(sheet.r);
    }
    const Vec3 p =
      sheet.r * sheet.cosTheta * ring.a + sheet.r * sheet.sinTheta * ring.b + z * ring.n;
    constexpr std::uint8_t white[3] = { 255, 255, 255 };
    // The normal has turned a little on the way: along the sky the pixel decides.
    writer.write(i, { at.x, at.y, p.z }, this->weight, white,
      ringVelocity(ring, sheet.cosTheta, sheet.sinTheta) + motion);
  }

private:
  const LightMap& map;
  const TiltedDisk& disk;
  const DiskInverse& inverse;
  float weight;
};
} // namespace

void fillPixels(const std::vector<std::uint32_t>& pixels, const LightMap& map,
  const TiltedDisk& disk, const DiskInverse& inverse, const VerticalLayer& layer, double dispersion,
  const RandomKey& key, float weight, const ParticleWriter& writer)
{
  const Filler filler(map, disk, inverse, weight);
  const double agitation = writer.wantsVelocity() ? dispersion : 0;
  const std::size_t batches = (pixels.size() + deviatesAtOnce - 1) / deviatesAtOnce;
  parallelFor<std::size_t>(0, batches, [&](std::size_t batch) {
    const std::size_t first = batch * deviatesAtOnce;
    const std::size_t last = std::min<std::size_t>(pixels.size(), first + deviatesAtOnce);
    writer.advance(last - first); // all are written, for they are weighed at once
    std::array<Seen, deviatesAtOnce> seen;
    std::array<Vec3, deviatesAtOnce> motion;
    Deviates heights{};
    for (std::size_t i = first; i < last; ++i)
    {
      Random random(key, RandomStream::PixelFill, pixels[i]);
      Draw draw;
      draw.u = 0.25 + 0.5 * random.uniform();
      draw.v = 0.25 + 0.5 * random.uniform();
      heights[i - first] = std::clamp(2 * random.uniform() - 1, -1 + 0x1p-31, 1 - 0x1p-31);
      draw.chosen = random.uniform();
      if (agitation > 0)
      {
        motion[i - first] = agitation * random.normalVector();
      }
      Seen& at = seen[i - first];
      at = filler.look(pixels[i], draw, layer);
      heights[i - first] *= shareWithin(layer.law, normalFocalHeight(at.ring) / at.scaleHeight);
    }
    sharesToHeights(layer.law, heights);
    for (std::size_t i = first; i < last; ++i)
    {
      filler.fill(i, seen[i - first], heights[i - first], motion[i - first], writer);
    }
  });
}
} // namespace galaxy
