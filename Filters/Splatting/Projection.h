#ifndef galaxy_Projection_h
#define galaxy_Projection_h

#include "Filters/Splatting/Lens.h"
#include "Filters/Splatting/NearParticle.h"
#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/Splat.h"
#include "Filters/Splatting/TileGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
struct BlockLights;

/// What a particle emits and absorbs, per channel.
struct ParticleLight
{
  float L[3]; ///< luminosity
  float K[3]; ///< absorption cross-section, kpc^2
  /// Finite and nothing negative.
  bool valid() const
  {
    // NaN fails every comparison, and infinity is larger than any number.
    bool is = true;
    for (int c = 0; c < 3; ++c)
    {
      is &= this->L[c] >= 0 && this->L[c] <= std::numeric_limits<float>::max();
      is &= this->K[c] >= 0 && this->K[c] <= std::numeric_limits<float>::max();
    }
    return is;
  }
  bool emits() const { return this->L[0] > 0 || this->L[1] > 0 || this->L[2] > 0; }
  bool absorbs() const { return this->K[0] > 0 || this->K[1] > 0 || this->K[2] > 0; }
  bool grey() const { return this->K[0] == this->K[1] && this->K[1] == this->K[2]; }
};

/// Powers of two that light and cross-sections are counted in, so that single precision holds them
/// in any unit; only what is too small beside the others is lost. They are exact: pictures do not
/// hang on them.
struct LightScale
{
  int light = 0, depth = 0; ///< of what Projection::light() gives
  int area = 0;             ///< of luminosity over the pixels' area, beside those
};

/// So many consecutive particles are projected together.
constexpr int particlesAtOnce = 1024;

/// Particles seen through a lens.
class Projection
{
public:
  Projection(const ParticleView& particles, const Lens& lens);

  std::size_t size() const { return this->particles.size; }

  /// The pixels that particle i may touch (none unless it is to be drawn), and into which of the
  /// counts it falls.
  PixelBox classify(std::size_t i, ParticleCounts& counts) const;

  const float* position(std::size_t i) const { return this->particles.position + 3 * i; }

  /// The smoothing lengths drawn of particles i and on, kpc: in place, or in `scaled` where
  /// components have factors.
  const float* radii(std::size_t i, int count, float* scaled) const;

  /// What particle i emits and absorbs as drawn, in lightUnit() and depthUnit(): overrides and
  /// component factors applied.
  ParticleLight light(std::size_t i) const
  {
    const ParticleView& p = this->particles;
    const Factors& f = this->factors(i);
    const float I = p.intensity ? p.intensity[i] : 0;
    ParticleLight light;
    for (int c = 0; c < 3; ++c)
    {
      const int color = p.color && !f.isRecolored ? p.color[3 * i + c] : 255;
      light.L[c] = p.emission
        ? f.light * p.emission[this->emissionStride * i + this->emissionStep * c]
        : f.emission[c] * I * color;
      light.K[c] = p.absorption
        ? f.opacity * p.absorption[this->absorptionStride * i + this->absorptionStep * c]
        : f.absorption[c] * I;
    }
    return light;
  }

  /// Asks memory for particle i.
  void fetch(std::size_t i) const
  {
    const ParticleView& p = this->particles;
    __builtin_prefetch(p.position + 3 * i);
    __builtin_prefetch(p.smoothingLength + i);
    const auto fetchFrom = [](const float* values, std::size_t at) {
      if (values)
      {
        __builtin_prefetch(values + at);
      }
    };
    fetchFrom(p.intensity, i);
    fetchFrom(p.emission, this->emissionStride * i);
    fetchFrom(p.absorption, this->absorptionStride * i);
  }

  /// The same of the particles first + which[k].
  void light(std::size_t first, const std::uint32_t* which, int count, BlockLights& lights) const;

  /// Of a splat of kind Slab or Near.
  SlabLight slab(const Splat& splat) const
  {
    const SlabName name = SlabName::of(splat);
    const ParticleLight light = this->light(name.particle);
    SlabLight slab;
    for (int c = 0; c < 3; ++c)
    {
      slab.e[c] = light.L[c] * name.lightArea;
      slab.t[c] = light.K[c] * name.depthArea;
      if (slab.t[c] > mostDepth)
      {
        // As opaque, and as bright by its source.
        const double depth = double(light.K[c]) * name.depthArea;
        slab.e[c] = static_cast<float>(slab.e[c] * (mostDepth / depth));
        slab.t[c] = mostDepth;
      }
    }
    return slab;
  }
  /// An optical depth over a pixel that is opaque however far a footprint spreads it.
  static constexpr float mostDepth = 1e34F;
  /// In a pixel, from here on an absorber's edge is seen: it is drawn in double precision.
  static constexpr float thick = 32;

