#include "vtkSplatProp.h"

#include "Filters/ParticleData.h"
#include "Filters/PictureData.h"
#include "Readers/Processes.h"
#include "Readers/ReportErrors.h"
#include "RemotePicture.h"
#include "RendererCamera.h"
#include "SplatCanvas.h"
#include "SplatPicture.h"
#include "vtkSplatSettings.h"

#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSplatProp);

vtkSplatProp::vtkSplatProp()
  : Settings(vtkSmartPointer<vtkSplatSettings>::New())
  , Canvas(std::make_unique<galaxy::SplatCanvas>())
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
    galaxy::reportErrors(
      this, [this] { galaxy::boundsOfKernels(this->Particles, *this->Settings, this->Bounds); });
  }
  return this->Bounds;
}

vtkMTimeType vtkSplatProp::InputTime()
{
  const vtkMTimeType particles = this->Particles ? this->Particles->GetMTime() : 0;
  return std::max({ particles, this->ParticlesTime.GetMTime(), this->Settings->GetMTime() });
}

std::vector<vtkSplatProp*> vtkSplatProp::Visible(vtkRenderer* renderer)
{
  std::vector<vtkSplatProp*> props;
  vtkPropCollection* all = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  all->InitTraversal(at);
  while (vtkProp* prop = all->GetNextProp(at))
  {
    auto splats = vtkSplatProp::SafeDownCast(prop);
    if (splats && splats->GetVisibility())
    {
      props.push_back(splats);
    }
  }
  return props;
}

std::vector<vtkSplatProp*> vtkSplatProp::DrawnTogether(vtkRenderer* renderer)
{
  std::vector<vtkSplatProp*> props;
  for (vtkSplatProp* splats : vtkSplatProp::Visible(renderer))
  {
    // What the renderer has culled is not asked to draw, and has no time to.
    const bool isAsked = splats->GetRenderTimeMultiplier() > 0;
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
  // A selector tells by their colours what it has drawn.
  if (!renderer || renderer->GetSelector() || this->IsLaidLast)
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
    const galaxy::Camera camera = galaxy::cameraOf(renderer);
    this->UpdatePicture(renderer, camera, galaxy::opaqueDepth(renderer, camera), props);
    this->Canvas->lay(this->ShownPicture(), renderer);
  });
}

void vtkSplatProp::LayLast(vtkObject* caller, unsigned long, void*)
{
  auto renderer = vtkRenderer::SafeDownCast(caller);
  const std::vector<vtkSplatProp*> all = vtkSplatProp::Visible(renderer);
  if (!this->IsLaidLast || all.empty() || all.front() != this)
  {
    return;
  }
  galaxy::ShownPicture picture;
  if (vtkMultiProcessController* server = galaxy::wayToServer())
  {
    picture = galaxy::receivePicture(server);
    for (vtkSplatProp* prop : all)
    {
      prop->ActiveEffects = picture.activeEffects;
      prop->RenderStatistics = picture.renderStatistics;
    }
  }
  else
  {
    galaxy::reportErrors(this, [&] { picture = this->PictureOfAllProcesses(renderer); });
  }
  if (vtkMultiProcessController* client = galaxy::wayToClient())
  {
    galaxy::sendPicture(picture, client);
  }
  else if (!renderer->GetSelector())
  {
    this->Canvas->layOnWhole(picture, renderer);
  }
}

galaxy::ShownPicture vtkSplatProp::PictureOfAllProcesses(vtkRenderer* renderer)
{
  const galaxy::Camera camera = galaxy::cameraOf(renderer);
  std::vector<float> depth = galaxy::compositedDepth(renderer, camera);
  const std::vector<vtkSplatProp*> props = this->DrawnTogether(renderer);
  if (props.empty() || renderer->GetSelector() || !galaxy::isFirstProcess())
  {
    return {};
  }
  this->UpdatePicture(renderer, camera, std::move(depth), props);
  return this->ShownPicture();
}

void vtkSplatProp::UpdatePicture(vtkRenderer* renderer, const galaxy::Camera& camera,
  std::vector<float>&& opaqueDepth, const std::vector<vtkSplatProp*>& props)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  galaxy::SplatRequest request;
  request.camera = camera;
  request.opaqueDepth = std::move(opaqueDepth);
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
  this->HintAtPlaces(props);
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

galaxy::ShownPicture vtkSplatProp::ShownPicture() const
{
  const galaxy::RenderedImage& image = this->Picture->image();
  galaxy::ShownPicture picture;
  picture.width = image.width;
  picture.height = image.height;
  picture.light.resize(image.radiance.size());
  galaxy::applyToneMap(
    this->GetToneMap(), image.radiance.data(), picture.light.data(), picture.light.size() / 3);
  picture.transmittance = image.transmittance;
  picture.activeEffects = this->ActiveEffects;
  picture.renderStatistics = this->RenderStatistics;
  return picture;
}

void vtkSplatProp::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Canvas = std::make_unique<galaxy::SplatCanvas>();
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
