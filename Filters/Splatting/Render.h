#ifndef galaxy_Render_h
#define galaxy_Render_h

#include "Filters/Model/Particles.h"
#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/RenderStatistics.h"
#include "Readers/Formats/Progress.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace galaxy
{
/// The radial profile of a particle, normalised to 1 in projection.
enum class Kernel
{
  Gaussian,    ///< along each axis exp(-x^2/sigma^2) - exp(-9), sigma = h/3, zero beyond h
  CubicSpline, ///< line integral of the M4 spline of support h
};

/// Particles to draw, seen in place. Either `intensity` and `color` with a component table, or
/// `emission` and `absorption` (each may be null: not simulated), or a mixture: where `emission`
/// or `absorption` is given it replaces what intensity and colour would say.
struct ParticleView
{
  std::size_t size = 0;
  const float* position = nullptr;         ///< 3 N, kpc
  const float* smoothingLength = nullptr;  ///< N, kpc
  const float* intensity = nullptr;        ///< N
  const std::uint8_t* color = nullptr;     ///< 3 N, null: white
  const std::uint8_t* component = nullptr; ///< N, null: all of component 0
  const float* emission = nullptr;         ///< emissionChannels x N: luminosity
  const float* absorption = nullptr;       ///< absorptionChannels x N: cross-section, kpc^2
  int emissionChannels = 3;                ///< 1 (grey) or 3
  int absorptionChannels = 3;              ///< 1 (grey) or 3
  /// How many particles like itself each of them stands for; with more than one, absorbers are
  /// drawn as SpreadAbsorbers.
  double weight = 1;
  const std::vector<ComponentInfo>* components = nullptr; ///< null: one emitting component
  const std::vector<bool>* visible = nullptr;             ///< per component; null: all
};

/// What is computed of the optical model, from the most to the least.
enum class Accuracy
{
  Overlapping, ///< overlapping particles share their path: the transfer integral by depth slices
  Sorted,      ///< one slab a particle, in strict order of the centres
  Bounded,     ///< the same within an error that the options allow
  Preview,     ///< the same of a random part of the particles
};

struct RenderMemory;

/// How to draw; none of it changes what the particles are.
struct RenderOptions
{
  Kernel kernel = Kernel::Gaussian;
  Accuracy accuracy = Accuracy::Sorted;
  /// Overlapping: slices to the sigma (a third of the smoothing length) of the smallest absorber
  /// in a tile; the error falls with their square.
  double slices = 4;
  ErrorBound allowed;       ///< Bounded: both errors may come together
  double previewTime = 0.1; ///< Preview: seconds
  /// Per pixel, the distance (perspective) or depth (parallel) in kpc of opaque geometry; what
  /// lies behind it is not seen. Null: nothing opaque.
  const float* opaqueDepth = nullptr;
  /// Kept from picture to picture, it saves what asking the system for memory costs. Null: asked
  /// for anew.
  RenderMemory* memory = nullptr;
  Progress progress; ///< what it ends leaves an empty picture
};

/// A finished picture in linear light, rows from the bottom up.
struct RenderedImage
{
  int width = 0;
  int height = 0;
  bool aborted = false;        ///< then the picture is empty
  std::vector<float> radiance; ///< 3 per pixel, luminosity per kpc^2: the pixel's mean over black
  std::vector<float>
    transmittance; ///< 3 per pixel: the share of a light behind everything that arrives
  RenderStatistics statistics;
};

/// Draws at the level that the options name.
RenderedImage render(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options = {});

/// Accuracy level `Sorted`, the paper's model: one slab a particle, in strict order of the centres'
/// distance (parallel projection: depth; ties by place, in one place by index), every particle and
/// channel, by the update I <- I exp(-t) + e phi(t). Identical for any number of threads.
RenderedImage renderSorted(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options = {});

/// The reference with the particles of every pixel in the order in which its own ray passes them,
/// instead of that of their centres' distance: in a parallel projection the same. Slow, and much
/// memory: for a few thousand particles and pixels.
RenderedImage renderInOrderOfRays(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options = {});

/// Accuracy level `Bounded`: renderSorted's picture within `options.allowed`, proven tile by tile
/// from the sums of what is left out: the faintest emitters, which all over one pixel have no more
/// than half of `allowed.light`; what lies behind dust, where it lets no more than the other half
/// through; the thinnest absorbers, and the order of the others where they are thin, which together
/// change light by no more than half of `allowed.share`.
RenderedImage renderBounded(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options = {});

/// Accuracy level `Overlapping`: particles that overlap share their path. With rho the particles'
/// profiles along a pixel's ray, Gaussians of sigma = h/3 about the point of the ray nearest to the
/// centre (for CubicSpline those of the same variance),
///   I = int E(x) exp(-int_x^observer A) dx,  E = sum e_p rho_p,  A = sum t_p rho_p,
/// by slices of depth in each of which emission and absorption are mixed evenly: slices of uniform
/// thickness in a tile, whose error falls with the square of that. Double precision.
RenderedImage renderOverlapping(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options = {});

/// The same picture as renderSorted's in double precision, particle by particle over whole
/// footprints, without tiles or tables: what renderSorted is tested against. For small scenes.
RenderedImage renderReference(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options = {});
} // namespace galaxy

#endif