  double lightUnit() const { return std::ldexp(1.0, this->scale.light); }
  double depthUnit() const { return std::ldexp(1.0, this->scale.depth); }
  /// What splats' luminosities over a pixel's area are counted in.
  double splatUnit() const { return std::ldexp(1.0, this->scale.light + this->scale.area); }

  /// Whether single precision holds light and cross-sections as they are counted, the brightest
  /// splat's light being so much, if there is any.
  bool holds(float brightest, bool hasLight) const;
  /// Counts it so that it does, after a look at all particles.
  void fitLight();

  /// Of any splat.
  SlabLight lightOf(const Splat& splat) const
  {
    const float* l = splat.light;
    switch (splat.kind())
    {
      case SplatKind::Emits:
        return { { l[0], l[1], l[2] }, {} };
      case SplatKind::Absorbs:
        return { {}, { l[0], l[1], l[2] } };
      case SplatKind::Slab:
      case SplatKind::Near:
        break;
    }
    return this->slab(splat);
  }
  /// The smoothing length drawn, kpc.
  double radius(std::size_t i) const;

  /// The distance (perspective) or depth (parallel) of particle i, kpc.
  double depth(std::size_t i) const
  {
    const float* p = this->position(i);
    const Camera& camera = this->eye.camera();
    const Vec3 d = Vec3{ p[0], p[1], p[2] } - camera.eye;
    return camera.parallel ? dot(d, camera.forward) : length(d);
  }

  /// Whether, of two particles at the same depth, i lies before j: by their places, so that it does
  /// not hang on how they are numbered; in one place the last.
  bool isBeforeAtSameDepth(std::size_t i, std::size_t j) const;

  /// How long a pixel is at particle i, kpc; 0 behind the eye.
  double pixelAt(std::size_t i) const;

  /// False for what has no place or size, or light below nothing.
  bool valid(std::size_t i, const ParticleLight& light) const;

  /// A splat of kind Near.
  NearParticle near(const Splat& splat) const { return this->near(SlabName::of(splat).particle); }
  NearParticle near(std::size_t i) const
  {
    const float* p = this->position(i);
    return { { p[0], p[1], p[2] }, this->radius(i), this->eye };
  }
  const Lens& lens() const { return this->eye; }

  /// Whether the particle's component is shown.
  bool visible(std::size_t i) const { return !this->hasHidden || this->factors(i).visible; }

  /// A particle on the image plane, in double precision, since a camera may be megaparsecs from the
  /// origin.
  struct Place
  {
    Vec3 seen;           ///< kpc to the right, up and into the scene, from the eye
    bool isNear = false; ///< a NearParticle, on every pixel
    double x = 0, y = 0; ///< pixels
    double h = 0;        ///< pixels
    double ratio = 0;    ///< pixels of h per kpc; 0 of what is not before the eye
  };
  Place placeOf(std::size_t i) const;

private:
  /// A component's part of the light, with everything that does not differ between its particles
  /// multiplied together.
  struct Factors
  {
    double size = 1;
    float light = 1, opacity = 1; ///< on what Emission and Absorption say
    /// Per unit of Intensity times Color; 0 for absorbers.
    float emission[3] = { 1.0F / 255, 1.0F / 255, 1.0F / 255 };
    float absorption[3] = { 0, 0, 0 }; ///< per unit of Intensity; 0 for emitters
    bool isRecolored = false;          ///< as if Color were white
    bool visible = true;

    Factors() = default;
    Factors(const ComponentInfo& component, double weight, const LightScale& scale);
  };
  const Factors& factors(std::size_t i) const
  {
    const std::size_t k = this->particles.component ? this->particles.component[i] : 0;
    return this->table[std::min(k, this->table.size() - 1)];
  }

  /// The components' factors, as the scale has them.
  void makeTable();

  ParticleView particles;
  Lens eye;
  LightScale scale;
  int lightFactor = 0, depthFactor = 0; ///< exponents of the largest factors
  bool isFitted = false;
  std::vector<Factors> table;
  bool hasSizes = false;  ///< some component's size is not 1
  bool hasHidden = false; ///< some component is not shown
  /// Floats from one particle to the next and from one channel to the next.
  std::size_t emissionStride, emissionStep, absorptionStride, absorptionStep;
};
} // namespace galaxy

#endif
