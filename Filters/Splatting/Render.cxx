#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/Preview.h"

namespace galaxy
{
RenderedImage render(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  switch (options.accuracy)
  {
    case Accuracy::Overlapping:
      return renderOverlapping(particles, camera, options);
    case Accuracy::Bounded:
      return renderBounded(particles, camera, options);
    case Accuracy::Preview:
      return Preview().render(particles, 0, camera, options, options.previewTime);
    case Accuracy::Sorted:
      break;
  }
  return renderSorted(particles, camera, options);
}
} // namespace galaxy
