#include "Filters/Splatting/FootprintShare.h"
#include "Filters/Splatting/OpticalModel.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/Projection.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace galaxy
{
namespace
{
/// A particle on the image plane, in double precision: positions and h in pixels of the image.
struct Disc
{
  double x = 0, y = 0, h = 0, depth = 0;
  double e[3], t[3];
  std::shared_ptr<const NearParticle> near; ///< then x, y and h mean nothing
  Vec3 place;                               ///< to the right, up and into the scene, kpc
  std::size_t particle = 0;
};

Disc discOf(const Projection& projection, std::size_t i)
{
  const Projection::Place place = projection.placeOf(i);
  const ParticleLight light = projection.light(i);
  Disc disc;
  disc.x = place.x;
  disc.y = place.y;
  disc.h = place.h;
  disc.depth = projection.depth(i);
  disc.particle = i;
  disc.place = place.seen;
  if (place.isNear)
  {
    disc.near = std::make_shared<const NearParticle>(projection.near(i));
  }
  // Of a NearParticle, the column is per kpc^2 already.
  const double perArea = place.isNear ? 1 : place.ratio * place.ratio;
  for (int c = 0; c < 3; ++c)
  {
    disc.e[c] = light.L[c] * projection.lightUnit() * perArea;
    disc.t[c] = light.K[c] * projection.depthUnit() * perArea;
  }
  return disc;
}

/// Light and optical depth of the whole image.
struct Sums
{
  std::vector<double> I;
  std::vector<double> tau;
};

/// Calls put(pixel, share) for the pixels that see the disc.
template <class Put>
void forEachPixel(const Disc& disc, const Camera& camera, const RenderOptions& options, Put put)
{
  const bool isNear = disc.near != nullptr;
  const int i0 = isNear ? 0 : static_cast<int>(std::max(0.0, std::floor(disc.x - disc.h) - 1));
  const int j0 = isNear ? 0 : static_cast<int>(std::max(0.0, std::floor(disc.y - disc.h) - 1));
  const double i1 = isNear ? camera.width : std::min<double>(camera.width, disc.x + disc.h + 2);
  const double j1 = isNear ? camera.height : std::min<double>(camera.height, disc.y + disc.h + 2);
  for (int j = j0; j < j1; ++j)
  {
    for (int i = i0; i < i1; ++i)
    {
      const std::size_t pixel = std::size_t(j) * camera.width + i;
      if (options.opaqueDepth && options.opaqueDepth[pixel] < disc.depth)
      {
        continue;
      }
      const double G = isNear ? disc.near->column((i + 0.5 - camera.centerX) / camera.scale,
                                  (j + 0.5 - camera.centerY) / camera.scale)
                              : footprintShare(options.kernel, disc.x, disc.y, disc.h, i, j);
      put(pixel, G);
    }
  }
}

void addDisc(const Disc& disc, std::size_t pixel, double share, Sums& sums)
{
  for (int c = 0; c < 3; ++c)
  {
    double& I = sums.I[3 * pixel + c];
    I = throughSlab(I, disc.e[c] * share, disc.t[c] * share);
    sums.tau[3 * pixel + c] += disc.t[c] * share;
  }
}

RenderedImage pictureOf(const Sums& sums, const Camera& camera, const ParticleCounts& counts)
{
  RenderedImage image = emptyPicture(camera);
  std::transform(sums.I.begin(), sums.I.end(), image.radiance.begin(),
    [&image](double I) { return toSingle(I, image.statistics.tooBright); });
  std::transform(sums.tau.begin(), sums.tau.end(), image.transmittance.begin(),
    [](double tau) { return static_cast<float>(std::exp(-tau)); });
  finishPicture(counts, { 1, 0, 0 }, false, image);
  return image;
}

Sums emptySums(const Camera& camera)
{
  const std::size_t values = 3 * std::size_t(camera.width) * camera.height;
  return { std::vector<double>(values), std::vector<double>(values) };
}

std::vector<Disc> visibleDiscs(
  const ParticleView& particles, const Camera& camera, Kernel kernel, ParticleCounts& counts)
{
  const Projection projection(particles, { camera, kernel });
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < particles.size; ++i)
  {
    if (!projection.classify(i, counts).empty())
    {
      discs.push_back(discOf(projection, i));
    }
  }
  std::sort(discs.begin(), discs.end(), [&projection](const Disc& a, const Disc& b) {
    return a.depth != b.depth ? a.depth > b.depth
                              : projection.isBeforeAtSameDepth(b.particle, a.particle);
  });
  return discs;
}
} // namespace

RenderedImage renderReference(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  ParticleCounts counts;
  Sums sums = emptySums(camera);
  for (const Disc& disc : visibleDiscs(particles, camera, options.kernel, counts))
  {
    forEachPixel(disc, camera, options,
      [&](std::size_t pixel, double share) { addDisc(disc, pixel, share, sums); });
  }
  return pictureOf(sums, camera, counts);
}

RenderedImage renderInOrderOfRays(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  struct Crossing
  {
    double depth;
    const Disc* disc;
    double share;
  };
  ParticleCounts counts;
  const std::vector<Disc> discs = visibleDiscs(particles, camera, options.kernel, counts);
  std::vector<std::vector<Crossing>> crossings(std::size_t(camera.width) * camera.height);
  for (const Disc& disc : discs)
  {
    forEachPixel(disc, camera, options, [&](std::size_t pixel, double share) {
      const double u = (double(pixel % camera.width) + 0.5 - camera.centerX) / camera.scale;
      const double v = (double(pixel / camera.width) + 0.5 - camera.centerY) / camera.scale;
      const Vec3 ray = normalized({ u, v, 1 });
      const double depth = camera.parallel ? disc.depth : dot(disc.place, ray);
      crossings[pixel].push_back({ depth, &disc, share });
    });
  }
  Sums sums = emptySums(camera);
  for (std::size_t pixel = 0; pixel < crossings.size(); ++pixel)
  {
    std::stable_sort(crossings[pixel].begin(), crossings[pixel].end(),
      [](const Crossing& a, const Crossing& b) { return a.depth > b.depth; });
    for (const Crossing& crossing : crossings[pixel])
    {
      addDisc(*crossing.disc, pixel, crossing.share, sums);
    }
  }
  return pictureOf(sums, camera, counts);
}
} // namespace galaxy
