#include "Filters/Model/LightMap.h"

#include "Filters/Model/BlockSum.h"
#include "Filters/Model/ParallelFor.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace galaxy
{
namespace
{
/// Layers whose pixels are larger than the map's by this are interpolated; rounding does not decide
/// of 6 against 5 arcsec.
constexpr double coarse = 1.2 * (1 + 1e-6);

PlaneBox unionOf(const std::vector<SeedLayer>& layers)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  PlaneBox box = { far, far, -far, -far };
  for (const SeedLayer& layer : layers)
  {
    const PlaneBox& one = layer.image->extent();
    box.left = std::min(box.left, one.left);
    box.bottom = std::min(box.bottom, one.bottom);
    box.right = std::max(box.right, one.right);
    box.top = std::max(box.top, one.top);
  }
  return box;
}

/// The image with the smallest pixels; of equal ones the first.
const SkyImage& finestOf(const std::vector<SeedLayer>& layers)
{
  const SkyImage* finest = layers.front().image;
  for (const SeedLayer& layer : layers)
  {
    if (layer.image->pixelSide() < finest->pixelSide() * (1 - 1e-6))
    {
      finest = layer.image;
    }
  }
  return *finest;
}

/// The first and last whole pixels, along both axes, of what a box shows of an image's plane.
struct PixelBox
{
  double left = std::numeric_limits<double>::infinity();
  double bottom = left, right = -left, top = -left;
};

PixelBox pixelsOf(const PlaneBox& box, const SkyImage& image)
{
  constexpr int probes = 64;
  PixelBox pixels;
  for (int v = 0; v <= probes; ++v)
  {
    for (int u = 0; u <= probes; ++u)
    {
      const PixelPosition at = image.exactPixelAt(box.left + (box.right - box.left) * u / probes,
        box.bottom + (box.top - box.bottom) * v / probes);
      if (std::isfinite(at.x) && std::isfinite(at.y))
      {
        const double column = pixelIndex(at.x) + 1, row = pixelIndex(at.y) + 1;
        pixels.left = std::min(pixels.left, column);
        pixels.right = std::max(pixels.right, column);
        pixels.bottom = std::min(pixels.bottom, row);
        pixels.top = std::max(pixels.top, row);
      }
    }
  }
  return pixels;
}
} // namespace

ShownColor shownColor(const Color& color)
{
  ShownColor shown{ *std::max_element(color.begin(), color.end()), { 0, 0, 0 } };
  for (int c = 0; c < 3 && shown.intensity > 0; ++c)
  {
    const double ratio = std::clamp(color[c] / shown.intensity, 0.0, 1.0);
    // A half, as 0.3 of 255 leaves, goes up whatever its last bit.
    shown.ratios[c] = static_cast<std::uint8_t>(255 * ratio + 0.5 + 1e-6);
  }
  return shown;
}

LightMap::LightMap(const std::vector<SeedLayer>& layers, const ComponentDescription& component,
  double radius, const std::string& file, const ChangeColor& change)
  : absorbs(component.role == ComponentRole::Absorbs)
{
  this->chooseGrid(layers, radius);
  if (!(static_cast<double>(this->columns) * this->rows <= 0x1p26))
  {
    throw Error(file, component.name,
      "layers: its smallest pixels over all that its images show would be more than 67 million; "
      "give the wide image a component of its own, or a smaller outer_radius");
  }
  this->fill(layers, change);
}

