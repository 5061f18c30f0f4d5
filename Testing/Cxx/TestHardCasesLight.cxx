// Hard cases of drawing, numbered as in the other TestHardCases files; those without a number are
// letters. Each adds a line to a table, which is printed at the end.
#include "Filters/Splatting/GaussianKernel.h"
#include "HardCaseTable.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

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
} // namespace
