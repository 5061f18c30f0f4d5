#include "Readers/Formats/GalaxyKeys.h"
#include "Readers/Formats/NumberRows.h"

#include <climits>

namespace galaxy
{
namespace
{
using D = DustDescription;

const NumberRow<D> numbers[] = {
  { "step_length", &D::stepLength, Range::positive(), "kpc",
    "Distance between the particles of a filament." },
  { "velocity_dispersion", &D::velocityDispersion, Range::notNegative(), "km/s",
    "Random velocity of a filament in the plane." },
  { "vertical_dispersion", &D::verticalDispersion, Range::notNegative(), "km/s",
    "Random velocity of a filament across the plane." },
  { "scale_height", &D::scaleHeight, Range::notNegative(), "kpc", "Root mean square height." },
  { "damping_time", &D::dampingTime, Range::positive(), "Myr",
    "Time in which a random velocity is forgotten." },
  { "lacunarity", &D::lacunarity, Range::from(1, 4), "",
    "Of Fractal: how many times smaller each scale is than the one before." },
  { "hurst", &D::hurst, Range::from(0, 2), "",
    "Of Fractal: H; each scale is weaker than the one before by lacunarity^-H." },
  { "contrast", &D::contrast, Range::from(0, 5), "",
    "Of Fractal: s; the density goes as exp(s g), g the noise of unit variance. With normalize_at "
    "Child, clouds wider than a pixel do not show from Earth: there every pixel has its own "
    "depth." },
  { "noise_scale", &D::noiseScale, Range::from(1e-3, 1e3), "kpc",
    "Of Fractal: size of the largest structure." },
  { "winding", &D::winding, Range::from(-100, 100), "",
    "Of Fractal: shear of the structure; positive trails the rotation, far out with the pitch "
    "angle arctan(1/winding)." },
  { "spread", &D::spread, Range::notNegative(), "kpc",
    "Of Fractal: rms displacement of a seed's particles in the plane, on each axis." },
};

constexpr int mostOctaves = 16;

Keys<D> makeKeys()
{
  Keys<D> keys = {
    choiceKey<D>("model", &D::model, { "RingVelocity", "DiskRotation", "Fractal" },
      "Whether a filament keeps its seed's velocity or follows the rotation; or a layer of fractal "
      "clouds."),
    integerKey<D>("steps", &D::steps, 1, INT_MAX, "Particles a filament."),
    choiceKey<D>(
      "noise", &D::noise, { "FBm", "Ridged" }, "Of Fractal: round clouds, or a web of thin walls."),
    integerKey<D>("octaves", &D::octaves, 1, mostOctaves, "Of Fractal: scales that are summed."),
    integerKey<D>("children", &D::children, 1, INT_MAX, "Of Fractal: particles a seed."),
  };
  for (const NumberRow<D>& row : numbers)
  {
    keys.push_back(row.key());
  }
  return keys;
}
} // namespace

const Keys<D>& dustKeys()
{
  static const Keys<D> keys = makeKeys();
  return keys;
}

void requireInRange(const D& dust, const std::string& file, const std::string& component)
{
  const SectionCheck check(file, component, "dust");
  check.requireNumbers(numbers, dust);
  check.require(dust.steps >= 1, "steps", "at least 1");
  check.require(dust.children >= 1, "children", "at least 1");
  check.require(dust.octaves >= 1 && dust.octaves <= mostOctaves, "octaves",
    "1 to " + std::to_string(mostOctaves));
}
} // namespace galaxy