void LightMap::chooseGrid(const std::vector<SeedLayer>& layers, double radius)
{
  this->reach = radius;
  const SkyImage& finest = finestOf(layers);
  PlaneBox box = unionOf(layers);
  box = { std::max(box.left, -radius), std::max(box.bottom, -radius), std::min(box.right, radius),
    std::min(box.top, radius) };
  if (!(box.right > box.left && box.top > box.bottom))
  {
    return;
  }
  const PixelBox pixels = pixelsOf(box, finest);
  if (!(pixels.right >= pixels.left && pixels.top >= pixels.bottom))
  {
    return;
  }
  const double width = pixels.right - pixels.left + 1, height = pixels.top - pixels.bottom + 1;
  this->grid = finest.grid();
  this->grid.width = this->columns = static_cast<int>(std::min(width, 0x1p30));
  this->grid.height = this->rows = static_cast<int>(std::min(height, 0x1p30));
  this->grid.shift.x -= pixels.left - 1;
  this->grid.shift.y -= pixels.bottom - 1;
  this->frame = finest.skyFrame();
  this->side = finest.pixelSide();
  const auto exactPixel = [this](double x, double y) {
    PixelPosition pixel;
    return this->grid.skyToPixel(this->frame.planeToSky(x, y), pixel) ? pixel
                                                                      : PixelLattice::nowhere();
  };
  // Not rounded: particles lie as near to the borders of pixels as chance puts them.
  this->toPixel = PixelLattice(box.left, box.bottom, box.right, box.top, exactPixel, 0.001, 0);
  const auto exactPoint = [this](double column, double row) {
    SkyPosition sky;
    double x, y;
    return this->grid.pixelToSky({ column, row }, sky) && this->frame.skyToPlane(sky, x, y)
      ? PixelPosition{ x, y }
      : PixelLattice::nowhere();
  };
  const double right = this->columns + 0.5, top = this->rows + 0.5;
  this->toPlane = PixelLattice(0.5, 0.5, right, top, exactPoint, 0.001 * this->side);
  // Of the quadrangle of a pixel's corners, by its diagonals.
  const auto exactArea = [&exactPoint](double column, double row) {
    const PixelPosition a = exactPoint(column - 0.5, row - 0.5);
    const PixelPosition b = exactPoint(column + 0.5, row - 0.5);
    const PixelPosition c = exactPoint(column + 0.5, row + 0.5);
    const PixelPosition d = exactPoint(column - 0.5, row + 0.5);
    const double twice = (c.x - a.x) * (d.y - b.y) - (c.y - a.y) * (d.x - b.x);
    return PixelPosition{ 0.5 * std::abs(twice), 0 };
  };
  // Differences of near points have larger last bits.
  this->areas = PixelLattice(0.5, 0.5, right, top, exactArea, 1e-6 * this->side * this->side, 0.25);
}

Color LightMap::colorAt(const std::vector<SeedLayer>& layers, const std::vector<bool>& isCoarse,
  double x, double y, double& total) const
{
  Color color = { 0, 0, 0 };
  total = 0;
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    const SeedLayer& layer = layers[k];
    const double value = isCoarse[k] ? layer.image->smoothValue(x, y) : layer.image->value(x, y);
    const double intensity = layer.scale(value, x, y);
    if (intensity > 0 && intensity >= layer.threshold)
    {
      total += layer.weight * intensity;
      for (int c = 0; c < 3; ++c)
      {
        color[c] += layer.weight * intensity * layer.color[c];
      }
    }
  }
  return color;
}

std::vector<bool> LightMap::coarseOnes(const std::vector<SeedLayer>& layers) const
{
  std::vector<bool> isCoarse;
  for (const SeedLayer& layer : layers)
  {
    isCoarse.push_back(layer.image->pixelSide() > coarse * this->side);
  }
  return isCoarse;
}

LightMap::Lit LightMap::litAt(const std::vector<SeedLayer>& layers,
  const std::vector<bool>& isCoarse, const ChangeColor& change, int column, int row) const
{
  const PixelPosition at = this->toPlane.at(column + 1, row + 1);
  double total;
  Color color = this->colorAt(layers, isCoarse, at.x, at.y, total);
  if (change && total > 0)
  {
    change(at.x, at.y, color);
  }
  const ShownColor shown = shownColor(color);
  const double intensity = this->absorbs ? total : shown.intensity;
  const double flux = intensity * this->areas.at(column + 1, row + 1).x;
  return { intensity, flux > 0 && std::isfinite(flux) ? flux : 0, shown.ratios };
}

void LightMap::fill(const std::vector<SeedLayer>& layers, const ChangeColor& change)
{
  const std::size_t pixels = static_cast<std::size_t>(this->columns) * this->rows;
  this->fluxes.assign(pixels, 0);
  this->intensities.assign(pixels, 0);
  this->colors.assign(3 * pixels, 0);
  const std::vector<bool> isCoarse = this->coarseOnes(layers);
  parallelForDynamic(std::size_t(0), pixels, 4096, [&](std::size_t pixel) {
    const auto column = static_cast<int>(pixel % this->columns);
    const auto row = static_cast<int>(pixel / this->columns);
    const Lit lit = this->litAt(layers, isCoarse, change, column, row);
    if (lit.flux > 0 && this->reaches(this->toPlane.at(column + 1, row + 1)))
    {
      this->intensities[pixel] = static_cast<float>(lit.intensity);
      this->fluxes[pixel] = static_cast<float>(lit.flux);
      std::copy(lit.ratios.begin(), lit.ratios.end(), &this->colors[3 * pixel]);
    }
  });
}

