#include "Filters/Model/Thickness.h"

#include "Filters/Model/ChildLattice.h"
#include "Filters/Model/SineCosine.h"
#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// What the children of a seed have in common.
struct Parent
{
  Vec3 centre;
  Vec3 alongA; ///< what a deviate of 1 means in the plane, kpc
  Vec3 alongB;
  Vec3 alongN;      ///< scale height times normal, kpc
  double below = 1; ///< share of the vertical law below the focus of the normals
  Vec3 velocity;    ///< km/s
  float light = 0;  ///< of each child
  const std::uint8_t* color = nullptr;
};

/// Seeds turned into parents.
class ParentMaker
{
public:
  ParentMaker(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
    const ComponentDescription& component, double lightFactor)
    : seeds(seeds)
    , starts(starts)
    , disk(disk)
    , profile(component.thickness, disk)
    , shares(component.thickness.childLight == ChildLight::Share)
    , lightFactor(lightFactor)
  {
  }

  struct Children
  {
    std::uint64_t first; ///< particles from this one up to
    std::uint64_t last;  ///< this one
    std::uint32_t draw;  ///< whom the random numbers belong to
  };

  LayerLaw law() const { return this->profile.law(); }

  Children children(std::size_t i) const
  {
    return { this->starts[i], this->starts[i + 1], this->seeds.index[i] };
  }

  void make(std::size_t i, Parent& parent) const
  {
    const double r = this->seeds.radius[i];
    const auto [sine, cosine] = sineCosine(this->seeds.azimuth[i]);
    const RingFrame ring = this->disk.frame(r);
    const double sigma = this->profile.inPlaneSigma();
    const double height = this->profile.scaleHeight(r, ring.rotation);
    const double heirs = this->shares ? this->starts[i + 1] - this->starts[i] : 1;
    parent.centre = r * cosine * ring.a + r * sine * ring.b;
    parent.alongA = sigma * ring.a;
    parent.alongB = sigma * ring.b;
    parent.alongN = height * ring.n;
    parent.below = shareWithin(this->law(), normalFocalHeight(ring) / height);
    parent.velocity = ringVelocity(ring, cosine, sine);
    parent.light = static_cast<float>(this->lightFactor * this->seeds.light[i] / heirs);
    parent.color = &this->seeds.color[3 * i];
  }

private:
  const Seeds& seeds;
  const ParticleStarts& starts;
  const TiltedDisk& disk;
  ThicknessProfile profile;
  bool shares;
  double lightFactor;
};

/// Children of consecutive seeds, made together so that their deviates are computed by vectors. The
/// same numbers come out however the children are dealt to batches.
class ChildBatch
{
public:
  ChildBatch(LayerLaw law, const ComponentDescription& component, const RandomKey& key,
    const ParticleWriter& writer)
    : law(law)
    , spreads(component.thickness.sigma > 0)
    , dispersion(writer.wantsVelocity() ? component.velocityDispersion : 0)
    , key(key)
    , writer(writer)
  {
  }

  /// Adds the children of seed i.
  void add(const ParentMaker& maker, std::size_t i)
  {
    const auto [first, last, draw] = maker.children(i);
    ChildLattice places(this->key, RandomStream::ChildPlace, draw);
    Random motion(this->key, RandomStream::ChildVelocity, draw);
    for (std::uint64_t particle = first; particle < last;)
    {
      this->makeRoom(particle);
      const int owner = this->parents++;
      maker.make(i, this->parent[owner]);
      const double below = this->parent[owner].below;
      for (; particle < last && this->children < deviatesAtOnce; ++particle, ++this->children)
      {
        const int k = this->children;
        const auto [x, y, z] = places.next();
        this->owner[k] = owner;
        this->u[k] = x;
        this->v[k] = y;
        this->z[k] = below * z;
        if (this->dispersion > 0)
        {
          this->motion[k] = this->dispersion * normalVector(motion);
        }
      }
    }
  }

  /// Writes the children that were added.
  void write()
  {
    if (this->spreads)
    {
      sharesToHeights(LayerLaw::Gaussian, this->u);
      sharesToHeights(LayerLaw::Gaussian, this->v);
    }
    sharesToHeights(this->law, this->z);
    for (int k = 0; k < this->children; ++k)
    {
      const Parent& p = this->parent[this->owner[k]];
      this->writer.write(this->start + k,
        p.centre + this->u[k] * p.alongA + this->v[k] * p.alongB + this->z[k] * p.alongN, p.light,
        p.color, p.velocity + this->motion[k]);
    }
    this->children = 0;
    this->parents = 0;
  }

private:
  /// For the child that becomes `particle`.
  void makeRoom(std::uint64_t particle)
  {
    if (this->children == deviatesAtOnce)
    {
      this->write();
    }
    if (this->children == 0)
    {
      this->start = particle;
    }
  }

  static Vec3 normalVector(Random& random)
  {
    const double x = random.normal();
    const double y = random.normal();
    return { x, y, random.normal() };
  }

  LayerLaw law;
  bool spreads;      ///< in the plane
  double dispersion; ///< km/s
  const RandomKey& key;
  const ParticleWriter& writer;
  int parents = 0;
  int children = 0;
  std::uint64_t start = 0; ///< the first child's particle
  std::array<Parent, deviatesAtOnce> parent;
  std::array<int, deviatesAtOnce> owner;
  Deviates u{}, v{}, z{};
  std::array<Vec3, deviatesAtOnce> motion{};
};
} // namespace

ParticleStarts countChildren(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, const std::string& file)
{
  requireInRange(component.thickness, file, component.name);
  const ThicknessProfile profile(component.thickness, disk);
  const double most = component.thickness.maximumChildren;
  ParticleStarts starts(seeds.size() + 1);
  starts[0] = 0;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    Random random(key, RandomStream::ChildCount, seeds.index[i]);
    const double mean = profile.meanChildren(seeds.radius[i], seeds.intensity[i]);
    const double rounded = std::floor(std::min(mean, most) + random.uniform());
    starts[i + 1] = static_cast<std::uint64_t>(std::clamp(rounded, 1.0, most));
  }
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    starts[i + 1] += starts[i];
  }
  return starts;
}

void placeChildren(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer)
{
  constexpr std::size_t seedsAtOnce = 1024;
  const ParentMaker parentOf(seeds, starts, disk, component, lightFactor);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t block = 0; block < seeds.size(); block += seedsAtOnce)
  {
    ChildBatch batch(parentOf.law(), component, key, writer);
    for (std::size_t i = block; i < std::min(block + seedsAtOnce, seeds.size()); ++i)
    {
      batch.add(parentOf, i);
    }
    batch.write();
  }
}
} // namespace galaxy
