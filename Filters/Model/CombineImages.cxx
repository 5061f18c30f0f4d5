#include "Filters/Model/CombineImages.h"

#include "Filters/Model/GaussianBlur.h"
#include "Filters/Model/Median.h"
#include "Filters/Model/Regrid.h"
#include "Readers/Formats/Beam.h"
#include "Readers/Formats/BrightnessUnit.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
const double radian = std::acos(-1.0) / 180;
const double fwhmPerSigma = 2 * std::sqrt(2 * std::log(2.0));

/// Arcsec along a pixel at the middle of a grid, the root of its area.
double pixelSize(const SkyGrid& grid)
{
  const PixelPosition middle = { 0.5 * (grid.width + 1), 0.5 * (grid.height + 1) };
  SkyPosition here, right, up;
  if (!grid.pixelToSky(middle, here) || !grid.pixelToSky({ middle.x + 1, middle.y }, right) ||
    !grid.pixelToSky({ middle.x, middle.y + 1 }, up))
  {
    return 0;
  }
  const auto east = [&here](const SkyPosition& sky) {
    return std::remainder(sky.ra - here.ra, 360.0) * std::cos(here.dec * radian);
  };
  return 3600 *
    std::sqrt(std::abs(east(right) * (up.dec - here.dec) - east(up) * (right.dec - here.dec)));
}

/// The box, in the first grid's pixels, that all of the images lie in.
struct Box
{
  double left = 0.5, bottom = 0.5, right, top;

  explicit Box(const SkyGrid& grid)
    : right(grid.width + 0.5)
    , top(grid.height + 0.5)
  {
  }

  void include(const SkyGrid& grid, const SkyGrid& first)
  {
    constexpr int probes = 64; // along an edge
    for (int k = 0; k <= probes; ++k)
    {
      const double u = 0.5 + grid.width * double(k) / probes;
      const double v = 0.5 + grid.height * double(k) / probes;
      for (const PixelPosition& edge :
        { PixelPosition{ u, 0.5 }, { u, grid.height + 0.5 }, { 0.5, v }, { grid.width + 0.5, v } })
      {
        SkyPosition sky;
        PixelPosition pixel;
        if (grid.pixelToSky(edge, sky) && first.skyToPixel(sky, pixel))
        {
          this->left = std::min(this->left, pixel.x);
          this->right = std::max(this->right, pixel.x);
          this->bottom = std::min(this->bottom, pixel.y);
          this->top = std::max(this->top, pixel.y);
        }
      }
    }
  }
};

SkyGrid commonGrid(
  const std::vector<CombineSource>& sources, const std::string& file, const std::string& name)
{
  constexpr double mostPixels = 1 << 26;
  SkyGrid grid = sources[0].image.grid;
  Box box(grid);
  for (const CombineSource& source : sources)
  {
    box.include(source.image.grid, grid);
  }
  // A tenth of a pixel more is no farther.
  const double shiftX = std::ceil(0.4 - box.left), shiftY = std::ceil(0.4 - box.bottom);
  const double width = std::ceil(box.right - 0.6) + shiftX;
  const double height = std::ceil(box.top - 0.6) + shiftY;
  if (!(width * height <= mostPixels))
  {
    throw Error(file, name,
      "combine: the widest image at the pixels of the first has more than 2^26 of them; put one "
      "with larger pixels first");
  }
  grid.shift = { grid.shift.x + shiftX, grid.shift.y + shiftY };
  grid.width = static_cast<int>(width);
  grid.height = static_cast<int>(height);
  return grid;
}

void requireCompatible(
  const std::vector<CombineSource>& sources, const std::string& file, const std::string& name)
{
  for (std::size_t k = 1; k < sources.size(); ++k)
  {
    if (!(sources[k].resolution.beam > sources[k - 1].resolution.beam))
    {
      throw Error(file, name,
        "combine: " + sources[k].name + " is not less sharp than " + sources[k - 1].name +
          "; name the sharpest first, or give each its `beam`");
    }
    if (sources[k].resolution.perBeam != sources[0].resolution.perBeam)
    {
      throw Error(file, name,
        "combine: of " + sources[0].name + " and " + sources[k].name +
          " only one has values per beam; correct `unit` of the other");
    }
  }
}

