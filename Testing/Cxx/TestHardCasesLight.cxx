// Hard cases of drawing, numbered as in the other TestHardCases files; those without a number are
// letters. Each adds a line to a table, which is printed at the end.
#include "Filters/Splatting/GaussianKernel.h"
#include "HardCaseTable.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <limits>
#include <omp.h>

#ifdef __SSE2__
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace
{
using namespace galaxy;

constexpr double pi = 3.14159265358979323846;

bool isFinite(const RenderedImage& image)
{
  const auto finite = [](float x) { return std::isfinite(x); };
  return std::all_of(image.radiance.begin(), image.radiance.end(), finite) &&
    std::all_of(image.transmittance.begin(), image.transmittance.end(), finite);
}

/// A particle over the picture's middle so wide that all of the middle pixel has its peak.
constexpr double wide = 20;
constexpr float perPeak =
  static_cast<float>(pi * wide * wide / 9); ///< of what the peak has 1 per kpc^2

void addWide(Scene& scene, double z, std::array<float, 3> peak, std::array<float, 3> depth = {})
{
  for (int c = 0; c < 3; ++c)
  {
    peak[c] *= perPeak;
    depth[c] *= perPeak;
  }
  scene.add({ 0.05, 0.05, z }, wide, peak, depth);
}

RenderedImage drawn(const Scene& scene, int size = 8)
{
  return renderSorted(scene.view(), testCamera(true, size, size));
}

/// Of the pixel in the middle.
double light(const RenderedImage& image, int channel = 0)
{
  return image.radiance[pixelAt(image, image.width / 2, image.height / 2) + channel];
}
double through(const RenderedImage& image, int channel = 0)
{
  return image.transmittance[pixelAt(image, image.width / 2, image.height / 2) + channel];
}

/// What the peak is, the kernel not being quite a Gaussian: of a particle of 1 per kpc^2 there.
double peak()
{
  Scene scene;
  addWide(scene, 0, { 1, 1, 1 });
  return light(drawn(scene));
}

TEST(HardCasesLight, NothingAbsorbed)
{
  Scene scene = randomScene(2000, false);
  const auto with = drawn(scene, 64);
  ParticleView view = scene.view();
  view.absorption = nullptr;
  checkSame("1", "K = 0 is no K", renderSorted(view, testCamera(true, 64, 64)), with, 0);
}

TEST(HardCasesLight, DenormalDepths)
{
  Scene scene, dark;
  addWide(scene, 0, { 1, 1, 1 });
  dark = scene;
  const float tiny = 1e-40F / perPeak;
  addWide(dark, 1, { 0, 0, 0 }, { 1e-38F, tiny, 1e-42F });
  checkSame("2", "t = 1e-38 and denormal", drawn(scene), drawn(dark), 6e-8);
#ifdef __SSE2__
#pragma omp parallel
  {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  const auto flushed = drawn(dark);
#pragma omp parallel
  {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_OFF);
  }
  checkSame("2", "the same, denormals flushed", drawn(scene), flushed, 6e-8);
#endif
}

TEST(HardCasesLight, OneSlab)
{
  const double p = peak();
  {
    Scene scene;
    addWide(scene, 0, { 1e30F, 1e30F, 1e30F }, { 1e-30F, 1e-30F, 1e-30F });
    const auto image = drawn(scene);
    EXPECT_TRUE(isFinite(image));
    check("3", "E = 1e30, A = 1e-30", 1e30 * p, light(image), 1e-6);
  }
  {
    Scene scene;
    addWide(scene, 0, { 1, 1, 1 });
    addWide(scene, 1, { 0, 0, 0 }, { 1e3F, 1e3F, 1e3F });
    check("4", "E = 0, t = 1e3 before light", 0, light(drawn(scene)), 0);
  }
  {
    Scene scene;
    addWide(scene, 0, { 1e6F, 1e6F, 1e6F });
    addWide(scene, 1, { 50, 50, 50 }, { 50, 50, 50 });
    check("6", "t = 50 before 1e6 of its source", 1, light(drawn(scene)), 1e-6);
  }
  {
    Scene scene;
    addWide(scene, 0, { 1, 1, 1 });
    addWide(scene, 1, { 0, 0, 0 }, { 0, 1e6F, 1 });
    const auto image = drawn(scene);
    check("7", "t = 0 beside huge", p, light(image, 0), 0);
    check("7", "t huge beside 0", 0, light(image, 1), 0);
    check("7", "t = 1 beside both", p * std::exp(-p), light(image, 2), 1e-6);
    check("7", "T beside both", std::exp(-p), through(image, 2), 1e-6);
  }
  double previous = 0;
  for (const double t : { 0.5 * (1 - 2e-7), 0.5 * (1 + 2e-7) })
  {
    Scene scene;
    const auto depth = static_cast<float>(t / p);
    addWide(scene, 0, { 1, 1, 1 }, { depth, depth, depth });
    const double got = light(drawn(scene));
    if (previous > 0)
    {
      check("10", "phi on both sides of t = 1/2", previous, got, 4e-7);
    }
    previous = got;
  }
}

TEST(HardCasesLight, DarkParticlesChangeNothing)
{
  Scene scene = randomScene(500, true);
  const auto before = drawn(scene, 64);
  for (int k = 0; k < 50; ++k)
  {
    addWide(scene, k - 25, { 0, 0, 0 });
  }
  checkSame("5", "E = A = 0", before, drawn(scene, 64), 0);
}

TEST(HardCasesLight, TenMillionInOnePixel)
{
  const std::size_t n = 10000000;
  std::vector<float> position(3 * n, 0.05F), h(n, 0.001F), emission(n, 1e-3F), absorption(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    position[3 * i + 2] = 1e-6F * i;
    absorption[i] = static_cast<float>(1e-8 * pixelArea);
  }
  ParticleView view;
  view.size = n;
  view.position = position.data();
  view.smoothingLength = h.data();
  view.emission = emission.data();
  view.emissionChannels = view.absorptionChannels = 1;
  check("9", "1e7 equal emitters", 1e-3F * double(n) / pixelArea,
    light(renderSorted(view, testCamera(true, 8, 8))), 5e-6);
  view.absorption = absorption.data();
  view.emission = nullptr;
  check("8", "1e7 of t = 1e-8, tau", 0.1,
    -std::log(through(renderSorted(view, testCamera(true, 8, 8)))), 1e-5);
  // In double precision there is nothing but the rounding of the picture itself.
  view.size = 100000;
  view.emission = emission.data();
  view.absorption = nullptr;
  check("9", "1e5 in the reference", 1e-3F * 1e5 / pixelArea,
    light(renderReference(view, testCamera(true, 8, 8))), 1.2e-7);
}

TEST(HardCasesLight, SmallAndHuge)
{
  {
    Scene scene;
    scene.add({ 0, 0, 0 }, 3e-4, { 1, 1, 1 });
    const auto image = drawn(scene);
    check("25", "sigma of 1e-3 pixels on a corner, all", 1, total(image) * pixelArea, 1e-6);
    check("25", "and each of four pixels", 0.25, light(image) * pixelArea, 1e-6);
  }
  for (const double pixels : { 1e4, 1e8 })
  {
    Scene scene;
    scene.add({ 0, 0, 0 }, 0.3 * pixels, { 1, 1, 1 });
    const double start = omp_get_wtime();
    const auto image = drawn(scene, 100);
    EXPECT_LT(omp_get_wtime() - start, 1);
    const double half = gaussianCumulative(50 / pixels);
    check("26", pixels < 1e5 ? "sigma of 1e4 pixels, in view" : "sigma of 1e8 pixels, in view",
      4 * half * half, total(image) * pixelArea, 3e-6);
  }
}

TEST(HardCasesLight, InOnePlace)
{
  const double p = peak();
  Scene scene;
  addWide(scene, 0, { 1, 1, 1 }, { 0, 0, 0 });
  addWide(scene, 0, { 0, 0, 0 }, { 1, 2, 3 });
  RenderOptions options;
  options.accuracy = Accuracy::Overlapping;
  options.slices = 64;
  const auto image = render(scene.view(), testCamera(true, 8, 8), options);
  for (int c = 0; c < 3; ++c)
  {
    const double t = (c + 1) * p;
    check("29", "emitter and absorber in one place, phi(t)", p * -std::expm1(-t) / t,
      light(image, c), 1e-3);
  }
  Scene flat = randomScene(2000, true);
  for (std::size_t i = 0; i < flat.h.size(); ++i)
  {
    flat.position[3 * i + 2] = 0;
  }
  const auto once = drawn(flat, 64);
  omp_set_num_threads(16);
  checkSame("30", "all depths equal, 16 threads", once, drawn(flat, 64), 0);
  omp_set_num_threads(omp_get_num_procs());
}

TEST(HardCasesLight, Invariance)
{
  const Scene scene = randomScene(3000, true);
  const auto once = drawn(scene, 128);
  std::vector<int> order(3000);
  for (int i = 0; i < 3000; ++i)
  {
    order[i] = (i * 1237 + 11) % 3000;
  }
  checkSame("31", "shuffled", once, drawn(scene.inOrder(order), 128), 1e-6);
  omp_set_num_threads(1);
  const auto alone = drawn(scene, 128);
  omp_set_num_threads(16);
  checkSame("32", "1 and 16 threads", alone, drawn(scene, 128), 0);
  omp_set_num_threads(omp_get_num_procs());

  const auto turned = [&scene](double degrees) {
    const double a = degrees * pi / 180;
    return renderSorted(scene.view(),
      Camera::lookAt(
        { 100 * std::sin(a), 0, 100 * std::cos(a) }, {}, { 0, 1, 0 }, false, 1, 6, 128, 128));
  };
  checkSame("33", "a full turn", turned(0), turned(360), 1e-6);

  Scene halves;
  for (std::size_t i = 0; i < scene.h.size(); ++i)
  {
    const float* p = &scene.position[3 * i];
    std::array<float, 3> L, K;
    for (int c = 0; c < 3; ++c)
    {
      L[c] = 0.5F * scene.emission[3 * i + c];
      K[c] = 0;
    }
    for (int k = 0; k < 2; ++k)
    {
      halves.add({ p[0], p[1], p[2] }, scene.h[i], L, K);
    }
  }
  Scene bare = scene;
  std::fill(bare.absorption.begin(), bare.absorption.end(), 0.0F);
  checkSame("39", "halves of particles in one place", drawn(bare, 128), drawn(halves, 128), 5e-7);
  checkSame("39", "and in the reference", renderReference(bare.view(), testCamera(true, 128, 128)),
    renderReference(halves.view(), testCamera(true, 128, 128)), 1e-7);

  const auto exact = renderReference(scene.view(), testCamera(true, 128, 128));
  double square = 0;
  for (std::size_t k = 0; k < exact.radiance.size(); ++k)
  {
    square += std::pow((double(exact.radiance[k]) - once.radiance[k]) / largest(exact.radiance), 2);
  }
  const double psnr = -10 * std::log10(square / exact.radiance.size());
  HardCaseTable::add("41", "float against double, PSNR in dB (error: 120 - PSNR)", 120, psnr,
    std::max(0.0, 120 - psnr), 0);
  EXPECT_GT(psnr, 120);
}

TEST(HardCasesLight, FarAway)
{
  // Megaparsecs from the origin, where float counts in kpc.
  for (const double x : { 5e3, 1e7 })
  {
    Scene scene;
    scene.add({ x, 0, 0 }, 1e-4, { 1, 1, 1 });
    scene.add({ x, 0, 0 }, 1e-4, {}, { 1e-9F, 1e-9F, 1e-9F });
    const double place = scene.position[0];
    const auto camera = [](double x0) {
      return Camera::lookAt({ x0, 0, 1 }, { x0, 0, 0 }, { 0, 1, 0 }, true, 5e-4, 30, 100, 100);
    };
    const auto far = renderSorted(scene.view(), camera(place));
    scene.position[0] = scene.position[3] = 0;
    const auto near = renderSorted(scene.view(), camera(0));
    checkSame(
      x < 1e4 ? "34" : "A", x < 1e4 ? "5 Mpc away" : "1e7 kpc away, h = 1e-4", near, far, 1e-6);
    EXPECT_GT(largest(near.radiance), 0);
  }
}

TEST(HardCasesLight, SplineNeverNegative)
{
  Scene scene;
  scene.add({ 0, 0, 0 }, 2, { 1, 1, 1 });
  RenderOptions options;
  options.kernel = Kernel::CubicSpline;
  const auto image = renderSorted(scene.view(), testCamera(true, 64, 64), options);
  const float least = *std::min_element(image.radiance.begin(), image.radiance.end());
  check("37", "least of a spline", 0, least, 0);
}

TEST(HardCasesLight, SixtyOrdersOfMagnitude)
{
  Scene scene;
  for (int k = -30; k <= 30; k += 10)
  {
    const auto L = static_cast<float>(std::pow(10.0, k));
    scene.add({ 0.2 * k + 0.05, 0.05, 0 }, 0.01, { L, L, L });
    scene.add({ 0.2 * k + 0.05, 1.05, 0 }, 0.01, { L, L, L }, { L, 1 / L, 1 });
  }
  const auto image = renderSorted(scene.view(), testCamera(true, 200, 100));
  EXPECT_TRUE(isFinite(image));
  for (int k = -30; k <= 30; k += 10)
  {
    const double L = std::pow(10.0, k);
    check("B", "L from 1e-30 to 1e30", L / pixelArea,
      image.radiance[pixelAt(image, 100 + 2 * k, 50)], 1e-6);
    const std::size_t at = pixelAt(image, 100 + 2 * k, 60);
    for (int c = 0; c < 3; ++c)
    {
      const double t = (c == 0 ? L : c == 1 ? 1 / L : 1) / pixelArea;
      const double expected = L / pixelArea * (t > 0 ? -std::expm1(-t) / t : 1);
      // Below 1e-37 single precision has fewer digits, or none.
      check("B", "and with A from 1e30 to 1e-30", expected > 1e-37 ? expected : 0,
        image.radiance[at + c], expected > 1e-37 ? 2e-6 : 1e-37);
    }
  }
}

TEST(HardCasesLight, WhatHasNoMeaning)
{
  const float nan = std::nanf(""), inf = HUGE_VALF;
  const Scene good = randomScene(300, true);
  const auto clean = drawn(good, 64);
  Scene bad = good;
  std::size_t added = 0;
  for (const float x : { nan, inf, -inf })
  {
    bad.add({ x, 0, 0 }, 1, { 1, 1, 1 });
    bad.add({ 0, 0, x }, 1, { 1, 1, 1 });
    bad.add({ 0, 0, 0 }, x, { 1, 1, 1 });
    bad.add({ 0, 0, 0 }, 1, { x, 1, 1 });
    bad.add({ 0, 0, 0 }, 1, { 1, 1, 1 }, { 0, x, 0 });
    added += 5;
  }
  bad.add({ 0, 0, 0 }, -1, { 1, 1, 1 });
  bad.add({ 0, 0, 0 }, 1, { -1, 1, 1 });
  const auto image = drawn(bad, 64);
  checkSame("C", "NaN, infinite and negative values", clean, image, 0);
  check("C", "and how many are said to be", double(added + 2), double(image.statistics.invalid), 0);
}
/// The picture, and the same of light and cross-sections in other units; both in the first one's.
RenderedImage inUnits(const Scene& scene, const Camera& camera, Accuracy accuracy, int exponent)
{
  Scene other = scene;
  for (float& L : other.emission)
  {
    L = std::ldexp(L, exponent);
  }
  RenderOptions options;
  options.accuracy = accuracy;
  options.allowed = { std::ldexp(1e-4, exponent), 1e-4 };
  auto image = render(other.view(), camera, options);
  for (float& I : image.radiance)
  {
    I = std::ldexp(I, -exponent);
  }
  return image;
}

TEST(HardCasesLight, AnyUnitOfLuminosity)
{
  for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Bounded, Accuracy::Overlapping })
  {
    const Scene scene = randomScene(accuracy == Accuracy::Overlapping ? 300 : 1500, true);
    for (const bool parallel : { true, false })
    {
      const Camera camera = testCamera(parallel, 48, 48);
      const auto once = inUnits(scene, camera, accuracy, 0);
      EXPECT_GT(largest(once.radiance), 0);
      // Up to 3e38 in the picture, and to 3e37 a particle.
      for (const int exponent : { -90, -60, 60, 90, 116 })
      {
        const auto image = inUnits(scene, camera, accuracy, exponent);
        const bool isBounded = accuracy == Accuracy::Bounded;
        checkSame("D", "the same in other units of light", once, image, isBounded ? 2e-4 : 1e-6);
        EXPECT_EQ(image.statistics.drawn, once.statistics.drawn);
        EXPECT_EQ(image.statistics.tooBright, 0U);
      }
    }
  }
}

