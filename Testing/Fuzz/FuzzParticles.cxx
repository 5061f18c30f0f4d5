// FuzzParticles COUNT SEED [none]
//
// Draws COUNT small scenes of particles that no program would write, each at every level of
// accuracy: random ones, and such whose numbers are anything that single precision has (NaN,
// infinite, huge, tiny, negative), through cameras of any kind, also from within the particles. A
// picture is right if it has no NaN, no negative light and no transmittance outside of [0, 1], if
// every particle is accounted for, if it ends when it is aborted, and if the levels agree where the
// scene is a sane one; anything else, a crash or a sanitizer's report ends the run.

#include "Filters/Splatting/Panorama.h"
#include "Filters/Splatting/Preview.h"
#include "Filters/Splatting/Render.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <omp.h>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace galaxy;
using Random = std::mt19937_64;

double uniform(Random& random, double from, double to)
{
  return std::uniform_real_distribution<double>(from, to)(random);
}

bool chance(Random& random, double share)
{
  return uniform(random, 0, 1) < share;
}

/// Any number.
double absurd(Random& random)
{
  constexpr float largest = std::numeric_limits<float>::max();
  constexpr double odd[] = { 0, -0.0, 1, -1, 1e-45, 1e-40, 1.2e-38, 1e-30, 1e-20, 1e20, 1e30, 1e37,
    largest, -largest, 0.5, 3 };
  switch (random() % 12)
  {
    case 0:
      return std::nan("");
    case 1:
      return random() % 2 ? HUGE_VAL : -HUGE_VAL;
    case 2:
    case 3:
    case 4:
      return std::pow(10, uniform(random, -44, 38));
    case 5:
      return -std::pow(10, uniform(random, -44, 38));
    default:
      return odd[random() % (sizeof odd / sizeof *odd)];
  }
}

/// One scene and how it is drawn.
struct Input
{
  double oddity = 0; ///< the share of its numbers that are absurd
  std::vector<float> position, h, intensity, emission, absorption;
  std::vector<std::uint8_t> color, component;
  std::vector<ComponentInfo> components;
  std::vector<bool> visible;
  std::vector<float> opaque;
  Camera camera;
  RenderOptions options;

  bool isSane() const { return this->oddity == 0; }

  ParticleView view() const
  {
    ParticleView view;
    const auto data = [](const auto& array) { return array.empty() ? nullptr : array.data(); };
    view.size = this->h.size();
    view.position = this->position.data();
    view.smoothingLength = this->h.data();
    view.intensity = data(this->intensity);
    view.emission = data(this->emission);
    view.absorption = data(this->absorption);
    view.color = data(this->color);
    view.component = data(this->component);
    view.components = this->components.empty() ? nullptr : &this->components;
    view.visible = this->visible.empty() ? nullptr : &this->visible;
    return view;
  }
};

class Maker
{
public:
  explicit Maker(Random& random)
    : random(random)
  {
    constexpr double oddities[] = { 0, 0, 0.02, 0.3 };
    this->input.oddity = oddities[random() % 4];
  }

  Input make()
  {
    this->addParticles();
    this->addComponents();
    this->setCamera();
    this->setOptions();
    return this->input;
  }

private:
  double number(double sane)
  {
    return chance(this->random, this->input.oddity) ? absurd(this->random) : sane;
  }
  double between(double from, double to) { return this->number(uniform(this->random, from, to)); }
  double decades(double from, double to)
  {
    return this->number(std::pow(10, uniform(this->random, from, to)));
  }