/// 1.4826 times the median depth of the negative values; 0 where there are none.
double noiseOf(const std::vector<float>& values)
{
  std::vector<float> depths;
  for (const float value : values)
  {
    if (value < 0)
    {
      depths.push_back(-value);
    }
  }
  return depths.empty() ? 0 : 1.4826 * median(depths);
}

/// 0 up to 0, 1 from 1 on, smooth between.
double smoothStep(double t)
{
  const double u = std::clamp(t, 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

/// W <- W + D - D * G on a grid.
class DetailAdder
{
public:
  DetailAdder(const SkyGrid& grid, double signalAbove)
    : width(grid.width)
    , height(grid.height)
    , pixel(pixelSize(grid))
    , signalAbove(signalAbove)
  {
  }

  void add(
    std::vector<float> sharp, double sharpBeam, double wideBeam, std::vector<float>& wide) const
  {
    const double sigma =
      std::sqrt(wideBeam * wideBeam - sharpBeam * sharpBeam) / fwhmPerSigma / this->pixel;
    std::vector<float> covered(sharp.size());
    for (std::size_t i = 0; i < sharp.size(); ++i)
    {
      covered[i] = std::isfinite(sharp[i]) ? 1 : 0;
      sharp[i] = covered[i] > 0 ? sharp[i] : 0;
    }
    const std::vector<float> level = this->blur(sharpBeam / fwhmPerSigma / this->pixel, sharp);
    const std::vector<float> inside = this->blur(sigma, covered);
    const double limit = std::isnan(this->signalAbove) ? 3 * noiseOf(level) : this->signalAbove;
    std::vector<float>& detail = sharp;
    for (std::size_t i = 0; i < detail.size(); ++i)
    {
      const double signal = limit > 0 ? smoothStep(level[i] / limit - 0.5) : 1;
      detail[i] *= static_cast<float>(signal * smoothStep(2.0 * inside[i] - 1));
    }
    const std::vector<float> smooth = this->blur(sigma, detail);
    for (std::size_t i = 0; i < wide.size(); ++i)
    {
      const bool blank = std::isnan(wide[i]);
      if (!blank || covered[i] > 0)
      {
        wide[i] = blank ? detail[i] : wide[i] + (detail[i] - smooth[i]);
      }
    }
  }

private:
  std::vector<float> blur(double sigma, const std::vector<float>& values) const
  {
    return gaussianBlur(this->width, this->height, sigma, values);
  }

  int width;
  int height;
  double pixel; ///< arcsec
  double signalAbove;
};
} // namespace

Resolution resolutionOf(
  const Image& image, const ImageDescription& description, const SkyGrid& grid)
{
  const std::optional<Beam> beam = beamOf(image);
  Resolution resolution;
  if (description.beam > 0)
  {
    resolution.beam = description.beam;
  }
  else if (beam)
  {
    requireBeamInImage(image, *beam, pixelSize(grid));
    resolution.beam = std::sqrt(beam->major * beam->minor);
  }
  else
  {
    resolution.beam = 3 * pixelSize(grid);
    return resolution;
  }
  resolution.perBeam = parseBrightnessUnit(image.unit).kind == BrightnessKind::PerBeam;
  return resolution;
}

CleanImage combineImages(const std::vector<CombineSource>& sources, double signalAbove,
  const std::string& file, const std::string& name)
{
  requireCompatible(sources, file, name);
  const CombineSource& first = sources.front();
  CleanImage combined;
  combined.grid = commonGrid(sources, file, name);
  const DetailAdder details(combined.grid, signalAbove);
  for (std::size_t k = sources.size(); k-- > 0;)
  {
    const CombineSource& source = sources[k];
    std::vector<float> values = regrid(source.image, combined.grid);
    if (source.resolution.perBeam)
    {
      const double ratio = first.resolution.beam / source.resolution.beam;
      for (float& value : values)
      {
        value *= static_cast<float>(ratio * ratio);
      }
    }
    if (k + 1 == sources.size())
    {
      combined.values = std::move(values);
      continue;
    }
    details.add(
      std::move(values), source.resolution.beam, sources[k + 1].resolution.beam, combined.values);
  }
  return combined;
}
} // namespace galaxy
