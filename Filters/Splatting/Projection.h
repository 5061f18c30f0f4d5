#ifndef galaxy_Projection_h
#define galaxy_Projection_h

#include "Filters/Splatting/Render.h"

namespace galaxy
{
/// What a particle emits and absorbs, per channel.
struct ParticleLight
{
  float L[3]; ///< luminosity
  float K[3]; ///< absorption cross-section, kpc^2
  bool valid() const;
  double most() const; ///< the largest of the six
  bool emits() const { return this->L[0] > 0 || this->L[1] > 0 || this->L[2] > 0; }
  bool absorbs() const { return this->K[0] > 0 || this->K[1] > 0 || this->K[2] > 0; }
  bool grey() const { return this->K[0] == this->K[1] && this->K[1] == this->K[2]; }
};

/// A particle on the image plane, ready to be composited.
struct Splat
{
  int column, row; ///< the pixel that holds the centre, counted from the corner of the tile
  float x, y;      ///< the centre in it, 0 to 1: float then has digits for the smallest particle
  float h;         ///< radius of the footprint, pixels
  float depth;     ///< kpc: distance (perspective) or depth (parallel)
  float e[3];      ///< luminosity / (pixel area at the particle in kpc^2)
  float t[3];      ///< cross-section / (pixel area at the particle in kpc^2)
  bool absorbs() const { return this->t[0] > 0 || this->t[1] > 0 || this->t[2] > 0; }
};

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelBox
{
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return this->x0 >= this->x1 || this->y0 >= this->y1; }
};

struct ProjectionCounts
{
  std::size_t drawn = 0;
  std::size_t culled = 0;
  std::size_t invalid = 0;
  std::size_t emitters = 0;
  std::size_t absorbers = 0;
  std::size_t colored = 0; ///< absorbers whose channels differ
  ProjectionCounts& operator+=(const ProjectionCounts& other);
};

/// Particles seen through a camera.
class Projection
{
public:
  Projection(const ParticleView& particles, const Camera& camera);

  std::size_t size() const { return this->particles.size; }

  /// The pixels that particle i may touch (none unless it is to be drawn), and into which of the
  /// counts it falls.
  PixelBox classify(std::size_t i, ProjectionCounts& counts) const;

  /// A particle that classify() wants drawn, relative to the lower left corner (x, y) of a tile.
  Splat splat(std::size_t i, int x, int y) const;

  /// Asks for particle i's data ahead of its use.
  void prefetch(std::size_t i) const;

  /// What particle i emits and absorbs as drawn: overrides and component factors applied.
  ParticleLight light(std::size_t i) const;

  /// The smoothing length drawn, kpc.
  double radius(std::size_t i) const;

  /// False for what has no place or size, or light below nothing.
  bool valid(std::size_t i, const ParticleLight& light) const;

  /// Whether the particle's component exists and is shown.
  bool visible(std::size_t i) const;

private:
  /// Double precision, since a camera may be megaparsecs from the origin.
  struct Place
  {
    Vec3 seen;    ///< kpc to the right, up and into the scene, from the eye
    double ratio; ///< pixels per kpc at the particle
    double x, y;  ///< pixels
    double h;     ///< pixels
  };
  Place place(std::size_t i) const;

  /// A component's part of the light, with everything that does not differ between its particles
  /// multiplied together.
  struct Factors
  {
    double size = 1;
    float brightness = 1;
    float emission = 1.0f / 255;       ///< per unit of Intensity times Color; 0 for absorbers
    float absorption[3] = { 0, 0, 0 }; ///< per unit of Intensity; 0 for emitters
    bool visible = true;
  };
  const Factors& factors(std::size_t i) const;

  ParticleView particles;
  Camera camera;
  std::vector<Factors> table;
  /// Floats from one particle to the next and from one channel to the next.
  std::size_t emissionStride, emissionStep, absorptionStride, absorptionStep;
};
} // namespace galaxy

#endif
