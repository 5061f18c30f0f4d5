#include "vtkSplatProp.h"

#include "Filters/ParticleData.h"
#include "Filters/Splatting/Preview.h"
#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/Tiles.h"
#include "Filters/Splatting/ToneMap.h"
#include "Readers/ReportErrors.h"
#include "vtkSplatSettings.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkSplatProp);

namespace
{
const char* FragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D picture;
void main()
{
  gl_FragData[0] = vec4(texture2D(picture, texCoord).rgb, 1.0);
}
)";

/// The renderer's camera as the engine wants it. The projection matrix carries what a window
/// centre, a tile of a large screenshot or an off-axis eye do to the picture.
galaxy::Camera cameraOf(vtkRenderer* renderer, int width, int height)
{
  vtkCamera* source = renderer->GetActiveCamera();
  const vtkMatrix4x4* view = source->GetModelViewTransformMatrix();
  const vtkMatrix4x4* P =
    source->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  galaxy::Camera camera;
  camera.width = width;
  camera.height = height;
  camera.right = { view->GetElement(0, 0), view->GetElement(0, 1), view->GetElement(0, 2) };
  camera.up = { view->GetElement(1, 0), view->GetElement(1, 1), view->GetElement(1, 2) };
  camera.forward = { -view->GetElement(2, 0), -view->GetElement(2, 1), -view->GetElement(2, 2) };
  const galaxy::Vec3 t{ view->GetElement(0, 3), view->GetElement(1, 3), view->GetElement(2, 3) };
  camera.eye = (-t.x) * camera.right + (-t.y) * camera.up + t.z * camera.forward;
  camera.parallel = source->GetParallelProjection() != 0;
  camera.scale = 0.5 * height * P->GetElement(1, 1);
  const int column = camera.parallel ? 3 : 2;
  const double sign = camera.parallel ? 1 : -1;
  camera.centerX = 0.5 * width * (1 + sign * P->GetElement(0, column));
  camera.centerY = 0.5 * height * (1 + sign * P->GetElement(1, column));
  return camera;
}

bool sameCamera(const galaxy::Camera& p, const galaxy::Camera& q)
{
  const auto same = [](const galaxy::Vec3& a, const galaxy::Vec3& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  };
  return same(p.eye, q.eye) && same(p.right, q.right) && same(p.up, q.up) &&
    same(p.forward, q.forward) && p.parallel == q.parallel && p.scale == q.scale &&
    p.centerX == q.centerX && p.centerY == q.centerY && p.width == q.width && p.height == q.height;
}

/// The depth buffer of the part of the window that the renderer draws, in [0, 1].
std::vector<float> readDepthBuffer(vtkRenderer* renderer, const int size[2], const int origin[2])
{
  std::vector<float> depth(static_cast<std::size_t>(size[0]) * size[1]);
  int viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] == size[0] && viewport[3] == size[1])
  {
    renderer->GetRenderWindow()->GetZbufferData(
      origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1, depth.data());
    return depth;
  }
  // A supersampling pass draws into a larger buffer of its own.
  std::vector<float> large(static_cast<std::size_t>(viewport[2]) * viewport[3]);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(
    viewport[0], viewport[1], viewport[2], viewport[3], GL_DEPTH_COMPONENT, GL_FLOAT, large.data());
  for (int y = 0; y < size[1]; ++y)
  {
    const std::size_t row = static_cast<std::size_t>((y + 0.5) * viewport[3] / size[1]);
    for (int x = 0; x < size[0]; ++x)
    {
      const std::size_t column = static_cast<std::size_t>((x + 0.5) * viewport[2] / size[0]);
      depth[static_cast<std::size_t>(y) * size[0] + x] = large[row * viewport[2] + column];
    }
  }
  return depth;
}

/// From depth-buffer values to kpc from the eye (perspective) or along the axis (parallel);
/// empty where nothing opaque was drawn.
std::vector<float> opaqueDepth(
  vtkRenderer* renderer, const galaxy::Camera& camera, std::vector<float> depth)
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
}