TEST(HardCasesLight, PhysicalUnitsThroughAFineCamera)
{
  // 1e35 erg/s a particle, at 10 to 1e6 pixels a kpc: what a pixel has is at most 1e38 per kpc^2.
  for (const double scale : { 10.0, 1e3, 1e6 })
  {
    Camera camera = testCamera(true, 16, 16);
    camera.scale = scale;
    const double h = scale > 10 ? 0.3 : 3;
    Scene scene;
    scene.add({ 0, 0, 0 }, h, { 1e35F, 1e35F, 1 });
    scene.add({ 0, 0, 0 }, h, { 1, 0, 0 });
    scene.add({ 0, 0, -1 }, h, { 0, 1e35F, 0 }, { 0, 1e-3F, 0 });
    const auto image = renderSorted(scene.view(), camera);
    const auto exact = renderReference(scene.view(), camera);
    EXPECT_EQ(image.statistics.drawn, 3U);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_GT(light(exact, c), 0);
    }
    check("D", "1e35 a particle", light(exact, 0), light(image, 0), 1e-6);
    check("D", "1e35 a particle, dimmed", light(exact, 1), light(image, 1), 1e-6);
    check("D", "the middle of a kernel", 9 / (pi * h * h) * 1e35, light(image, 0), 0.05);
  }
}

