#include "RendererCamera.h"

#include "OpenGLFunctions.h"
#include "Readers/Processes.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkIceTCompositePass.h"
#include "vtkImageProcessingPass.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace galaxy
{
namespace
{
/// Whether it draws into the window's own buffer: passes of a view that map its tones or sample it
/// more finely have buffers of their own.
bool drawsIntoWindow(vtkRenderer* renderer)
{
  auto window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return window && static_cast<GLint>(window->GetRenderFramebuffer()->GetFBOIndex()) == bound;
}

/// The depth buffer of the part of the window that the renderer draws, in [0, 1].
std::vector<float> readDepthBuffer(vtkRenderer* renderer)
{
  int size[2], origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  std::vector<float> depth(static_cast<std::size_t>(size[0]) * size[1]);
  if (drawsIntoWindow(renderer))
  {
    renderer->GetRenderWindow()->GetZbufferData(
      origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1, depth.data());
    return depth;
  }
  int viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  std::vector<float> other(static_cast<std::size_t>(viewport[2]) * viewport[3]);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(
    viewport[0], viewport[1], viewport[2], viewport[3], GL_DEPTH_COMPONENT, GL_FLOAT, other.data());
  for (int y = 0; y < size[1]; ++y)
  {
    const std::size_t row = static_cast<std::size_t>((y + 0.5) * viewport[3] / size[1]);
    for (int x = 0; x < size[0]; ++x)
    {
      const std::size_t column = static_cast<std::size_t>((x + 0.5) * viewport[2] / size[0]);
      depth[static_cast<std::size_t>(y) * size[0] + x] = other[row * viewport[2] + column];
    }
  }
  return depth;
}

/// What puts together the pictures of several processes; null where nothing does.
vtkIceTCompositePass* compositePass(vtkRenderer* renderer)
{
  vtkRenderPass* pass = renderer->GetPass();
  while (pass && !vtkIceTCompositePass::SafeDownCast(pass))
  {
    auto camera = vtkCameraPass::SafeDownCast(pass);
    auto image = vtkImageProcessingPass::SafeDownCast(pass);
    pass = camera ? camera->GetDelegatePass() : image ? image->GetDelegatePass() : nullptr;
  }
  return vtkIceTCompositePass::SafeDownCast(pass);
}

/// What it has found to be nearest, on the process that gets the picture; of fewer pixels while a
/// view moves.
std::vector<float> depthOf(vtkIceTCompositePass* compositing, const Camera& camera)
{
  std::vector<float> depth(static_cast<std::size_t>(camera.width) * camera.height, 1.0F);
  vtkSynchronizedRenderers::vtkRawImage picture;
  compositing->GetLastRenderedTile(picture);
  vtkFloatArray* nearest = compositing->GetLastRenderedDepths();
  const int width = picture.GetWidth(), height = picture.GetHeight();
  if (!nearest || nearest->GetNumberOfValues() != vtkIdType(width) * height)
  {
    return depth;
  }
  for (int y = 0; y < camera.height; ++y)
  {
    const int row = static_cast<int>((y + 0.5) * height / camera.height);
    for (int x = 0; x < camera.width; ++x)
    {
      const int column = static_cast<int>((x + 0.5) * width / camera.width);
      depth[static_cast<std::size_t>(y) * camera.width + x] =
        nearest->GetValue(static_cast<vtkIdType>(row) * width + column);
    }
  }
  return depth;
}

/// Of the depths of all processes, on the first one.
void takeNearest(std::vector<float>& depth)
{
  if (numberOfProcesses() > 1)
  {
    std::vector<float> nearest(depth.size());
    vtkMultiProcessController::GetGlobalController()->Reduce(depth.data(), nearest.data(),
      static_cast<vtkIdType>(depth.size()), vtkCommunicator::MIN_OP, 0);
    depth = std::move(nearest);
  }
}

/// As opaqueDepth() says, of a depth buffer's values.
std::vector<float> distances(
  std::vector<float>&& depth, vtkRenderer* renderer, const Camera& camera)
{
  if (std::all_of(depth.begin(), depth.end(), [](float d) { return d >= 1; }))
  {
    return {};
  }
  const vtkMatrix4x4* P = renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1, 1);
  const double p22 = P->GetElement(2, 2), p23 = P->GetElement(2, 3);
  for (int y = 0; y < camera.height; ++y)
  {
    for (int x = 0; x < camera.width; ++x)
    {
      float& d = depth[static_cast<std::size_t>(y) * camera.width + x];
      if (d >= 1)
      {
        d = std::numeric_limits<float>::infinity();
        continue;
      }
      const double ndc = 2.0 * d - 1;
      if (camera.parallel)
      {
        d = static_cast<float>((p23 - ndc) / p22);
        continue;
      }
      const double tx = (x + 0.5 - camera.centerX) / camera.scale;
      const double ty = (y + 0.5 - camera.centerY) / camera.scale;
      d = static_cast<float>(p23 / (ndc + p22) * std::sqrt(1 + tx * tx + ty * ty));
    }
  }
  return depth;
}
} // namespace

Camera cameraOf(vtkRenderer* renderer)
{
  int size[2], origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const int width = std::max(size[0], 1), height = std::max(size[1], 1);
  vtkCamera* source = renderer->GetActiveCamera();
  const vtkMatrix4x4* view = source->GetModelViewTransformMatrix();
  const vtkMatrix4x4* P =
    source->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.right = { view->GetElement(0, 0), view->GetElement(0, 1), view->GetElement(0, 2) };
  camera.up = { view->GetElement(1, 0), view->GetElement(1, 1), view->GetElement(1, 2) };
  camera.forward = { -view->GetElement(2, 0), -view->GetElement(2, 1), -view->GetElement(2, 2) };
  const Vec3 t{ view->GetElement(0, 3), view->GetElement(1, 3), view->GetElement(2, 3) };
  camera.eye = (-t.x) * camera.right + (-t.y) * camera.up + t.z * camera.forward;
  camera.parallel = source->GetParallelProjection() != 0;
  camera.scale = 0.5 * height * P->GetElement(1, 1);
  // One column of the projection moves the whole picture, the other what an eye beside the middle
  // sees: that eye stands aside, or looks aslant where the projection is parallel.
  const int whole = camera.parallel ? 3 : 2, eye = camera.parallel ? 2 : 3;
  const double sign = camera.parallel ? 1 : -1;
  camera.centerX = 0.5 * width * (1 + sign * P->GetElement(0, whole));
  camera.centerY = 0.5 * height * (1 + sign * P->GetElement(1, whole));
  const double x = P->GetElement(0, eye) / P->GetElement(0, 0);
  const double y = P->GetElement(1, eye) / P->GetElement(1, 1);
  if (camera.parallel)
  {
    camera.right = camera.right - x * camera.forward;
    camera.up = camera.up - y * camera.forward;
  }
  else
  {
    camera.eye = camera.eye - x * camera.right - y * camera.up;
  }
  return camera;
}

std::vector<float> opaqueDepth(vtkRenderer* renderer, const Camera& camera)
{
  return distances(readDepthBuffer(renderer), renderer, camera);
}

std::vector<float> compositedDepth(vtkRenderer* renderer, const Camera& camera)
{
  std::vector<float> depth;
  vtkIceTCompositePass* compositing = compositePass(renderer);
  if (compositing && !compositing->GetOrderedCompositingHelper())
  {
    depth = depthOf(compositing, camera);
  }
  else
  {
    depth = readDepthBuffer(renderer);
    takeNearest(depth);
  }
  return distances(std::move(depth), renderer, camera);
}
} // namespace galaxy
