#ifndef galaxy_LightMap_h
#define galaxy_LightMap_h

#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/SkyImage.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace galaxy
{
/// One image of a component and how it counts.
struct SeedLayer
{
  const SkyImage* image;
  /// From the image's value at (X, Y) kpc to the intensity, such as an IntensityScale.
  std::function<double(double value, double x, double y)> scale;
  double threshold; ///< lower intensities count as none
  double weight;
  Color color;
};

/// What a component should look like from Earth: the sum of its layers, pixel by pixel.
///
/// A pixel of layers with intensities I_k and colours RGB_k has the colour sum_k weight_k I_k
/// RGB_k: its largest channel is the pixel's intensity I_p, the ratio its 8-bit colour. (An
/// absorber's intensity is sum_k weight_k I_k.) The flux F_p is I_p times the pixel's area on the
/// sky (kpc^2, in the plane through the galaxy's centre).
///
/// The pixels are those of the layer with the smallest, over the part of the sky that any layer
/// shows within `radius`; layers of larger pixels are interpolated.
class LightMap
{
public:
  /// What pixelAt gives off the map.
  static constexpr std::uint32_t nowhere = 0xffffffff;
  /// Changes a pixel's colour (3 channels in linear light, its intensity the largest) at (X, Y).
  using ChangeColor = std::function<void(double x, double y, Color& color)>;

  /// Throws Error (file, component) where the map would have more than 2^26 pixels.
  LightMap(const std::vector<SeedLayer>& layers, const ComponentDescription& component,
    double radius, const std::string& file, const ChangeColor& change = {});

  std::size_t size() const { return this->fluxes.size(); }
  int width() const { return this->columns; }
  int height() const { return this->rows; }

  /// Row times width plus column; `nowhere` off the map.
  std::uint32_t pixelAt(double x, double y) const
  {
    const PixelPosition at = this->toPixel.at(x, y);
    const double u = (at.x - 0.5) * this->perBin, v = (at.y - 0.5) * this->perBin;
    return u >= 0 && v >= 0 && u < this->columns && v < this->rows
      ? static_cast<std::uint32_t>(v) * this->columns + static_cast<std::uint32_t>(u)
      : nowhere;
  }
  /// The point (X, Y) kpc at the fractions (u, v), 0 to 1, of a pixel's sides.
  PixelPosition pointIn(std::uint32_t pixel, double u, double v) const
  {
    const double bin = this->binning;
    return this->toPlane.at(
      0.5 + bin * (pixel % this->columns + u), 0.5 + bin * (pixel / this->columns + v));
  }

  float flux(std::uint32_t pixel) const { return this->fluxes[pixel]; }
  float intensity(std::uint32_t pixel) const { return this->intensities[pixel]; }
  const std::uint8_t* color(std::uint32_t pixel) const { return &this->colors[3 * pixel]; }
  /// The flux of all pixels.
  double totalFlux() const;
  /// The flux of what the layers, of which the map was made, show beyond it: of its pixels, went it
  /// on, of every n-th along both axes where they would be more than 2^24.
  double fluxBeyond(const std::vector<SeedLayer>& layers, const ChangeColor& change = {}) const;
  /// The flux of those whose middle shows the disc.
  double fluxOn(const DiskInverse& disk) const;
  /// Whether a pixel has light and its middle shows the disc.
  bool isLitOn(const DiskInverse& disk, std::uint32_t pixel) const;
  /// How many do.
  std::size_t litPixels(const DiskInverse& disk) const;
  /// Side of a pixel in the middle of the map, kpc.
  double pixelSide() const { return this->side; }
  /// Pixels of the images along a side of one of the map.
  int bins() const { return this->binning; }

  /// Takes some of a pixel's flux away.
  void take(std::uint32_t pixel, float flux);
  /// Joins pixels by 2 x 2, their fluxes added, for models of few particles.
  void halve();

private:
  /// A pixel as its light is.
  struct Lit
  {
    double intensity;
    double flux; ///< 0 where it is none
    std::array<std::uint8_t, 3> ratios;
  };

  explicit LightMap(bool absorbs)
    : absorbs(absorbs)
  {
  }
  void chooseGrid(const std::vector<SeedLayer>& layers, double radius);
  void fill(const std::vector<SeedLayer>& layers, const ChangeColor& change);
  Lit litAt(const std::vector<SeedLayer>& layers, const std::vector<bool>& isCoarse,
    const ChangeColor& change, int column, int row) const;
  /// Whether the map's light is that of a pixel with this middle; on the border it is.
  bool reaches(const PixelPosition& at) const
  {
    const double most = this->reach + borderWidth * this->side;
    return std::abs(at.x) <= most && std::abs(at.y) <= most;
  }
  std::vector<bool> coarseOnes(const std::vector<SeedLayer>& layers) const;
  Color colorAt(const std::vector<SeedLayer>& layers, const std::vector<bool>& isCoarse, double x,
    double y, double& total) const;

  bool absorbs;
  double reach = 0; ///< kpc, the radius it was made for
  SkyGrid grid;
  SkyFrame frame{ { 0, 0 }, 1 };
  PixelLattice toPixel; ///< of the grid, from (X, Y)
  PixelLattice toPlane; ///< and back
  PixelLattice areas;   ///< of the pixels, kpc^2 (x alone), from the grid
  int columns = 0;
  int rows = 0;
  int binning = 1;
  double perBin = 1; ///< its inverse
  double side = 0;
  std::vector<float> fluxes;
  std::vector<float> intensities;
  std::vector<std::uint8_t> colors; ///< 3 a pixel
};

/// A colour as intensity, its largest channel, and 8-bit ratios to that.
struct ShownColor
{
  double intensity;
  std::array<std::uint8_t, 3> ratios;
};
ShownColor shownColor(const Color& color);
} // namespace galaxy

#endif