TEST(HardCasesLight, OnlyWhatThePictureCannotHoldIsTooMuch)
{
  Scene scene;
  scene.add({ 0.05, 0.05, 0 }, 1e-3, { 1e38F, 1e36F, 1 });
  const auto image = drawn(scene);
  EXPECT_EQ(light(image, 0), std::numeric_limits<float>::max());
  check("D", "1e36 in one pixel", 1e38, light(image, 1), 1e-6);
  check("D", "beside 1", 100, light(image, 2), 1e-6);
  EXPECT_EQ(image.statistics.tooBright, 1U);
  EXPECT_EQ(renderReference(scene.view(), testCamera(true, 8, 8)).statistics.tooBright, 1U);
}

TEST(HardCasesLight, BrightnessFactorsThatUndoUnits)
{
  // Physical units by a factor, and the other way round; of what shines and of what dims.
  for (const double factor : { 1e-40, 1e-30, 1e30, 1e40 })
  {
    const auto given = static_cast<float>(1 / std::sqrt(factor) / std::sqrt(factor));
    const float L = std::isfinite(given) && given > 0 ? given : factor > 1 ? 1e-38F : 1e38F;
    std::vector<ComponentInfo> components(2);
    components[0].brightness = components[1].brightness = factor;
    components[1].absorbs = true;
    const std::vector<float> position = { 0.05F, 0.05F, 0, 0.05F, 0.05F, 1 }, h = { 1, 1 },
                             intensity = { L, 0.1F * L };
    const std::vector<std::uint8_t> component = { 0, 1 };
    ParticleView view;
    view.size = 2;
    view.position = position.data();
    view.smoothingLength = h.data();
    view.intensity = intensity.data();
    view.component = component.data();
    view.components = &components;
    const auto image = renderSorted(view, testCamera(true, 8, 8));
    const double drawnAs = factor * L;
    Scene plain;
    plain.add({ 0.05, 0.05, 0 }, 1, { 1, 1, 1 });
    const double peak = light(drawn(plain));
    EXPECT_EQ(image.statistics.drawn, 2U);
    check(
      "D", "brightness undoes the unit, T", std::exp(-0.1 * drawnAs * peak), through(image), 1e-5);
    check("D", "brightness undoes the unit", drawnAs * peak * std::exp(-0.1 * drawnAs * peak),
      light(image), 1e-5);
  }
}

