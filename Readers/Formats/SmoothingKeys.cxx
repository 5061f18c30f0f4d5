#include "Readers/Formats/GalaxyKeys.h"
#include "Readers/Formats/NumberRows.h"

namespace galaxy
{
namespace
{
using S = SmoothingDescription;

const NumberRow<S> numbers[] = {
  { "factor", &S::factor, Range::positive(), "",
    "Of Density and Neighbours: radius over the mean distance between particles." },
  { "length", &S::length, Range::positive(), "kpc",
    "Of Constant: the radius; of Brightness: its mean, weighted by light." },
  { "exponent", &S::exponent, Range::from(0, 2), "",
    "Of Brightness: the radius goes as this power of a particle's light." },
  { "minimum", &S::minimum, Range::notNegative(), "kpc", "No radius is smaller." },
  { "maximum", &S::maximum, Range::positive(), "kpc", "No radius is larger." },
};

constexpr int mostNeighbours = 1024;

Keys<S> makeKeys()
{
  Keys<S> keys = {
    choiceKey<S>("model", &S::model, { "Density", "Neighbours", "Constant", "Brightness" },
      "Radius of a particle's footprint: from the local density of particles, counted in cells; "
      "the same from the nearest neighbours, exact and slow; one for all; by a particle's light."),
    integerKey<S>("neighbours", &S::neighbours, 1, mostNeighbours,
      "Of Density and Neighbours: how many particles the density is taken over."),
  };
  for (const NumberRow<S>& row : numbers)
  {
    keys.push_back(row.key());
  }
  keys.back() = withDefault(keys.back(), "none");
  return keys;
}
} // namespace

const Keys<SmoothingDescription>& smoothingKeys()
{
  static const Keys<S> keys = makeKeys();
  return keys;
}

void requireInRange(const S& smoothing, const std::string& file, const std::string& component)
{
  const SectionCheck check(file, component, "smoothing");
  check.requireNumbers(numbers, smoothing);
  check.require(smoothing.neighbours >= 1 && smoothing.neighbours <= mostNeighbours, "neighbours",
    "1 to " + std::to_string(mostNeighbours));
  check.require(smoothing.minimum <= smoothing.maximum, "maximum", "at least the minimum");
}
} // namespace galaxy
