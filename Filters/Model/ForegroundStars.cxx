#include "Filters/Model/ForegroundStars.h"

#include "Filters/Model/Median.h"
#include "Filters/Model/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
constexpr int largestHalfRadius = 8;
constexpr int widths = 6; ///< half radii to where a star has ended
constexpr int largestRadius = 2 * widths * largestHalfRadius;

struct Offset
{
  int column, row;
};

/// The pixels to mask for one star.
struct StarDisc
{
  int column = 0, row = 0;
  int radius = 0;
};

/// The pixels at about r from a pixel, for every r.
using Rings = std::array<std::vector<Offset>, largestRadius + 1>;

Rings makeRings()
{
  Rings rings;
  for (int row = -largestRadius; row <= largestRadius; ++row)
  {
    for (int column = -largestRadius; column <= largestRadius; ++column)
    {
      const auto r = static_cast<std::size_t>(std::lround(std::hypot(column, row)));
      if (r < rings.size())
      {
        rings[r].push_back({ column, row });
      }
    }
  }
  return rings;
}

class StarFinder
{
public:
  StarFinder(int width, int height, double contrast, const std::vector<float>& values)
    : width(width)
    , height(height)
    , contrast(contrast)
    , values(values)
    , rings(makeRings())
  {
  }

  /// The pixels to mask for a star of which this pixel is the maximum; radius 0 where it is none.
  StarDisc starAt(int column, int row) const
  {
    if (!this->isMaximum(column, row) || !this->standsOut(column, row))
    {
      return {};
    }
    const Offset middle = this->topMiddle(column, row);
    return { middle.column, middle.row,
      this->starRadius(middle.column, middle.row, this->value(column, row)) };
  }

private:
  /// The middle of the pixels that hang together with a maximum less than half of the contrast
  /// below it: the maximum of a saturated star may be anywhere on its flat top.
  Offset topMiddle(int column, int row) const
  {
    constexpr std::size_t most = 4 * largestHalfRadius * largestHalfRadius;
    const double least = this->value(column, row) - 0.5 * this->contrast;
    std::vector<Offset> top = { { column, row } };
    for (std::size_t next = 0; next < top.size() && top.size() < most; ++next)
    {
      const Offset at = top[next];
      for (const Offset& to : { Offset{ at.column + 1, at.row }, { at.column - 1, at.row },
             { at.column, at.row + 1 }, { at.column, at.row - 1 } })
      {
        const bool isNew = std::none_of(top.begin(), top.end(),
          [&to](const Offset& other) { return other.column == to.column && other.row == to.row; });
        if (isNew && this->value(to.column, to.row) > least)
        {
          top.push_back(to);
        }
      }
    }
    double x = 0, y = 0;
    for (const Offset& at : top)
    {
      x += at.column;
      y += at.row;
    }
    const double count = static_cast<double>(top.size());
    return { static_cast<int>(std::lround(x / count)), static_cast<int>(std::lround(y / count)) };
  }

  /// The radius to mask about a pixel; 0 where there is no star of this peak.
  int starRadius(int column, int row, double peak) const
  {
    for (int h = 1; h <= largestHalfRadius; ++h)
    {
      const double sky = this->ringMedian(column, row, widths * h);
      const double light = peak - sky;
      if (light > this->contrast && this->ringMedian(column, row, h) - sky <= 0.5 * light)
      {
        const bool endsSharply = this->ringMedian(column, row, 3 * h) - sky < 0.06 * light;
        const bool isRound = this->ringMedian(column, row, (h - 1) / 2) - sky > 0.8 * light;
        const bool isOnLevelGround =
          sky - this->ringMedian(column, row, 2 * widths * h) < 0.01 * light + 0.2 * this->contrast;
        return endsSharply && isRound && isOnLevelGround ? this->reach(column, row, h, sky) : 0;
      }
    }
    return 0;
  }

  double value(int column, int row) const
  {
    return column >= 0 && row >= 0 && column < this->width && row < this->height
      ? this->values[static_cast<std::size_t>(row) * this->width + column]
      : std::numeric_limits<double>::quiet_NaN();
  }

  bool isMaximum(int column, int row) const
  {
    const double peak = this->value(column, row);
    for (int v = row - 1; v <= row + 1; ++v)
    {
      for (int u = column - 1; u <= column + 1; ++u)
      {
        // Of the pixels of a plateau, such as a saturated star's, each counts.
        if (this->value(u, v) > peak)
        {
          return false;
        }
      }
    }
    return std::isfinite(peak);
  }

  /// A quick look that passes by most of the noise: above most of 8 points nearby, or farther out.
  bool standsOut(int column, int row) const
  {
    const double least = this->value(column, row) - this->contrast;
    for (const int r : { 4, largestRadius / 4 })
    {
      int below = 0;
      for (const auto& [u, v] : { Offset{ r, 0 }, { -r, 0 }, { 0, r }, { 0, -r }, { r, r },
             { r, -r }, { -r, r }, { -r, -r } })
      {
        below += this->value(column + u, row + v) < least;
      }
      if (below >= 3)
      {
        return true;
      }
    }
    return false;
  }

  double ringMedian(int column, int row, int r) const
  {
    std::vector<double> ring;
    for (const Offset& offset : this->rings[r])
    {
      const double value = this->value(column + offset.column, row + offset.row);
      if (std::isfinite(value))
      {
        ring.push_back(value);
      }
    }
    return ring.empty() ? std::numeric_limits<double>::quiet_NaN() : median(ring);
  }

  int reach(int column, int row, int h, double sky) const
  {
    int r = 1;
    while (r<widths * h&& this->ringMedian(column, row, r) - sky> 0.1 * this->contrast)
    {
      ++r;
    }
    return r + 1;
  }

  int width;
  int height;
  double contrast;
  const std::vector<float>& values;
  Rings rings;
};
} // namespace

std::vector<std::uint8_t> foregroundStars(
  int width, int height, double contrast, const std::vector<float>& values)
{
  const StarFinder finder(width, height, contrast, values);
  std::vector<StarDisc> stars(values.size());
  parallelForDynamic<int>(0, height, 8, [&](int row) {
    for (int column = 0; column < width; ++column)
    {
      stars[static_cast<std::size_t>(row) * width + column] = finder.starAt(column, row);
    }
  });
  std::vector<std::uint8_t> mask(values.size(), 0);
  for (const auto& [column, row, radius] : stars)
  {
    const int top = radius > 0 ? std::min(height - 1, row + radius) : -1;
    for (int v = std::max(0, row - radius); v <= top; ++v)
    {
      for (int u = std::max(0, column - radius); u <= std::min(width - 1, column + radius); ++u)
      {
        const bool near = std::hypot(u - column, v - row) < radius + 0.5;
        mask[static_cast<std::size_t>(v) * width + u] |= near;
      }
    }
  }
  return mask;
}
} // namespace galaxy