  void addParticles()
  {
    const std::size_t size = this->random() % 40;
    const bool asArrays = this->random() % 2, isFlat = this->random() % 4 == 0;
    const bool isAlike = this->random() % 4 == 0;
    const auto put = [](std::vector<float>& to, double x) { to.push_back(static_cast<float>(x)); };
    for (std::size_t i = 0; i < size; ++i)
    {
      put(this->input.position, this->between(-3, 3));
      put(this->input.position, this->between(-3, 3));
      put(this->input.position, isFlat ? 0 : this->between(-3, 3));
      const double h = this->decades(-4, 1);
      put(this->input.h, isAlike && i > 0 ? this->input.h[0] : h);
      const double depth = h * h * (chance(this->random, 0.5) ? 0 : this->decades(-4, 2));
      if (!asArrays)
      {
        put(this->input.intensity, i % 2 ? depth : this->decades(-3, 3));
        this->input.component.push_back(static_cast<std::uint8_t>(this->random() % 4));
        continue;
      }
      for (int c = 0; c < 3; ++c)
      {
        put(this->input.emission, chance(this->random, 0.3) ? 0 : this->decades(-3, 3));
        put(this->input.absorption, c > 0 && this->random() % 2 ? depth : this->number(depth));
      }
    }
    for (std::size_t i = 0; i < 3 * size && this->random() % 2; ++i)
    {
      this->input.color.push_back(static_cast<std::uint8_t>(this->random()));
    }
    this->input.color.resize(this->input.color.size() == 3 * size ? 3 * size : 0);
  }

  void addComponents()
  {
    const std::size_t count = this->random() % 5;
    for (std::size_t k = 0; k < count; ++k)
    {
      ComponentInfo info;
      info.absorbs = k % 2;
      info.size = this->random() % 2 ? 1 : std::abs(this->decades(-1, 1));
      info.brightness = this->random() % 2 ? 1 : std::abs(this->decades(-1, 1));
      info.light = this->random() % 2 ? 1 : std::abs(this->decades(-1, 1));
      info.isRecolored = this->random() % 3 == 0;
      info.color = { 1, uniform(this->random, 0, 1), 0.2 };
      this->input.components.push_back(info);
      this->input.visible.push_back(this->random() % 8 != 0);
    }
    this->input.visible.resize(this->random() % 2 ? 0 : this->input.visible.size());
  }

  void setCamera()
  {
    const int width = 1 + static_cast<int>(this->random() % 48);
    const int height = 1 + static_cast<int>(this->random() % 48);
    Vec3 eye = { 0, 0, 10 };
    if (this->random() % 2 && !this->input.h.empty())
    {
      // Where a particle is, or near.
      const float* p = this->input.position.data();
      eye = { p[0] + this->between(-1, 1), p[1], p[2] };
    }
    const auto isPlace = [](const Vec3& v) { return std::isfinite(v.x + v.y + v.z); };
    eye = isPlace(eye) ? eye : Vec3{ 0, 0, 10 };
    const Vec3 to = { uniform(this->random, -1, 1), uniform(this->random, -1, 1), 0 };
    const double scale = std::clamp(std::abs(this->decades(-1, 1)), 1e-30, 1e30);
    this->input.camera = Camera::lookAt(eye, to, { 0, 1, 0 }, this->random() % 2,
      std::isnan(scale) ? 1 : scale, uniform(this->random, 1, 150), width, height);
    for (int i = 0; i < width * height && this->random() % 3 == 0; ++i)
    {
      this->input.opaque.push_back(static_cast<float>(this->between(0, 20)));
    }
    const bool isWhole = this->input.opaque.size() == std::size_t(width) * height;
    this->input.opaque.resize(isWhole ? this->input.opaque.size() : 0);
  }

  void setOptions()
  {
    RenderOptions& options = this->input.options;
    options.kernel = this->random() % 2 ? Kernel::Gaussian : Kernel::CubicSpline;
    options.slices = uniform(this->random, 0.2, 2);
    options.previewTime = 1e-3;
    options.allowed = { std::pow(10, uniform(this->random, -9, 2)),
      std::pow(10, uniform(this->random, -9, 0)) };
  }

  Random& random;
  Input input;
};

bool fail(const char* what, double number = 0)
{
  std::fprintf(stderr, "%s (%g)\n", what, number);
  return false;
}

