#include "Filters/Model/Thickness.h"

#include "Filters/Model/ChildLattice.h"
#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/SineCosine.h"
#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace galaxy
{
namespace
{
/// What the children of a seed have in common.
struct Parent
{
  RingFrame ring;
  double r;
  double sine, cosine; ///< of the seed's azimuth
  double sigma;        ///< in the plane, kpc
  double height;       ///< scale height, kpc
  double below;        ///< share of the vertical law below the focus of the normals
  float light;         ///< of each child
  const std::uint8_t* color;
};

/// A place on the disc and the motion of its ring there.
struct Foot
{
  Vec3 place;
  Vec3 normal;
  Vec3 velocity; ///< km/s
};

Foot footOf(const Parent& seed)
{
  const RingFrame& ring = seed.ring;
  return { seed.r * seed.cosine * ring.a + seed.r * seed.sine * ring.b, ring.n,
    ringVelocity(ring, seed.cosine, seed.sine) };
}

/// v, which is perpendicular to n, turned by the shortest way that takes n to m.
Vec3 turned(const Vec3& v, const Vec3& n, const Vec3& m)
{
  const double along = dot(v, m) / (1 + dot(n, m));
  return v - along * (n + m);
}

/// Displaced by the deviates u and v in the plane of the seed's ring.
Foot footBeside(const Parent& seed, double u, double v, const TiltedDisk& disk, std::size_t& near)
{
  const double x = seed.r * seed.cosine + seed.sigma * u;
  const double y = seed.r * seed.sine + seed.sigma * v;
  const double r = std::sqrt(x * x + y * y);
  const RingFrame own = disk.frame(r, near);
  const Vec3 place = turned(x * seed.ring.a + y * seed.ring.b, seed.ring.n, own.n);
  const double perRadius = r > 0 ? 1 / r : 0;
  return { place, own.n, perRadius * (own.rotation * cross(own.n, place) + own.expansion * place) };
}

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
    const auto [sine, cosine] = sineCosine(this->seeds.azimuth[i]);
    const double heirs = this->shares ? this->starts[i + 1] - this->starts[i] : 1;
    parent.r = this->seeds.radius[i];
    parent.sine = sine;
    parent.cosine = cosine;
    parent.ring = this->disk.frame(parent.r);
    parent.sigma = this->profile.inPlaneSigma();
    parent.height = this->profile.scaleHeight(parent.r, parent.ring.rotation);
    parent.below = shareWithin(this->law(), normalFocalHeight(parent.ring) / parent.height);
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
  ChildBatch(LayerLaw law, const TiltedDisk& disk, const ComponentDescription& component,
    const RandomKey& key, const ParticleWriter& writer)
    : law(law)
    , disk(disk)
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
          this->motion[k] = this->dispersion * motion.normalVector();
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
      const Foot foot =
        this->spreads ? footBeside(p, this->u[k], this->v[k], this->disk, this->near) : footOf(p);
      this->writer.write(this->start + k, foot.place + this->z[k] * p.height * foot.normal, p.light,
        p.color, foot.velocity + this->motion[k]);
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

  LayerLaw law;
  const TiltedDisk& disk;
  bool spreads;      ///< in the plane
  double dispersion; ///< km/s
  const RandomKey& key;
  const ParticleWriter& writer;
  int parents = 0;
  int children = 0;
  std::uint64_t start = 0; ///< the first child's particle
  std::size_t near = 0;    ///< see TiltedDisk::frame
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
  parallelFor<std::size_t>(0, seeds.size(), [&](std::size_t i) {
    Random random(key, RandomStream::ChildCount, seeds.index[i]);
    const double mean = profile.meanChildren(seeds.radius[i], seeds.intensity[i]);
    const double rounded = std::floor(std::min(mean, most) + random.uniform());
    starts[i + 1] = static_cast<std::uint64_t>(std::clamp(rounded, 1.0, most));
  });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

void placeChildren(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer)
{
  constexpr std::size_t seedsAtOnce = 1024;
  const ParentMaker parentOf(seeds, starts, disk, component, lightFactor);
  const std::size_t blocks = (seeds.size() + seedsAtOnce - 1) / seedsAtOnce;
  parallelForDynamic<std::size_t>(0, blocks, 1, [&](std::size_t block) {
    ChildBatch batch(parentOf.law(), disk, component, key, writer);
    const std::size_t first = block * seedsAtOnce;
    const std::size_t last = std::min(first + seedsAtOnce, seeds.size());
    if (!writer.advance(starts[last] - starts[first]))
    {
      return;
    }
    for (std::size_t i = first; i < last; ++i)
    {
      batch.add(parentOf, i);
    }
    batch.write();
  });
}
} // namespace galaxy
