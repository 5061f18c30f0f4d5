#include "Filters/Model/DustFilaments.h"

#include "Filters/Model/BelowFocus.h"
#include "Filters/Model/FractalDust.h"
#include "Filters/Model/NormalSequence.h"
#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/SineCosine.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>

namespace galaxy
{
namespace
{
constexpr double pc = 1e-3; ///< kpc
/// One pc/(km/s), the unit of time below, in Myr.
constexpr double timeUnit = 0.977792;
constexpr double largestNormal = NormalSequence<16>::largest;

/// The step in pc/(km/s) of a filament from where the disc rotates at `rotation` km/s.
double stepTime(const DustDescription& dust, double rotation)
{
  const double sigma = dust.velocityDispersion;
  return dust.stepLength / pc / std::sqrt(rotation * rotation + 2 * sigma * sigma);
}

/// What a filament's steps share: what damping leaves of a velocity, and the kick that makes up
/// for it.
struct Step
{
  Step(const DustDescription& dust, double rotation)
    : dt(stepTime(dust, rotation))
    , way(this->dt * pc)
    , keep(std::exp(-this->dt * timeUnit / dust.dampingTime))
    , kick(std::sqrt(-std::expm1(-2 * this->dt * timeUnit / dust.dampingTime)))
  {
  }
  double dt;  ///< pc/(km/s)
  double way; ///< kpc/(km/s)
  double keep;
  double kick;
};

/// The walk in the plane of the rings: position in polar coordinates of that plane, kpc.
class PlaneWalk
{
public:
  PlaneWalk(const Seeds& seeds, std::size_t i, const RingFrame& ring, const Step& step,
    const DustDescription& dust, const RandomKey& key)
    : follows(dust.model == DustModel::DiskRotation)
    , keep(step.keep)
    , kick(dust.velocityDispersion * step.kick)
    , way(step.way)
    , r(seeds.radius[i])
    , direction(sineCosine(seeds.azimuth[i]))
    , random(key, RandomStream::FilamentPlane, seeds.index[i])
    , frozenX(-ring.rotation * this->direction.sine)
    , frozenY(ring.rotation * this->direction.cosine)
  {
    const double u = this->random.next(), v = this->random.next();
    this->outward = dust.velocityDispersion * u;
    this->along = dust.velocityDispersion * v;
  }

  /// `rotation`: of the disc where the walk stands, km/s.
  void step(double rotation)
  {
    const double u = this->random.next(), v = this->random.next();
    this->outward = this->keep * this->outward + this->kick * u;
    this->along = this->keep * this->along + this->kick * v;
    if (this->follows)
    {
      this->stepAround(rotation);
    }
    else
    {
      this->stepStraight();
    }
  }

  double radius() const { return this->r; }
  double cosTheta() const { return this->direction.cosine; }
  double sinTheta() const { return this->direction.sine; }

  /// The peculiar velocity along the ring's a and b, km/s.
  std::array<double, 2> peculiar() const
  {
    if (!this->follows)
    {
      return { this->outward, this->along };
    }
    const auto [sine, cosine] = this->direction;
    return { this->outward * cosine - this->along * sine,
      this->outward * sine + this->along * cosine };
  }

private:
  void stepAround(double rotation)
  {
    const double arc = (rotation + this->along) * this->way;
    // Next to the centre a step goes round and round: where it ends is random in any case.
    const auto [s, c] = sineCosine(this->r > 0 ? std::clamp(arc / this->r, -1e4, 1e4) : 0);
    const auto [sine, cosine] = this->direction;
    this->r += this->outward * this->way;
    // Through the centre a radius comes out on the other side, where inward is outward.
    const double side = this->r < 0 ? -1 : 1;
    this->r *= side;
    this->outward *= side;
    this->along *= side;
    this->direction = { side * (s * cosine + c * sine), side * (c * cosine - s * sine) };
  }

  void stepStraight()
  {
    const auto [sine, cosine] = this->direction;
    const double x = this->r * cosine + (this->frozenX + this->outward) * this->way;
    const double y = this->r * sine + (this->frozenY + this->along) * this->way;
    this->r = std::sqrt(x * x + y * y);
    this->direction = this->r > 0 ? SineCosine{ y / this->r, x / this->r } : SineCosine{ 0, 1 };
  }

  bool follows;
  double keep;
  double kick; ///< km/s
  double way;
  double r;
  SineCosine direction; ///< of the azimuth
  NormalSequence<16> random;
  double frozenX; ///< km/s
  double frozenY;
  double outward = 0; ///< peculiar velocity, km/s; along a for straight filaments
  double along = 0;   ///< along b for straight filaments
};

/// The height over the plane.
class HeightWalk
{
public:
  HeightWalk(
    const DustDescription& dust, const Step& step, const RandomKey& key, std::uint32_t index)
    : sigma(dust.scaleHeight > 0 ? dust.verticalDispersion : 0)
    , nu(dust.scaleHeight > 0 ? this->sigma / (dust.scaleHeight / pc) : 0)
    , halfWay(0.5 * step.way)
    , halfPull(0.5 * step.dt * this->nu * this->nu / pc)
    , keep(step.keep)
    , kick(this->sigma * step.kick)
    , random(key, RandomStream::FilamentHeight, index)
    , z(dust.scaleHeight * this->random.next())
    // The scheme conserves w^2/(1 - (nu dt)^2/4) + nu^2 z^2: that is its own equilibrium.
    , w(this->sigma * std::sqrt(1 - 0.25 * this->nu * step.dt * this->nu * step.dt) *
        this->random.next())
  {
  }

