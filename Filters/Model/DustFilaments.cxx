#include "Filters/Model/DustFilaments.h"

#include "Filters/Model/SineCosine.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace galaxy
{
namespace
{
constexpr double pc = 1e-3; ///< kpc
/// One pc/(km/s), the unit of time below, in Myr.
constexpr double timeUnit = 0.977792;

/// The step in pc/(km/s) of a filament from where the disc rotates at `rotation` km/s.
double stepTime(const DustDescription& dust, double rotation)
{
  const double sigma = dust.velocityDispersion;
  return dust.stepLength / pc / std::sqrt(rotation * rotation + 2 * sigma * sigma);
}

/// What damping leaves of a velocity over a step, and the kick that makes up for it.
struct Damping
{
  Damping(const DustDescription& dust, double dt)
    : keep(std::exp(-dt * timeUnit / dust.dampingTime))
    , kick(std::sqrt(-std::expm1(-2 * dt * timeUnit / dust.dampingTime)))
  {
  }
  double keep;
  double kick;
};

/// The walk in the plane of the rings: position in polar coordinates of that plane, kpc.
class PlaneWalk
{
public:
  PlaneWalk(const Seeds& seeds, std::size_t i, const TiltedDisk& disk, const DustDescription& dust,
    const RandomKey& key)
    : disk(disk)
    , follows(dust.model == DustModel::DiskRotation)
    , sigma(dust.velocityDispersion)
    , r(seeds.radius[i])
    , direction(sineCosine(seeds.azimuth[i]))
    , rotation(disk.rotationVelocity(this->r))
    , dt(stepTime(dust, this->rotation))
    , damping(dust, this->dt)
    , random(key, RandomStream::FilamentPlane, seeds.index[i])
    , frozenX(-this->rotation * this->direction.sine)
    , frozenY(this->rotation * this->direction.cosine)
  {
    const auto [u, v] = this->random.normalPair();
    this->outward = this->sigma * u;
    this->along = this->sigma * v;
  }

  void step()
  {
    const auto [u, v] = this->random.normalPair();
    this->outward = this->damping.keep * this->outward + this->sigma * this->damping.kick * u;
    this->along = this->damping.keep * this->along + this->sigma * this->damping.kick * v;
    if (this->follows)
    {
      this->stepAround();
    }
    else
    {
      this->stepStraight();
    }
  }

  double radius() const { return this->r; }
  double cosTheta() const { return this->direction.cosine; }
  double sinTheta() const { return this->direction.sine; }
  double time() const { return this->dt; }

private:
  void stepAround()
  {
    const double way = (this->disk.rotationVelocity(this->r) + this->along) * this->dt * pc;
    const auto [s, c] = sineCosine(this->r > 0 ? way / this->r : 0);
    const auto [sine, cosine] = this->direction;
    this->r += this->outward * this->dt * pc;
    // Through the centre a radius comes out on the other side.
    const double side = this->r < 0 ? -1 : 1;
    this->r *= side;
    this->direction = { side * (s * cosine + c * sine), side * (c * cosine - s * sine) };
  }

  void stepStraight()
  {
    const auto [sine, cosine] = this->direction;
    const double x = this->r * cosine + (this->frozenX + this->outward) * this->dt * pc;
    const double y = this->r * sine + (this->frozenY + this->along) * this->dt * pc;
    this->r = std::sqrt(x * x + y * y);
    this->direction = this->r > 0 ? SineCosine{ y / this->r, x / this->r } : SineCosine{ 0, 1 };
  }

  const TiltedDisk& disk;
  bool follows;
  double sigma; ///< km/s
  double r;
  SineCosine direction; ///< of the azimuth
  double rotation;      ///< km/s, at the seed
  double dt;
  Damping damping;
  Random random;
  double frozenX; ///< km/s
  double frozenY;
  double outward = 0; ///< peculiar velocity, km/s; along x for straight filaments
  double along = 0;   ///< along y for straight filaments
};

/// The height over the plane.
class HeightWalk
{
public:
  HeightWalk(const DustDescription& dust, double dt, const RandomKey& key, std::uint32_t index)
    : sigma(dust.scaleHeight > 0 ? dust.verticalDispersion : 0)
    , nu(dust.scaleHeight > 0 ? this->sigma / (dust.scaleHeight / pc) : 0)
    , dt(dt)
    , damping(dust, dt)
    , random(key, RandomStream::FilamentHeight, index)
    , z(dust.scaleHeight * this->random.normal())
    // The scheme conserves w^2/(1 - (nu dt)^2/4) + nu^2 z^2: that is its own equilibrium.
    , w(this->sigma * std::sqrt(1 - 0.25 * this->nu * dt * this->nu * dt) * this->random.normal())
  {
  }

  void step()
  {
    this->pull();
    this->z += 0.5 * this->dt * pc * this->w;
    this->w =
      this->damping.keep * this->w + this->sigma * this->damping.kick * this->random.normal();
    this->z += 0.5 * this->dt * pc * this->w;
    this->pull();
  }

  double height() const { return this->z; } ///< kpc

private:
  // Half a step of -nu^2 z.
  void pull() { this->w -= 0.5 * this->dt * this->nu * this->nu * (this->z / pc); }

  double sigma; ///< km/s
  double nu;    ///< km/s/pc
  double dt;
  Damping damping;
  Random random;
  double z; ///< kpc
  double w; ///< km/s
};

bool inside(const Seeds& seeds, double r)
{
  return r >= seeds.innerRadius && r <= seeds.outerRadius;
}
} // namespace

void requireStableFilaments(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const std::string& file)
{
  const DustDescription& dust = component.dust;
  const double slowest = disk.slowestRotation(seeds.innerRadius, seeds.outerRadius);
  const double longest = stepTime(dust, slowest);
  if (!std::isfinite(longest))
  {
    throw Error(file, component.name,
      "dust: the disc does not rotate everywhere, so velocity_dispersion must be above 0");
  }
  const double nuStep =
    dust.scaleHeight > 0 ? dust.verticalDispersion * longest / (dust.scaleHeight / pc) : 0;
  if (!(nuStep <= 1))
  {
    std::ostringstream message;
    message << "dust: the walk is unstable, nu dt = " << nuStep
            << " where it must not exceed 1; use a "
            << "step_length of at most " << dust.stepLength / nuStep
            << " kpc, or a larger scale_height or velocity_dispersion";
    throw Error(file, component.name, message.str());
  }
}

ParticleStarts countFilaments(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key)
{
  ParticleStarts starts(seeds.size() + 1);
  starts[0] = 0;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    PlaneWalk walk(seeds, i, disk, component.dust, key);
    std::uint64_t particles = 1;
    for (int step = 1; step < component.dust.steps; ++step)
    {
      walk.step();
      if (!inside(seeds, walk.radius()))
      {
        break;
      }
      ++particles;
    }
    starts[i + 1] = particles;
  }
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    starts[i + 1] += starts[i];
  }
  return starts;
}

void placeFilaments(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer)
{
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    PlaneWalk plane(seeds, i, disk, component.dust, key);
    HeightWalk vertical(component.dust, plane.time(), key, seeds.index[i]);
    const auto light =
      static_cast<float>(lightFactor * seeds.light[i] / (starts[i + 1] - starts[i]));
    for (std::uint64_t particle = starts[i]; particle < starts[i + 1]; ++particle)
    {
      if (particle > starts[i])
      {
        plane.step();
        vertical.step();
      }
      const double r = plane.radius();
      const RingFrame ring = disk.frame(r);
      const Vec3 outward = plane.cosTheta() * ring.a + plane.sinTheta() * ring.b;
      const double highest = normalFocalHeight(ring);
      const Vec3 p = r * outward + std::clamp(vertical.height(), -highest, highest) * ring.n;
      writer.write(particle, p, light, &seeds.color[3 * i],
        writer.wantsVelocity() ? ringVelocity(ring, plane.cosTheta(), plane.sinTheta()) : Vec3{});
    }
  }
}
} // namespace galaxy
