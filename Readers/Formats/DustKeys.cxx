#include "Readers/Formats/GalaxyKeys.h"

#include <climits>

namespace galaxy
{
const Keys<DustDescription>& dustKeys()
{
  using D = DustDescription;
  static const Keys<D> keys = {
    choiceKey<D>("model", &D::model, { "RingVelocity", "DiskRotation" },
      "Whether a filament keeps its seed's velocity or follows the rotation."),
    integerKey<D>("steps", &D::steps, 1, INT_MAX, "Particles a filament."),
    numberKey<D>("step_length", &D::stepLength, Range::positive(), "kpc",
      "Distance between the particles of a filament."),
    numberKey<D>("velocity_dispersion", &D::velocityDispersion, Range::positive(), "km/s",
      "Random velocity in the plane."),
    numberKey<D>("vertical_dispersion", &D::verticalDispersion, Range::positive(), "km/s",
      "Random velocity across the plane."),
    numberKey<D>(
      "scale_height", &D::scaleHeight, Range::positive(), "kpc", "Root mean square height."),
    numberKey<D>("damping_time", &D::dampingTime, Range::positive(), "Myr",
      "Time in which a random velocity is forgotten."),
  };
  return keys;
}
} // namespace galaxy
