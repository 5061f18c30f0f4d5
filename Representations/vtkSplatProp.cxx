#include "vtkSplatProp.h"

#include "Filters/ParticleData.h"
#include "Filters/PictureData.h"
#include "OpenGLFunctions.h"
#include "Readers/ReportErrors.h"
#include "RendererCamera.h"
#include "SplatPicture.h"
#include "vtkSplatSettings.h"

#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSplatProp);

namespace
{
const char* FragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D picture;
uniform bool isTransmittance;
void main()
{
  vec3 color = texture2D(picture, texCoord).rgb;
  gl_FragData[0] = vec4(color, isTransmittance ? 1.0 - (color.r + color.g + color.b) / 3.0 : 1.0);
  gl_FragDepth = 0.999999;
}
)";

/// Makes the window's context the current one again, with the framebuffer that is drawn into: a
/// widget's window binds its own where it is made current.
void returnTo(vtkOpenGLRenderWindow* window)
{
  if (!window->IsCurrent())
  {
    vtkOpenGLState* state = window->GetState();
    state->PushFramebufferBindings();
    window->MakeCurrent();
    state->ResetFramebufferBindings();
    state->PopFramebufferBindings();
  }
}
}

struct vtkSplatProp::Canvas
{
  vtkSmartPointer<vtkTextureObject> texture = vtkSmartPointer<vtkTextureObject>::New();
  std::unique_ptr<vtkOpenGLQuadHelper> quad;

  void draw(
    vtkOpenGLRenderWindow* window, const float* rgb, int width, int height, bool isTransmittance)
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
    this->quad->Program->SetUniformi("isTransmittance", isTransmittance);
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
    // With their kernels: a renderer culls what lies outside its frustum, also of a tile.
    galaxy::boundsOfKernels(this->Particles, *this->Settings, this->Bounds);
  }
  return this->Bounds;
}

vtkMTimeType vtkSplatProp::InputTime()
{
  const vtkMTimeType particles = this->Particles ? this->Particles->GetMTime() : 0;
  return std::max({ particles, this->ParticlesTime.GetMTime(), this->Settings->GetMTime() });
}

std::vector<vtkSplatProp*> vtkSplatProp::DrawnTogether(vtkRenderer* renderer)
{
  std::vector<vtkSplatProp*> props;
  vtkPropCollection* all = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  all->InitTraversal(at);
  while (vtkProp* prop = all->GetNextProp(at))
  {
    auto splats = vtkSplatProp::SafeDownCast(prop);
    // What the renderer has culled is not asked to draw, and has no time to.
    const bool isAsked = splats && splats->GetVisibility() && splats->GetRenderTimeMultiplier() > 0;
    if (isAsked && splats->Particles && splats->Particles->GetNumberOfPoints() > 0)
    {
      props.push_back(splats);
    }
  }
  return props;
}

int vtkSplatProp::RenderOverlay(vtkViewport* viewport)
{
  vtkRenderer* renderer = vtkRenderer::SafeDownCast(viewport);
  auto window = renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetVTKWindow()) : nullptr;
  // A selector tells by their colours what it has drawn.
  if (!window || renderer->GetSelector())
  {
    return 0;
  }
  const std::vector<vtkSplatProp*> props = this->DrawnTogether(renderer);
  if (props.empty() || props.front() != this)
  {
    this->Picture.reset();
    return 0;
  }
  return galaxy::reportErrors(this, [&] {
    this->UpdatePicture(renderer, props);
    this->HintAtPlaces(props);
    returnTo(window);
    this->DrawPicture(window);
  });
}

