#include "Filters/Model/SkyBoxes.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Boxes look at no more pixels than about this many, evenly spread.
constexpr double enough = 8192;
/// Equal values in a row that no noise makes.
constexpr int leastRun = 8;

struct Area
{
  int left, right, bottom, top; ///< right and top beyond the last pixel
};

/// The median of sorted values. Of whole numbers and the like, several of which are equal: as if
/// each stood for a step's width, so that it is finer than the steps.
double middleOf(const std::vector<double>& sorted)
{
  const std::size_t count = sorted.size();
  const double middle = 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
  const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), middle);
  if (last - first < 2 || first == sorted.begin() || last == sorted.end())
  {
    return middle;
  }
  const double down = middle - *(first - 1), up = *last - middle;
  const bool isStep = std::abs(up - down) < 1e-3 * (up + down);
  const double below = static_cast<double>(first - sorted.begin());
  const double share = (0.5 * static_cast<double>(count) - below) / double(last - first);
  return isStep ? middle + down * (share - 0.5) : middle;
}

/// The median of |value - middle| of sorted values.
double medianDeviation(const std::vector<double>& sorted, double middle)
{
  std::vector<double> deviations(sorted.size());
  std::transform(sorted.begin(), sorted.end(), deviations.begin(),
    [middle](double value) { return std::abs(value - middle); });
  const auto half = deviations.begin() + deviations.size() / 2;
  std::nth_element(deviations.begin(), half, deviations.end());
  return *half;
}

double meanOf(const std::vector<double>& values)
{
  double sum = 0;
  for (const double value : values)
  {
    sum += value - values.front();
  }
  return values.front() + sum / static_cast<double>(values.size());
}

double deviationOf(const std::vector<double>& values, double mean)
{
  double sum = 0;
  for (const double value : values)
  {
    sum += (value - mean) * (value - mean);
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Leaves of sorted values those within 3 sigma, again and again until all are: sigma from the
/// median deviation about the median or, where half of all are equal, as counts of few photons are,
/// from all deviations about the mean.
bool clip(std::vector<double>& sorted)
{
  bool isCounts = false;
  for (std::size_t before = sorted.size() + 1; sorted.size() < before;)
  {
    before = sorted.size();
    double centre = middleOf(sorted);
    double sigma = 1.4826 * medianDeviation(sorted, centre);
    isCounts = isCounts || sigma == 0;
    if (isCounts)
    {
      centre = meanOf(sorted);
      sigma = deviationOf(sorted, centre);
    }
    const auto first = std::lower_bound(sorted.begin(), sorted.end(), centre - 3 * sigma);
    const auto last = std::upper_bound(first, sorted.end(), centre + 3 * sigma);
    if (first < last)
    {
      sorted = std::vector<double>(first, last);
    }
  }
  return isCounts;
}

/// Level and scatter; as modes go 2.5 median - 1.5 mean, but where that would be far from either.
void measure(std::vector<double>& values, SkyBox& box)
{
  std::sort(values.begin(), values.end());
  const bool isCounts = clip(values);
  const double mean = meanOf(values), middle = middleOf(values);
  box.scatter = deviationOf(values, mean);
  const double skew = mean - middle;
  box.level = isCounts ? mean : std::abs(skew) < 0.3 * box.scatter ? middle - 1.5 * skew : middle;
  box.pixels = static_cast<double>(values.size());
}

/// The box of an area; false where less than `least` of it may show the sky.
bool measureArea(const Image& image, const std::vector<std::uint8_t>& shows, const Area& area,
  double least, SkyBox& box)
{
  const double size = double(area.right - area.left) * (area.top - area.bottom);
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(size / enough))));
  const auto has = [&](int column, int row) {
    return shows[static_cast<std::size_t>(row) * image.width + column] != 0;
  };
  std::vector<double> values, pairs;
  std::size_t looked = 0;
  for (int row = area.bottom; row < area.top; row += stride)
  {
    for (int column = area.left; column < area.right; column += stride, ++looked)
    {
      if (has(column, row))
      {
        values.push_back(image.at(column, row));
        const bool hasNext = column + 1 < image.width && has(column + 1, row);
        pairs.push_back(hasNext ? image.at(column + 1, row) : std::nan(""));
      }
    }
  }
  if (values.empty() || static_cast<double>(values.size()) < least * static_cast<double>(looked))
  {
    return false;
  }
  std::vector<double> kept = values;
  measure(kept, box);
  double squares = 0, count = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    const double lowest = std::min(values[k], pairs[k]), highest = std::max(values[k], pairs[k]);
    if (lowest >= kept.front() && highest <= kept.back() && !std::isnan(pairs[k]))
    {
      squares += (values[k] - pairs[k]) * (values[k] - pairs[k]);
      ++count;
    }
  }
  box.grain = count > 0 ? std::sqrt(squares / count / 2) : 0;
  return true;
}

