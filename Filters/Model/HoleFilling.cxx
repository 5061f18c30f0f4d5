#include "Filters/Model/HoleFilling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
constexpr float blank = std::numeric_limits<float>::quiet_NaN();

/// Pixels with values, and those that are to get some.
struct Canvas
{
  int width = 0;
  int height = 0;
  std::vector<float> values;
  std::vector<std::uint8_t> isHole;

  std::size_t index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * this->width + column;
  }
};

/// Half the size: the mean of the finite pixels of each four; a hole where there is none but one
/// of the four is a hole.
Canvas halved(const Canvas& fine)
{
  Canvas coarse;
  coarse.width = (fine.width + 1) / 2;
  coarse.height = (fine.height + 1) / 2;
  for (int row = 0; row < coarse.height; ++row)
  {
    for (int column = 0; column < coarse.width; ++column)
    {
      double sum = 0;
      int count = 0;
      bool hole = false;
      for (int v = 2 * row; v < std::min(2 * row + 2, fine.height); ++v)
      {
        for (int u = 2 * column; u < std::min(2 * column + 2, fine.width); ++u)
        {
          const std::size_t i = fine.index(u, v);
          hole = hole || fine.isHole[i];
          if (!fine.isHole[i] && !std::isnan(fine.values[i]))
          {
            sum += fine.values[i];
            ++count;
          }
        }
      }
      coarse.values.push_back(count > 0 ? static_cast<float>(sum / count) : blank);
      coarse.isHole.push_back(count == 0 && hole);
    }
  }
  return coarse;
}

/// The mean of the neighbours that have a value; NaN where none has.
float neighbourMean(const Canvas& canvas, int column, int row)
{
  double sum = 0;
  int count = 0;
  const auto take = [&](int u, int v) {
    if (u >= 0 && v >= 0 && u < canvas.width && v < canvas.height &&
      !std::isnan(canvas.values[canvas.index(u, v)]))
    {
      sum += canvas.values[canvas.index(u, v)];
      ++count;
    }
  };
  take(column - 1, row);
  take(column + 1, row);
  take(column, row - 1);
  take(column, row + 1);
  return count > 0 ? static_cast<float>(sum / count) : blank;
}

/// Gauss-Seidel, forward and backward in turn.
void relax(Canvas& canvas)
{
  constexpr int sweeps = 40;
  std::vector<std::size_t> holes;
  for (std::size_t i = 0; i < canvas.isHole.size(); ++i)
  {
    if (canvas.isHole[i])
    {
      holes.push_back(i);
    }
  }
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (const std::size_t i : holes)
    {
      canvas.values[i] = neighbourMean(canvas, i % canvas.width, i / canvas.width);
    }
    std::reverse(holes.begin(), holes.end());
  }
}

void fill(Canvas& canvas)
{
  const auto hole = [](std::uint8_t isHole) { return isHole != 0; };
  if (std::none_of(canvas.isHole.begin(), canvas.isHole.end(), hole))
  {
    return;
  }
  if (canvas.width > 1 || canvas.height > 1)
  {
    Canvas coarse = halved(canvas);
    fill(coarse);
    for (std::size_t i = 0; i < canvas.isHole.size(); ++i)
    {
      if (canvas.isHole[i])
      {
        canvas.values[i] = coarse.values[coarse.index(
          static_cast<int>(i % canvas.width) / 2, static_cast<int>(i / canvas.width) / 2)];
      }
    }
  }
  relax(canvas);
}
} // namespace

void fillHoles(
  int width, int height, const std::vector<std::uint8_t>& mask, std::vector<float>& values)
{
  Canvas canvas;
  canvas.width = width;
  canvas.height = height;
  canvas.values = std::move(values);
  canvas.isHole = mask;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    canvas.values[i] = mask[i] ? blank : canvas.values[i];
  }
  fill(canvas);
  values = std::move(canvas.values);
}
} // namespace galaxy
