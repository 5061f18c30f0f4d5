#include "SplatPicture.h"

#include "Filters/ParticleData.h"
#include "vtkSplatSettings.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace galaxy
{
namespace
{
bool isSame(const Camera& p, const Camera& q)
{
  const auto all = [](const Camera& c) {
    return std::make_tuple(c.eye.x, c.eye.y, c.eye.z, c.right.x, c.right.y, c.right.z, c.up.x,
      c.up.y, c.up.z, c.forward.x, c.forward.y, c.forward.z, c.parallel, c.scale, c.centerX,
      c.centerY, c.width, c.height);
  };
  return all(p) == all(q);
}

/// Which particles, and as they were when.
std::vector<double> versionsOf(const std::vector<SplatPart>& parts)
{
  std::vector<double> versions;
  for (const SplatPart& part : parts)
  {
    versions.push_back(static_cast<double>(std::max(part.version, part.particles->GetMTime())));
  }
  return versions;
}

/// What of a component table joint particles have in their arrays where they keep colours.
void appendColors(const std::vector<ComponentInfo>& components, std::vector<double>& to)
{
  for (const ComponentInfo& component : components)
  {
    to.insert(to.end(), { double(component.absorbs), double(component.isRecolored) });
    to.insert(to.end(), component.color.begin(), component.color.end());
    to.insert(to.end(), component.absorption.begin(), component.absorption.end());
  }
}

ErrorBound unseenError(const std::vector<SplatPart>& parts, const ToneMap& toneMap)
{
  double tolerance = parts.front().settings->GetTolerance();
  for (const SplatPart& part : parts)
  {
    tolerance = std::min(tolerance, part.settings->GetTolerance());
  }
  return allowedError(toneMap, tolerance);
}

/// So exact that a picture need not be made anew where it is exposed up to 16 times brighter, or
/// stretched with a gamma of down to 1/4.
ErrorBound withHeadroom(const ErrorBound& unseen)
{
  return { unseen.light / 16, unseen.share / 4 };
}

/// How much brighter than the first part one is exposed.
double relativeExposure(const std::vector<SplatPart>& parts, std::size_t k)
{
  const double first = parts.front().exposure;
  return k == 0 || first == parts[k].exposure ? 1 : parts[k].exposure / std::max(first, 1e-300);
}
} // namespace

bool SplatPicture::Scene::operator==(const Scene& other) const
{
  return this->parts == other.parts && isSame(this->camera, other.camera) &&
    this->opaqueDepth == other.opaqueDepth;
}

bool SplatPicture::State::isOfScene(const State& other) const
{
  return this->scene == other.scene && this->gains == other.gains;
}

bool SplatPicture::State::servesFor(const State& other) const
{
  const bool isGood = this->accuracy == other.accuracy &&
    (this->accuracy != Accuracy::Bounded ||
      (this->allowed.light <= other.needed.light && this->allowed.share <= other.needed.share));
  return isGood && this->slices == other.slices && this->seconds == other.seconds &&
    this->isOfScene(other);
}

RenderOptions SplatPicture::optionsOf(const std::vector<SplatPart>& parts) const
{
  RenderOptions options = renderOptions(*parts.front().settings);
  for (const SplatPart& part : parts)
  {
    const RenderOptions other = renderOptions(*part.settings);
    options.accuracy = std::min(options.accuracy, other.accuracy);
    options.slices = std::max(options.slices, other.slices);
    options.previewTime = std::min(options.previewTime, other.previewTime);
  }
  return options;
}

/// The scene and its light, as the settings have them.
SplatPicture::State SplatPicture::stateOf(
  const std::vector<SplatPart>& parts, const RenderOptions& options) const
{
  State state;
  state.scene.parts = versionsOf(parts);
  state.scene.parts.push_back(static_cast<double>(options.kernel));
  const auto has = [](const SplatPart& part, const char* array) {
    return part.particles->GetPointData()->HasArray(array) != 0;
  };
  // As JointParticles do.
  const bool keepColors = parts.size() > 1 &&
    std::any_of(parts.begin(), parts.end(),
      [&has](const SplatPart& part) { return has(part, "Emission") || has(part, "Absorption"); });
  ComponentLights lights;
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    std::vector<ComponentInfo> components = toComponents(parts[k].particles->GetFieldData());
    std::vector<bool> visible;
    parts[k].settings->Apply(components, visible);
    for (ComponentInfo& component : components)
    {
      component.light *= relativeExposure(parts, k);
    }
    lights.add(
      components, visible, keepColors || has(parts[k], "Emission"), has(parts[k], "Absorption"));
  }
  state.scene.parts.insert(state.scene.parts.end(), lights.others.begin(), lights.others.end());
  state.gains = std::move(lights.gains);
  state.accuracy = options.accuracy;
  state.slices = options.slices;
  state.allowed = options.allowed;
  return state;
}

