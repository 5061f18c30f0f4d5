#ifndef galaxy_DrawnLayer_h
#define galaxy_DrawnLayer_h

#include "Filters/Model/Particles.h"
#include "Filters/Model/PixelFill.h"
#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <array>
#include <cstddef>
#include <vector>

namespace galaxy
{
/// The rms height of a layer's light about a radius, kpc: the particles' heights and their kernels,
/// and what the model says.
struct LayerHeight
{
  double radius = 0;
  double drawn = 0;
  double model = 0;
};

/// A disc's layer as it is drawn. A particle is not a point: its Gaussian kernel of smoothing
/// length h has the variance h^2/18 along every axis, and the layer that is seen is that much
/// thicker than the heights of its particles. So that it is as thick as its model, of variance V,
/// heights are shrunk by sqrt(1 - h^2/(18 V)). Where that would leave less than half of them,
/// smoothing lengths that follow from the density are lowered, though not so far that the disc
/// falls apart into dots: not below 1.5 times the distance of particles in its plane, nor the least
/// one asked for.
class DrawnLayer
{
public:
  /// Of a component whose particles will be drawn `size` times as large as their h.
  DrawnLayer(
    const TiltedDisk& disk, const ComponentDescription& component, double inner, double outer);

  /// Lowers smoothing lengths and heights of the particles from first to last - 1.
  void settle(Particles& particles, std::size_t first, std::size_t last);
  /// Smoothing lengths alone.
  void lower(Particles& particles, std::size_t first, std::size_t last) const;
  /// The law, and its heights as settle() has left them.
  VerticalLayer layer() const;
  /// By radius, each by its light.
  std::vector<LayerHeight> heights(
    const Particles& particles, std::size_t first, std::size_t last) const;

private:
  static constexpr int bins = 8;
  /// What is counted in every range of radii.
  using Sums = std::array<std::array<double, 4>, bins>;

  /// Where a particle stands over the disc.
  struct Place
  {
    Vec3 normal;
    double r = 0;
    double z = 0;
    double variance = 0; ///< of the model there, kpc^2
  };
  Place placeOf(const float* position, std::size_t& near) const;
  float lowered(float h, double variance) const;
  double kernelVariance(float h) const { return this->size * this->size * h * h / 18; }
  double shareLeft(float h, double variance) const;
  int binOf(double r) const;
  template <class Count>
  Sums summed(std::size_t first, std::size_t last, const Count& count) const;

  /// The disc at a radius.
  struct Row
  {
    Vec3 normal;
    double variance;
  };
  Row rowAt(double r, std::size_t& near) const;

  VerticalLayer law;
  double inner, outer, size;
  std::vector<double> knots; ///< radii; the disc is smooth in between
  std::size_t rowsBetween;   ///< two of them
  std::vector<Row> rows;
  bool follows;                  ///< smoothing lengths follow from the density
  double leastShare;             ///< of such a one
  float minimum;                 ///< kpc
  std::array<double, bins> left; ///< of the heights, on average
};

/// The vertical layer that a disc component's description means.
VerticalLayer layerOf(const ComponentDescription& component, const TiltedDisk& disk);
} // namespace galaxy

#endif