bool isSound(const RenderedImage& image, std::size_t particles)
{
  if (image.radiance.size() != 3 * std::size_t(image.width) * image.height ||
    image.radiance.size() != image.transmittance.size())
  {
    return fail("a picture of another size");
  }
  for (std::size_t k = 0; k < image.radiance.size(); ++k)
  {
    const float I = image.radiance[k], T = image.transmittance[k];
    if (!(I >= 0 && std::isfinite(I)) || !(T >= 0 && T <= 1))
    {
      return fail(I >= 0 && std::isfinite(I) ? "transmittance" : "radiance",
        I >= 0 && std::isfinite(I) ? T : I);
    }
    if (image.aborted && (I != 0 || T != 1))
    {
      return fail("something in a picture that was given up");
    }
  }
  const RenderStatistics& s = image.statistics;
  const std::size_t counted = s.drawn + s.culled + s.invalid;
  return image.aborted || counted == (s.sampled > 0 ? s.sampled : particles) ||
    fail("particles not accounted for", double(counted));
}

/// How far a is from b, over the largest of b, less what is allowed.
bool agree(
  const char* what, const RenderedImage& a, const RenderedImage& b, const ErrorBound& bound)
{
  const double most = *std::max_element(b.radiance.begin(), b.radiance.end());
  for (std::size_t k = 0; k < a.radiance.size(); ++k)
  {
    const double light = std::abs(double(a.radiance[k]) - b.radiance[k]);
    const double through = std::abs(double(a.transmittance[k]) - b.transmittance[k]);
    if (light > bound.light + bound.share * b.radiance[k] + 1e-4 * most ||
      through > bound.share + 1e-4)
    {
      std::fprintf(stderr, "%s: %g for %g, %g for %g\n", what, a.radiance[k], b.radiance[k],
        a.transmittance[k], b.transmittance[k]);
      return false;
    }
  }
  return true;
}

bool tryScene(Random& random, std::size_t& drawn)
{
  Input input = Maker(random).make();
  RenderOptions options = input.options;
  options.opaqueDepth = input.opaque.empty() ? nullptr : input.opaque.data();
  const ParticleView view = input.view();
  const auto draw = [&](Accuracy accuracy) {
    options.accuracy = accuracy;
    return render(view, input.camera, options);
  };
  const auto sorted = draw(Accuracy::Sorted);
  drawn += sorted.statistics.drawn;
  bool good = isSound(sorted, view.size);
  const auto bounded = draw(Accuracy::Bounded);
  good = good && isSound(bounded, view.size) && isSound(draw(Accuracy::Preview), view.size) &&
    isSound(draw(Accuracy::Overlapping), view.size);
  if (good && input.isSane())
  {
    good = agree("Sorted", sorted, renderReference(view, input.camera, options), {}) &&
      agree("Bounded", bounded, sorted, bounded.statistics.bound);
  }
  if (good && view.size > 1)
  {
    const PreviewSample sample(view);
    const ParticleView some = sample.first(view.size / 2, view);
    good = isSound(renderSorted(some, input.camera, options), some.size);
  }
  if (good && random() % 8 == 0)
  {
    Panorama panorama;
    panorama.kind = random() % 2 ? Panorama::Kind::Dome : Panorama::Kind::Equirectangular;
    panorama.ahead = input.camera;
    panorama.width = panorama.height = 12;
    options.accuracy = Accuracy::Sorted;
    const auto image = renderPanorama(view, panorama, options);
    good =
      isSound(image, image.statistics.drawn + image.statistics.culled + image.statistics.invalid);
  }
  // Given up at some moment, or not at all if it is done before.
  int left = static_cast<int>(random() % 6);
  bool isGivenUp = false;
  options.progress = [&](double) { return !(isGivenUp = isGivenUp || left-- == 0); };
  const auto aborted = draw(static_cast<Accuracy>(random() % 4));
  return good && isSound(aborted, view.size) &&
    (aborted.aborted == isGivenUp || fail("given up, and not"));
}
} // namespace

int main(int argc, char* argv[])
{
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  omp_set_num_threads(2);
  std::size_t drawn = 0;
  for (int i = 0; i < count; ++i)
  {
    Random random(seed * 1000003 + static_cast<unsigned long long>(i));
    if (!tryScene(random, drawn))
    {
      std::fprintf(stderr, "particles, scene %d of seed %llu\n", i, seed);
      return EXIT_FAILURE;
    }
  }
  std::printf("particles: %d scenes, %zu particles drawn\n", count, drawn);
  return EXIT_SUCCESS;
}
