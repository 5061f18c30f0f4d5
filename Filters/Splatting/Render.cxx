#include "Filters/Splatting/Render.h"

namespace galaxy
{
RenderedImage render(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  switch (options.accuracy)
  {
    case Accuracy::Overlapping:
      return renderOverlapping(particles, camera, options);
    case Accuracy::Sorted:
      break;
  }
  return renderSorted(particles, camera, options);
}
} // namespace galaxy