struct vtkSplatProp::Picture
{
  galaxy::Camera camera;
  std::vector<float> opaqueDepth;
  vtkMTimeType inputTime = 0;
  galaxy::Accuracy accuracy = galaxy::Accuracy::Bounded;
  galaxy::ErrorBound allowed;
  double seconds = 0; ///< what it was to take; 0: however long
  galaxy::RenderedImage image;

  /// Whether it serves where the options ask for a picture.
  bool isFor(const galaxy::Camera& other, const std::vector<float>& depth, vtkMTimeType time,
    const galaxy::RenderOptions& options, double seconds) const
  {
    const bool isGood = this->accuracy == options.accuracy &&
      (this->accuracy != galaxy::Accuracy::Bounded ||
        (this->allowed.light <= options.allowed.light &&
          this->allowed.share <= options.allowed.share));
    return isGood && this->seconds == seconds && this->inputTime == time &&
      sameCamera(this->camera, other) && this->opaqueDepth == depth;
  }
};

struct vtkSplatProp::Engine
{
  galaxy::RenderMemory memory;
  galaxy::Preview preview;
  double fullSeconds = 0; ///< what the last picture of all particles took
  double seconds = 0;     ///< what the picture shown was to take; 0: it is of all particles
  bool isAwaited = false; ///< a better one will be asked for
};

struct vtkSplatProp::Canvas
{
  vtkSmartPointer<vtkTextureObject> texture = vtkSmartPointer<vtkTextureObject>::New();
  std::unique_ptr<vtkOpenGLQuadHelper> quad;

  void draw(vtkOpenGLRenderWindow* window, const float* rgb, int width, int height)
  {
    if (!this->quad)
    {
      this->quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, FragmentShader, nullptr);
    }
    else
    {
      window->GetShaderCache()->ReadyShaderProgram(this->quad->Program);
    }
    this->texture->SetContext(window);
    this->texture->Create2DFromRaw(width, height, 3, VTK_FLOAT, const_cast<float*>(rgb));
    this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->texture->Activate();
    this->quad->Program->SetUniformi("picture", this->texture->GetTextureUnit());
    this->quad->Render();
    this->texture->Deactivate();
  }
};

vtkSplatProp::vtkSplatProp()
  : Settings(vtkSmartPointer<vtkSplatSettings>::New())
{
  vtkMath::UninitializeBounds(this->Bounds);
}

vtkSplatProp::~vtkSplatProp() = default;

vtkSplatSettings* vtkSplatProp::GetSettings()
{
  return this->Settings;
}

void vtkSplatProp::SetParticles(vtkPolyData* particles)
{
  if (this->Particles != particles)
  {
    this->Particles = particles;
    this->ParticlesTime.Modified();
    this->Modified();
  }
}

double* vtkSplatProp::GetBounds()
{
  const vtkMTimeType time = this->InputTime();
  if (time != this->BoundsTime)
  {
    this->BoundsTime = time;
    vtkMath::UninitializeBounds(this->Bounds);
    if (this->Particles && this->Particles->GetNumberOfPoints() > 0)
    {
      // With their kernels: a renderer culls what lies outside its frustum, also of a tile.
      this->Particles->GetBounds(this->Bounds);
      const double h = galaxy::largestSmoothingLength(this->Particles, *this->Settings);
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Bounds[2 * axis] -= h;
        this->Bounds[2 * axis + 1] += h;
      }
    }
  }
  return this->Bounds;
}

vtkMTimeType vtkSplatProp::InputTime()
{
  const vtkMTimeType particles = this->Particles ? this->Particles->GetMTime() : 0;
  return std::max({ particles, this->ParticlesTime.GetMTime(), this->Settings->GetMTime() });
}

int vtkSplatProp::RenderOverlay(vtkViewport* viewport)
{
  vtkRenderer* renderer = vtkRenderer::SafeDownCast(viewport);
  auto window = renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow()) : nullptr;
  if (!window || !this->Particles || this->Particles->GetNumberOfPoints() == 0)
  {
    return 0;
  }
  return galaxy::reportErrors(this, [&] {
    this->UpdatePicture(renderer);
    this->DrawPicture(window);
  });
}