/// Marks the run of equal values from a pixel on, `step` pixels apart, `most` at most.
void markRun(const Image& image, std::size_t start, std::ptrdiff_t step, int most,
  std::vector<std::uint8_t>& isPadding)
{
  const double value = image.values[start];
  int run = 0;
  while (run < most && image.values[start + run * step] == value)
  {
    ++run;
  }
  for (int k = 0; k < run && run >= leastRun; ++k)
  {
    isPadding[start + k * step] = 1;
  }
}
} // namespace

std::vector<std::uint8_t> skyPixels(const Image& image, std::vector<double>& padding)
{
  const int width = image.width, height = image.height;
  std::vector<std::uint8_t> isPadding(image.values.size(), 0), shows(image.values.size(), 0);
  for (int row = 0; row < height; ++row)
  {
    const std::size_t first = static_cast<std::size_t>(row) * width;
    markRun(image, first, 1, width, isPadding);
    markRun(image, first + width - 1, -1, width, isPadding);
  }
  for (int column = 0; column < width; ++column)
  {
    markRun(image, column, width, height, isPadding);
    markRun(image, image.values.size() - width + column, -width, height, isPadding);
  }
  padding.clear();
  for (std::size_t i = 0; i < shows.size(); ++i)
  {
    const bool isUsable = std::isfinite(image.values[i]) && (image.bad.empty() || !image.bad[i]);
    shows[i] = isUsable && !isPadding[i];
    if (isUsable && isPadding[i])
    {
      padding.push_back(image.values[i]);
    }
  }
  return shows;
}

std::vector<SkyBox> skyBoxes(const Image& image, const std::vector<std::uint8_t>& shows)
{
  constexpr int most = 16, least = 8;
  const int columns = std::clamp(image.width / least, 1, most);
  const int rows = std::clamp(image.height / least, 1, most);
  std::vector<SkyBox> boxes;
  for (int v = 0; v < rows; ++v)
  {
    for (int u = 0; u < columns; ++u)
    {
      const auto cut = [](int k, int parts, int size) {
        return static_cast<int>(static_cast<long long>(k) * size / parts);
      };
      const Area area = { cut(u, columns, image.width), cut(u + 1, columns, image.width),
        cut(v, rows, image.height), cut(v + 1, rows, image.height) };
      SkyBox box;
      box.x = (u + 0.5) / columns - 0.5;
      box.y = (v + 0.5) / rows - 0.5;
      box.isAtEdge = u == 0 || v == 0 || u == columns - 1 || v == rows - 1;
      if (measureArea(image, shows, area, 0.5, box))
      {
        boxes.push_back(box);
      }
    }
  }
  return boxes;
}

SkyBox wholeSkyBox(const Image& image, const std::vector<std::uint8_t>& shows)
{
  SkyBox box;
  std::vector<double> values;
  for (std::size_t i = 0; i < shows.size(); ++i)
  {
    if (shows[i])
    {
      values.push_back(image.values[i]);
    }
  }
  measure(values, box);
  return box;
}
} // namespace galaxy