void SplatPicture::update(const std::vector<SplatPart>& parts, SplatRequest request)
{
  RenderOptions options = this->optionsOf(parts);
  const ErrorBound unseen = unseenError(parts, request.toneMap);
  options.allowed = withHeadroom(unseen);
  options.memory = &this->memory;
  const bool isBettering = this->isAwaited;
  State next = this->stateOf(parts, options);
  next.scene.camera = request.camera;
  next.scene.opaqueDepth = std::move(request.opaqueDepth);
  next.needed = unseen;
  next.seconds = this->nextSeconds(request, options, next);
  next.accuracy = options.accuracy = next.seconds > 0 ? Accuracy::Preview : options.accuracy;
  this->aborted = false;
  if (this->last.servesFor(next))
  {
    return;
  }
  const std::vector<float>& opaqueDepth = next.scene.opaqueDepth;
  options.opaqueDepth = opaqueDepth.empty() ? nullptr : opaqueDepth.data();
  if (request.progress && !request.isMoving)
  {
    options.progress = [&](double fraction) {
      this->aborted = !request.progress(fraction);
      return !this->aborted && !(isBettering && request.hasToWait());
    };
  }
  std::vector<ParticleInput> inputs(parts.size());
  const ParticleView particles = this->view(parts, inputs);
  this->draw(particles, options, next);
  if (next.image->aborted)
  {
    this->giveUp(particles, options, next);
    return;
  }
  this->last = std::move(next);
}

void SplatPicture::draw(const ParticleView& particles, const RenderOptions& options, State& next)
{
  if (next.seconds > 0)
  {
    next.image = std::make_shared<RenderedImage>(
      this->preview.render(particles, this->version, next.scene.camera, options, next.seconds));
    return;
  }
  const bool isOther = !this->isDrawn(next);
  if (isOther)
  {
    this->groups.clear();
    this->drawn = next;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  next.image = this->groups.render(particles, next.gains, next.scene.camera, options, next.needed);
  next.allowed = this->groups.bound();
  if (!next.image->aborted && isOther)
  {
    this->fullSeconds = vtkTimerLog::GetUniversalTime() - start;
  }
}

/// Shows what there is instead of a picture that was aborted, or has to wait.
void SplatPicture::giveUp(const ParticleView& particles, const RenderOptions& options, State& next)
{
  if (!this->last.isOfScene(next))
  {
    RenderOptions brief = options;
    brief.accuracy = next.accuracy = Accuracy::Preview;
    brief.progress = nullptr;
    next.seconds = options.previewTime;
    this->draw(particles, brief, next);
    this->last = std::move(next);
  }
  // What has to wait is tried again when the view rests.
  this->seconds = this->aborted ? 0 : this->last.seconds;
}

/// Whether the light groups are of this scene.
bool SplatPicture::isDrawn(const State& next) const
{
  return this->drawn.scene == next.scene && this->drawn.accuracy == next.accuracy &&
    this->drawn.slices == next.slices;
}

/// Where the particles are, `inputs` holding what had to be made of them.
ParticleView SplatPicture::view(
  const std::vector<SplatPart>& parts, std::vector<ParticleInput>& inputs)
{
  std::vector<ParticleView> views;
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    viewParticles(parts[k].particles, *parts[k].settings, inputs[k]);
    for (ComponentInfo& component : inputs[k].components)
    {
      component.light *= relativeExposure(parts, k);
    }
    views.push_back(inputs[k].view);
  }
  std::vector<double> versions = versionsOf(parts);
  const bool isJoint = views.size() > 1;
  if (isJoint && JointParticles::keepsColors(views))
  {
    for (const ParticleInput& input : inputs)
    {
      appendColors(input.components, versions);
    }
  }
  if (this->versions != versions)
  {
    this->joint = isJoint ? std::make_unique<JointParticles>(views) : nullptr;
    this->versions = versions;
    ++this->version;
  }
  return isJoint ? this->joint->view(views) : views.front();
}

double SplatPicture::nextSeconds(
  const SplatRequest& request, const RenderOptions& options, const State& next)
{
  const double shortest = options.previewTime;
  if (options.accuracy == Accuracy::Preview)
  {
    return shortest;
  }
  if (this->isDrawn(next) && this->groups.has(next.gains, next.needed))
  {
    this->isAwaited = false;
    this->seconds = 0;
    return 0;
  }
  // What is seen changes at once, and is bettered once the view rests.
  const bool isNew = request.isRefined && !this->last.isOfScene(next);
  if ((request.isMoving || isNew) && this->fullSeconds > shortest)
  {
    this->seconds = shortest;
    this->isAwaited = request.isRefined;
    return this->seconds;
  }
  // What nobody will better, as a picture that is to be saved, is of all particles.
  this->seconds = request.isRefined && this->isAwaited ? this->seconds : 0;
  this->isAwaited = false;
  return this->seconds;
}

bool SplatPicture::refine()
{
  if (this->seconds == 0 || this->last.image->radiance.empty())
  {
    return false;
  }
  const double next = 4 * this->seconds;
  const bool isAll = this->last.image->statistics.sampled >= this->preview.most();
  this->seconds = isAll || next > this->fullSeconds / 2 ? 0 : next;
  this->isAwaited = true;
  return true;
}
} // namespace galaxy