void vtkSplatProp::UpdatePicture(vtkRenderer* renderer)
{
  int size[2], origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const galaxy::Camera camera = cameraOf(renderer, std::max(size[0], 1), std::max(size[1], 1));
  std::vector<float> depth = opaqueDepth(renderer, camera, readDepthBuffer(renderer, size, origin));
  const vtkMTimeType time = this->InputTime();
  if (!this->Splatting)
  {
    this->Splatting = std::make_unique<Engine>();
  }
  galaxy::RenderOptions options = galaxy::renderOptions(*this->Settings);
  options.opaqueDepth = depth.empty() ? nullptr : depth.data();
  options.memory = &this->Splatting->memory;
  options.allowed = galaxy::allowedError(
    { this->Exposure, this->Stretch, this->Gamma }, this->Settings->GetTolerance());
  double seconds = this->NextSeconds(options.previewTime);
  if (options.accuracy == galaxy::Accuracy::Preview)
  {
    seconds = options.previewTime;
  }
  if (seconds > 0)
  {
    options.accuracy = galaxy::Accuracy::Preview;
  }
  if (this->LastPicture && this->LastPicture->isFor(camera, depth, time, options, seconds))
  {
    return;
  }
  galaxy::ParticleInput input;
  if (!galaxy::viewParticles(this->Particles, *this->Settings, input))
  {
    throw std::runtime_error(input.problem);
  }
  auto picture = std::make_unique<Picture>();
  const double start = vtkTimerLog::GetUniversalTime();
  if (options.accuracy == galaxy::Accuracy::Preview)
  {
    const vtkMTimeType version =
      std::max(this->Particles->GetMTime(), this->ParticlesTime.GetMTime());
    picture->image = this->Splatting->preview.render(input.view, version, camera, options, seconds);
  }
  else
  {
    picture->image = galaxy::render(input.view, camera, options);
    this->Splatting->fullSeconds = vtkTimerLog::GetUniversalTime() - start;
  }
  picture->camera = camera;
  picture->accuracy = options.accuracy;
  picture->allowed = options.allowed;
  picture->seconds = seconds;
  picture->opaqueDepth = std::move(depth);
  picture->inputTime = time;
  this->ActiveEffects = picture->image.statistics.activeEffects;
  this->RenderStatistics = galaxy::describe(picture->image.statistics);
  this->LastPicture = std::move(picture);
}

double vtkSplatProp::NextSeconds(double shortest)
{
  Engine& engine = *this->Splatting;
  if (this->Interactive && engine.fullSeconds > shortest)
  {
    engine.seconds = shortest;
    engine.isAwaited = this->Refining;
    return engine.seconds;
  }
  // What nobody will better, as a picture that is to be saved, is of all particles.
  engine.seconds = engine.isAwaited ? engine.seconds : 0;
  engine.isAwaited = false;
  return engine.seconds;
}

bool vtkSplatProp::Refine()
{
  if (!this->Splatting || this->Splatting->seconds == 0 || !this->LastPicture)
  {
    return false;
  }
  Engine& engine = *this->Splatting;
  const double next = 4 * engine.seconds;
  const bool isAll = this->LastPicture->image.statistics.sampled >= engine.preview.most();
  engine.seconds = isAll || next > engine.fullSeconds / 2 ? 0 : next;
  engine.isAwaited = true;
  return true;
}

void vtkSplatProp::DrawPicture(vtkOpenGLRenderWindow* window)
{
  const galaxy::RenderedImage& image = this->LastPicture->image;
  std::vector<float> display(image.radiance.size());
  galaxy::applyToneMap({ this->Exposure, this->Stretch, this->Gamma }, image.radiance.data(),
    display.data(), display.size() / 3);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  if (!this->GLCanvas)
  {
    this->GLCanvas = std::make_unique<Canvas>();
  }
  state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  this->GLCanvas->draw(window, image.transmittance.data(), image.width, image.height);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->GLCanvas->draw(window, display.data(), image.width, image.height);
}

void vtkSplatProp::ReleaseGraphicsResources(vtkWindow* window)
{
  this->GLCanvas.reset();
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkSplatProp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "Stretch: " << this->Stretch << "\n";
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Interactive: " << this->Interactive << "\n";
  os << indent << "Refining: " << this->Refining << "\n";
  os << indent << "ActiveEffects: " << this->ActiveEffects << "\n";
  os << indent << "RenderStatistics: " << this->RenderStatistics << "\n";
}