double LightMap::fluxBeyond(const std::vector<SeedLayer>& layers, const ChangeColor& change) const
{
  LightMap all(this->absorbs);
  all.chooseGrid(layers, std::numeric_limits<double>::infinity());
  const double size = static_cast<double>(all.columns) * all.rows;
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(size / 0x1p24))));
  const auto left = static_cast<int>(std::lround(all.grid.shift.x - this->grid.shift.x));
  const auto bottom = static_cast<int>(std::lround(all.grid.shift.y - this->grid.shift.y));
  const std::vector<bool> isCoarse = all.coarseOnes(layers);
  std::vector<double> ofRow((all.rows + stride - 1) / stride);
  parallelForDynamic(std::size_t(0), ofRow.size(), 16, [&](std::size_t k) {
    const int row = static_cast<int>(k) * stride;
    const bool crosses = row >= bottom && row < bottom + this->rows;
    for (int column = 0; column < all.columns; column += stride)
    {
      const bool isOnMap = crosses && column >= left && column < left + this->columns;
      if (!isOnMap || !this->reaches(all.toPlane.at(column + 1, row + 1)))
      {
        ofRow[k] += all.litAt(layers, isCoarse, change, column, row).flux;
      }
    }
  });
  return std::accumulate(ofRow.begin(), ofRow.end(), 0.0) * stride * stride;
}

double LightMap::totalFlux() const
{
  return std::accumulate(this->fluxes.begin(), this->fluxes.end(), 0.0);
}

double LightMap::fluxOn(const DiskInverse& disk) const
{
  struct OnDisk
  {
    float operator[](std::size_t pixel) const
    {
      const auto p = static_cast<std::uint32_t>(pixel);
      return this->map.isLitOn(this->disk, p) ? this->map.flux(p) : 0;
    }
    const LightMap& map;
    const DiskInverse& disk;
  };
  return blockSum(OnDisk{ *this, disk }, 0, this->size());
}

bool LightMap::isLitOn(const DiskInverse& disk, std::uint32_t pixel) const
{
  if (!(this->fluxes[pixel] > 0))
  {
    return false;
  }
  const PixelPosition centre = this->pointIn(pixel, 0.5, 0.5);
  return disk.covers(centre.x, centre.y);
}

std::size_t LightMap::litPixels(const DiskInverse& disk) const
{
  std::size_t count = 0;
#pragma omp parallel for schedule(dynamic, 4096) reduction(+ : count)
  for (std::size_t pixel = 0; pixel < this->size(); ++pixel)
  {
    count += this->isLitOn(disk, static_cast<std::uint32_t>(pixel));
  }
  return count;
}

void LightMap::take(std::uint32_t pixel, float flux)
{
  const float left = std::max(0.0F, this->fluxes[pixel] - flux);
  this->intensities[pixel] *= this->fluxes[pixel] > 0 ? left / this->fluxes[pixel] : 0;
  this->fluxes[pixel] = left;
}

void LightMap::halve()
{
  const int oldColumns = this->columns, oldRows = this->rows;
  this->columns = (oldColumns + 1) / 2;
  this->rows = (oldRows + 1) / 2;
  this->binning *= 2;
  this->perBin *= 0.5;
  this->side *= 2;
  const std::size_t pixels = static_cast<std::size_t>(this->columns) * this->rows;
  std::vector<float> fluxes(pixels), intensities(pixels);
  std::vector<std::uint8_t> colors(3 * pixels);
#pragma omp parallel for schedule(static)
  for (std::size_t p = 0; p < pixels; ++p)
  {
    double flux = 0, intensity = 0;
    Color color = { 0, 0, 0 };
    for (int part = 0; part < 4; ++part)
    {
      const int column = 2 * static_cast<int>(p % this->columns) + (part & 1);
      const int row = 2 * static_cast<int>(p / this->columns) + (part >> 1);
      if (column < oldColumns && row < oldRows)
      {
        const std::size_t old = static_cast<std::size_t>(row) * oldColumns + column;
        flux += this->fluxes[old];
        intensity += 0.25 * this->intensities[old];
        for (int c = 0; c < 3; ++c)
        {
          color[c] += double(this->fluxes[old]) * this->colors[3 * old + c];
        }
      }
    }
    const ShownColor shown = shownColor(color);
    // Colours add channel by channel, which can only lower the largest.
    fluxes[p] = static_cast<float>(this->absorbs ? flux : shown.intensity / 255);
    intensities[p] = static_cast<float>(intensity);
    std::copy(shown.ratios.begin(), shown.ratios.end(), &colors[3 * p]);
  }
  this->fluxes = std::move(fluxes);
  this->intensities = std::move(intensities);
  this->colors = std::move(colors);
}
} // namespace galaxy
