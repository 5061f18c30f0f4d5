#ifndef galaxy_RendererCamera_h
#define galaxy_RendererCamera_h

#include "Filters/Splatting/Camera.h"

#include <vector>

class vtkRenderer;

namespace galaxy
{
/// The renderer's camera as the engine wants it. The projection matrix carries what a window
/// centre, a tile of a large screenshot or an off-axis eye do to the picture.
Camera cameraOf(vtkRenderer* renderer);

/// Of what has been drawn so far, for every pixel: kpc from the eye (perspective) or along the axis
/// (parallel), infinity where there is nothing; empty where there is nothing at all.
std::vector<float> opaqueDepth(vtkRenderer* renderer, const Camera& camera);

/// The same of what all processes have drawn, to be asked for by all of them when the renderer has
/// ended; on the first one.
std::vector<float> compositedDepth(vtkRenderer* renderer, const Camera& camera);
} // namespace galaxy

#endif
