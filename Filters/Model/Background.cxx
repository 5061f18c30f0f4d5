#include "Filters/Model/Background.h"

#include "Filters/Model/SkyBoxes.h"
#include "Readers/Formats/Vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace galaxy
{
namespace
{
using Boxes = std::vector<SkyBox>;

/// A level that is linear across the image.
struct Plane
{
  double middle = 0, alongX = 0, alongY = 0;

  double at(const SkyBox& box) const
  {
    return this->middle + this->alongX * box.x + this->alongY * box.y;
  }
};

/// The least-squares plane, by Cramer's rule; level where the boxes are too few or stand in a row.
Plane planeThrough(const Boxes& boxes, const std::vector<double>& weights)
{
  std::array<Vec3, 3> products;
  Vec3 sums;
  double count = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k)
  {
    const Vec3 place = { 1, boxes[k].x, boxes[k].y };
    const Vec3 weighted = weights[k] * place;
    products[0] = products[0] + weighted;
    products[1] = products[1] + place.y * weighted;
    products[2] = products[2] + place.z * weighted;
    sums = sums + boxes[k].level * weighted;
    count += weights[k] > 0;
  }
  const double weight = products[0].x;
  const auto& [p, q, r] = products;
  const double determinant = dot(p, cross(q, r));
  if (count < 6 || std::abs(determinant) < 1e-6 * weight * weight * weight)
  {
    return { sums.x / weight, 0, 0 };
  }
  return { dot(sums, cross(q, r)) / determinant, dot(sums, cross(r, p)) / determinant,
    dot(sums, cross(p, q)) / determinant };
}

/// The value of sorted ones that a share of them lies below.
double atShare(const std::vector<double>& sorted, double share)
{
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

template <typename Get>
std::vector<double> sortedOf(const Boxes& boxes, const Get& get)
{
  std::vector<double> values(boxes.size());
  std::transform(boxes.begin(), boxes.end(), values.begin(), get);
  std::sort(values.begin(), values.end());
  return values;
}

/// The plane that a fifth of the boxes lie below, by weights that make least squares into that.
Plane planeBelow(const Boxes& boxes)
{
  constexpr double share = 0.2;
  const std::vector<double> levels = sortedOf(boxes, [](const SkyBox& box) { return box.level; });
  const double nearness = 1e-3 * (levels.back() - levels.front());
  Plane plane = { atShare(levels, share), 0, 0 };
  std::vector<double> weights(boxes.size());
  for (int step = 0; step < 50 && nearness > 0; ++step)
  {
    for (std::size_t k = 0; k < boxes.size(); ++k)
    {
      const double above = boxes[k].level - plane.at(boxes[k]);
      weights[k] = (above > 0 ? share : 1 - share) / std::max(std::abs(above), nearness);
    }
    plane = planeThrough(boxes, weights);
  }
  return plane;
}

/// The boxes of the sky and the plane through them.
struct Sky
{
  Plane plane;
  std::vector<double> above; ///< of these boxes, sorted, over the plane
  std::vector<double> isSky; ///< 1 or 0 for each box
  double scatter = 0;        ///< of pixels, median
  double error = 0;          ///< of 2.5 median - 1.5 mean of a box, median of all
  std::size_t size() const { return this->above.size(); }
};

/// How far boxes lie from the plane on its lower side: where no light is, that is chance.
double lowerSpread(const Boxes& boxes, const Plane& plane, const std::vector<double>& isSky)
{
  double squares = 0, count = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k)
  {
    const double above = boxes[k].level - plane.at(boxes[k]);
    if (isSky[k] > 0 && above <= 0)
    {
      squares += above * above;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

void select(const Boxes& boxes, const Plane& plane, double spread, std::vector<double>& isSky)
{
  std::transform(boxes.begin(), boxes.end(), isSky.begin(), [&](const SkyBox& box) {
    const double above = box.level - plane.at(box);
    return above <= 2 * spread && above >= -5 * spread ? 1.0 : 0.0;
  });
}

Sky skyUnder(const Boxes& boxes)
{
  const auto errors =
    sortedOf(boxes, [](const SkyBox& box) { return 2.14 * box.scatter / std::sqrt(box.pixels); });
  const auto sizes = sortedOf(boxes, [](const SkyBox& box) { return std::abs(box.level); });
  const double rounding = 1e-7 * sizes.back() + std::numeric_limits<double>::min();
  Sky sky;
  sky.error = atShare(errors, 0.5);
  const double least = std::max(sky.error, rounding);
  sky.plane = planeBelow(boxes);
  sky.isSky.assign(boxes.size(), 1);
  select(boxes, sky.plane, std::max(least, lowerSpread(boxes, sky.plane, sky.isSky)), sky.isSky);
  for (int step = 0; step < 40; ++step)
  {
    const std::vector<double> before = sky.isSky;
    sky.plane = planeThrough(boxes, before);
    select(boxes, sky.plane, std::max(least, lowerSpread(boxes, sky.plane, before)), sky.isSky);
    if (sky.isSky == before || std::count(sky.isSky.begin(), sky.isSky.end(), 1.0) == 0)
    {
      sky.isSky = before;
      break;
    }
  }
  std::vector<double> scatters;
  for (std::size_t k = 0; k < boxes.size(); ++k)
  {
    if (sky.isSky[k] > 0)
    {
      sky.above.push_back(boxes[k].level - sky.plane.at(boxes[k]));
      scatters.push_back(boxes[k].scatter);
    }
  }
  std::sort(sky.above.begin(), sky.above.end());
  std::sort(scatters.begin(), scatters.end());
  sky.scatter = atShare(scatters, 0.5);
  return sky;
}

/// Those whose scatter is grain, as far as that can be told: sky, margins, the galaxy's flat parts.
Boxes withoutStructure(const Boxes& boxes)
{
  const auto structure = [](const SkyBox& box) {
    return box.scatter == 0 ? 0
      : box.grain > 0       ? box.scatter / box.grain
                            : std::numeric_limits<double>::infinity();
  };
  const double most = 1.3 * atShare(sortedOf(boxes, structure), 0.2);
  Boxes flat;
  std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(flat),
    [&](const SkyBox& box) { return structure(box) <= most; });
  return flat.size() >= 4 ? flat : boxes;
}

/// Of boxes, by level, how many lie along the image's edge from one to before another.
double shareAtEdge(Boxes::const_iterator first, Boxes::const_iterator last)
{
  return static_cast<double>(
           std::count_if(first, last, [](const SkyBox& box) { return box.isAtEdge; })) /
    static_cast<double>(last - first);
}

/// Whether the boxes up to `gap` are a margin of the others: more of them along the edge than of
/// the sky that the others show, which is as large, or a third of that with a galaxy above it.
bool isMargin(const Boxes& byLevel, Boxes::const_iterator gap)
{
  const Boxes rest(gap, byLevel.end());
  const Sky sky = skyUnder(rest);
  Boxes its;
  for (std::size_t k = 0; k < rest.size(); ++k)
  {
    if (sky.isSky[k] > 0)
    {
      its.push_back(rest[k]);
    }
  }
  const double lower = shareAtEdge(byLevel.begin(), gap);
  const auto margin = static_cast<std::size_t>(gap - byLevel.begin());
  const std::size_t lit = rest.size() - its.size();
  return lower > 0.3 && lower > shareAtEdge(its.begin(), its.end()) &&
    (its.size() >= margin || (3 * its.size() >= margin && 5 * lit >= its.size()));
}

/// Without the margins, which lie lowest and a gap of 4 scatters below all else.
Boxes withoutMargins(Boxes boxes)
{
  std::stable_sort(boxes.begin(), boxes.end(),
    [](const SkyBox& one, const SkyBox& other) { return one.level < other.level; });
  for (auto gap = boxes.cbegin() + 1; gap < boxes.cend() - 3; ++gap)
  {
    const SkyBox& lower = *(gap - 1);
    if (gap->level - lower.level > 4 * (gap->scatter + lower.scatter) && isMargin(boxes, gap))
    {
      return withoutMargins(Boxes(gap, boxes.cend()));
    }
  }
  return boxes;
}

/// The value that most have.
double mostFrequent(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  double most = values.front();
  std::ptrdiff_t best = 0;
  for (auto first = values.begin(); first != values.end();)
  {
    const auto last = std::upper_bound(first, values.end(), *first);
    if (last - first > best)
    {
      best = last - first;
      most = *first;
    }
    first = last;
  }
  return most;
}

/// Whether what lies inside a padded border is a sky of its own, not only a galaxy on that level:
/// noise reaches below a sky, and a sky without noise is even.
bool standsAlone(const Image& image, const std::vector<std::uint8_t>& shows, const SkyLevel& sky,
  double padding, double shareOfBoxes)
{
  double below = 0, all = 0;
  for (std::size_t i = 0; i < shows.size(); ++i)
  {
    all += shows[i];
    below += shows[i] && image.values[i] < sky.level - sky.scatter;
  }
  const bool isEven = sky.scatter <= 1e-3 * std::abs(sky.level - padding);
  return shareOfBoxes >= 0.05 && (below >= 0.005 * all || isEven);
}
} // namespace

SkyLevel skyOf(const Image& image)
{
  std::vector<double> padding;
  const std::vector<std::uint8_t> shows = skyPixels(image, padding);
  const double all = std::accumulate(shows.begin(), shows.end(), 0.0);
  const double padded = static_cast<double>(padding.size());
  if (all == 0 || all < 0.2 * (all + padded))
  {
    return { padding.empty() ? 0 : mostFrequent(std::move(padding)), 0 };
  }
  const Boxes whole = skyBoxes(image, shows);
  if (whole.empty())
  {
    const SkyBox box = wholeSkyBox(image, shows);
    return { box.level, box.scatter };
  }
  const Boxes boxes = withoutMargins(withoutStructure(whole));
  const Sky sky = skyUnder(boxes);
  // A tenth of what only chance moves lies 1.28 standard errors below.
  const SkyLevel found = { sky.plane.middle + atShare(sky.above, 0.1) + 1.28 * sky.error,
    sky.scatter };
  const double share = static_cast<double>(sky.size()) / static_cast<double>(boxes.size());
  if (padded > 0.05 * (all + padded))
  {
    const double constant = mostFrequent(std::move(padding));
    if (std::abs(constant - found.level) > 3 * found.scatter &&
      !standsAlone(image, shows, found, constant, share))
    {
      return { constant, 0 };
    }
  }
  return found;
}
} // namespace galaxy