void vtkSplatProp::UpdatePicture(vtkRenderer* renderer, const std::vector<vtkSplatProp*>& props)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  galaxy::SplatRequest request;
  request.camera = galaxy::cameraOf(renderer);
  request.opaqueDepth = galaxy::opaqueDepth(renderer, request.camera);
  request.toneMap = this->GetToneMap();
  std::vector<galaxy::SplatPart> parts;
  for (vtkSplatProp* prop : props)
  {
    parts.push_back(
      { prop->Particles, prop->Settings, prop->Exposure, prop->ParticlesTime.GetMTime() });
    request.isMoving |= prop->Interactive;
    request.isRefined |= prop->Refining;
  }
  // What is to be saved is not shown: nobody would see it bettered.
  request.isRefined = request.isRefined && window->GetSwapBuffers() != 0;
  this->Aborted = false;
  request.progress = [this](double fraction) { return this->ReportProgress(fraction); };
  request.hasToWait = [window] { return window->CheckAbortStatus() != 0; };
  if (!this->Picture)
  {
    this->Picture = std::make_unique<galaxy::SplatPicture>();
  }
  this->Picture->update(parts, std::move(request));
  // What was drawn until now is to be seen all the same, whatever observers drew elsewhere.
  window->SetAbortRender(0);
  const galaxy::RenderStatistics& statistics = this->Picture->image().statistics;
  for (vtkSplatProp* prop : props)
  {
    prop->ActiveEffects = galaxy::activeEffects(statistics);
    prop->RenderStatistics =
      (this->Picture->isAborted() ? "aborted; " : "") + galaxy::describe(statistics);
  }
}

void vtkSplatProp::HintAtPlaces(const std::vector<vtkSplatProp*>& props)
{
  std::vector<vtkDataObject*> together;
  for (vtkSplatProp* prop : props)
  {
    together.push_back(prop->Particles);
  }
  const std::string hint = galaxy::placesHint(together);
  if (hint.empty())
  {
    return;
  }
  for (vtkSplatProp* prop : props)
  {
    prop->ActiveEffects += "; " + hint;
  }
  if (hint != this->PlacesHint)
  {
    this->PlacesHint = hint;
    vtkWarningMacro(<< hint);
  }
}

bool vtkSplatProp::ReportProgress(double fraction)
{
  this->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
  return !this->Aborted;
}

bool vtkSplatProp::Refine()
{
  return this->Picture && this->Picture->refine();
}

galaxy::ToneMap vtkSplatProp::GetToneMap() const
{
  galaxy::ToneMap map{ this->Exposure, this->Stretch, this->Gamma };
  for (int c = 0; c < 3; ++c)
  {
    if (!(this->WhitePoint[c] > this->BlackPoint[c]))
    {
      throw std::runtime_error("WhitePoint must be above BlackPoint in every channel");
    }
    map.black[c] = this->BlackPoint[c];
    map.white[c] = this->WhitePoint[c];
  }
  return map;
}

void vtkSplatProp::DrawPicture(vtkOpenGLRenderWindow* window)
{
  const galaxy::RenderedImage& image = this->Picture->image();
  std::vector<float> display(image.radiance.size());
  galaxy::applyToneMap(
    this->GetToneMap(), image.radiance.data(), display.data(), display.size() / 3);

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
  // Processes' pictures get their background afterwards, by their alpha.
  const bool isLayer = this->Composited;
  state->vtkglBlendFuncSeparate(
    GL_ZERO, GL_SRC_COLOR, isLayer ? GL_ONE : GL_ZERO, isLayer ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
  this->GLCanvas->draw(window, image.transmittance.data(), image.width, image.height, true);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, isLayer ? GL_ZERO : GL_ONE, GL_ONE);
  this->GLCanvas->draw(window, display.data(), image.width, image.height, false);
  if (isLayer)
  {
    // Only where nothing is: what is nearer keeps its depth.
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglDepthFunc(GL_LESS);
    this->GLCanvas->draw(window, display.data(), image.width, image.height, false);
  }
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
  const auto print = [&](const char* name, const double* rgb) {
    os << indent << name << ": " << rgb[0] << " " << rgb[1] << " " << rgb[2] << "\n";
  };
  print("BlackPoint", this->BlackPoint);
  print("WhitePoint", this->WhitePoint);
  os << indent << "Interactive: " << this->Interactive << "\n";
  os << indent << "Refining: " << this->Refining << "\n";
  os << indent << "ActiveEffects: " << this->ActiveEffects << "\n";
  os << indent << "RenderStatistics: " << this->RenderStatistics << "\n";
}