  void step()
  {
    this->w -= this->halfPull * this->z;
    this->z += this->halfWay * this->w;
    this->w = this->keep * this->w + this->kick * this->random.next();
    this->z += this->halfWay * this->w;
    this->w -= this->halfPull * this->z;
  }

  double height() const { return this->z; }   ///< kpc
  double velocity() const { return this->w; } ///< km/s

private:
  double sigma;    ///< km/s
  double nu;       ///< km/s/pc
  double halfWay;  ///< kpc/(km/s)
  double halfPull; ///< of -nu^2 z over half a step, km/s/kpc
  double keep;
  double kick; ///< km/s
  NormalSequence<8> random;
  double z; ///< kpc
  double w; ///< km/s
};

/// The disc's motion and the walk's own.
Vec3 velocityOf(const RingFrame& ring, const PlaneWalk& plane, const HeightWalk& vertical)
{
  const auto [u, v] = plane.peculiar();
  return ringVelocity(ring, plane.cosTheta(), plane.sinTheta()) + u * ring.a + v * ring.b +
    vertical.velocity() * ring.n;
}

bool inside(const Seeds& seeds, double r)
{
  return r >= seeds.innerRadius && r <= seeds.outerRadius;
}

/// Whether no draw of random numbers can carry the filament of seed i over an edge.
bool staysInside(
  const Seeds& seeds, std::size_t i, double rotation, const Step& step, const DustDescription& dust)
{
  double fastest = largestNormal * dust.velocityDispersion;
  double drift = 0;
  for (int n = 1; n < dust.steps; ++n)
  {
    fastest = step.keep * fastest + step.kick * largestNormal * dust.velocityDispersion;
    drift += fastest * step.way;
  }
  const double r = seeds.radius[i];
  const double straight =
    dust.model == DustModel::RingVelocity ? std::abs(rotation) * step.way * (dust.steps - 1) : 0;
  return (seeds.innerRadius == 0 || r - drift >= seeds.innerRadius) &&
    std::sqrt(r * r + straight * straight) + drift <= seeds.outerRadius;
}

/// How many particles the filament of seed i gets.
std::uint64_t filamentLength(const Seeds& seeds, std::size_t i, const TiltedDisk& disk,
  const DustDescription& dust, const RandomKey& key)
{
  const RingFrame ring = disk.frame(seeds.radius[i]);
  const Step step(dust, ring.rotation);
  if (staysInside(seeds, i, ring.rotation, step, dust))
  {
    return dust.steps;
  }
  PlaneWalk walk(seeds, i, ring, step, dust, key);
  std::uint64_t particles = 1;
  for (; particles < static_cast<std::uint64_t>(dust.steps); ++particles)
  {
    walk.step(disk.rotationVelocity(walk.radius()));
    if (!inside(seeds, walk.radius()))
    {
      break;
    }
  }
  return particles;
}
} // namespace

void requireStableFilaments(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const std::string& file)
{
  const DustDescription& dust = component.dust;
  requireInRange(dust, file, component.name);
  if (dust.model == DustModel::Fractal)
  {
    return;
  }
  const double slowest = disk.slowestRotation(seeds.innerRadius, seeds.outerRadius);
  const double longest = stepTime(dust, slowest);
  if (!std::isfinite(longest))
  {
    throw Error(file, component.name,
      "dust: velocity_dispersion must be above 0 where the disc does not rotate");
  }
  const double nuStep =
    dust.scaleHeight > 0 ? dust.verticalDispersion * longest / (dust.scaleHeight / pc) : 0;
  if (!(nuStep <= 1))
  {
    std::ostringstream message;
    message << "dust: the steps are too long for filaments to stay in the layer; use a "
               "step_length of at most "
            << dust.stepLength / nuStep << " kpc, or a larger scale_height or velocity_dispersion";
    throw Error(file, component.name, message.str());
  }
}

ParticleStarts countFilaments(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key)
{
  if (component.dust.model == DustModel::Fractal)
  {
    return countFractalDust(seeds, component);
  }
  ParticleStarts starts(seeds.size() + 1);
  starts[0] = 0;
  parallelFor<std::size_t>(0, seeds.size(),
    [&](std::size_t i) { starts[i + 1] = filamentLength(seeds, i, disk, component.dust, key); });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

void placeFilaments(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer)
{
  if (component.dust.model == DustModel::Fractal)
  {
    placeFractalDust(seeds, starts, disk, component, key, lightFactor, writer);
    return;
  }
  parallelFor<std::size_t>(0, seeds.size(), [&](std::size_t i) {
    if (!writer.advance(starts[i + 1] - starts[i]))
    {
      return;
    }
    RingFrame ring = disk.frame(seeds.radius[i]);
    const Step step(component.dust, ring.rotation);
    PlaneWalk plane(seeds, i, ring, step, component.dust, key);
    HeightWalk vertical(component.dust, step, key, seeds.index[i]);
    const auto light =
      static_cast<float>(lightFactor * seeds.light[i] / (starts[i + 1] - starts[i]));
    for (std::uint64_t particle = starts[i]; particle < starts[i + 1]; ++particle)
    {
      if (particle > starts[i])
      {
        plane.step(ring.rotation);
        vertical.step();
        ring = disk.frame(plane.radius());
      }
      const double x = plane.radius() * plane.cosTheta(), y = plane.radius() * plane.sinTheta();
      const double z = keptBelowFocus(ring, vertical.height(), component.dust.scaleHeight);
      writer.write(particle, x * ring.a + y * ring.b + z * ring.n, light, &seeds.color[3 * i],
        writer.wantsVelocity() ? velocityOf(ring, plane, vertical) : Vec3{});
    }
  });
}
} // namespace galaxy