TEST(HardCasesLight, AnyCrossSection)
{
  // A slab of any cross-section has its source's light where it is opaque, and dims what is behind.
  for (const float K : { 1e4F, 1e10F, 1e30F, 3.4e38F })
  {
    Scene scene;
    scene.add({ 0.05, 0.05, -1 }, 3, { 1, 1, 1 });
    scene.add({ 0.05, 0.05, 0 }, 3, { 0.25F * K, 1e-10F * K, 0 }, { K, K, K });
    const auto image = drawn(scene);
    EXPECT_EQ(image.statistics.drawn, 2U);
    check("E", "source of an opaque slab", 0.25, light(image, 0), 1e-6);
    check("E", "and of a dark one", 1e-10, light(image, 1), 1e-6);
    check("E", "and behind it", 0, light(image, 2), 0);
    check("E", "nothing comes through", 0, through(image), 0);
  }
}

TEST(HardCasesLight, VeryThickAbsorbersLetThroughWhatTheirEdgesDo)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Kernel kernel : kernels)
  {
    for (const double h : { 0.002, 0.03, 0.2, 0.45, 1.0, 5.0 })
    {
      for (const double depth : { 1e3, 1e4, 1e6, 1e9 })
      {
        Scene dark;
        for (int k = 0; k < 3; ++k)
        {
          const auto K = static_cast<float>(depth * std::max(h * h, 0.01));
          dark.add({ 1.5 * uniform(random), 1.5 * uniform(random), k - 1.0 }, h, {},
            { K, 0.1F * K, 0.01F * K });
        }
        Scene lit = dark;
        lit.add({ 0, 0, -9 }, 4, { 1, 1, 1 });
        RenderOptions options;
        options.kernel = kernel;
        for (const bool parallel : { true, false })
        {
          const Camera camera = testCamera(parallel, 40, 40);
          for (const Scene* scene : { &dark, &lit })
          {
            const auto image = renderSorted(scene->view(), camera, options);
            const auto exact = renderReference(scene->view(), camera, options);
            const double most = std::max(largest(exact.radiance), 1e-30);
            EXPECT_LT(largestDifference(image.transmittance, exact.transmittance), 2e-5)
              << h << ' ' << depth << ' ' << parallel;
            EXPECT_LT(largestDifference(image.radiance, exact.radiance), 2e-5 * most)
              << h << ' ' << depth << ' ' << parallel;
          }
        }
      }
    }
  }
}

TEST(HardCasesLight, NothingIsNegativeAndNothingShinesThroughMoreThanAll)
{
  for (const bool parallel : { true, false })
  {
    for (const Kernel kernel : kernels)
    {
      for (const unsigned seed : { 1U, 2U, 3U })
      {
        Scene scene = randomScene(3000, seed != 3, seed);
        Camera camera = testCamera(parallel, 96, 96);
        camera.eye.z = seed == 2 ? 2 : 100; // among them
        RenderOptions options;
        options.kernel = kernel;
        options.allowed = { 1e-4, 1e-4 };
        for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Bounded, Accuracy::Preview })
        {
          options.accuracy = accuracy;
          const auto image = render(scene.view(), camera, options);
          EXPECT_GE(*std::min_element(image.radiance.begin(), image.radiance.end()), 0);
          EXPECT_GE(*std::min_element(image.transmittance.begin(), image.transmittance.end()), 0);
          EXPECT_LE(largest(image.transmittance), 1);
        }
      }
    }
  }
}
} // namespace
