#include "Filters/Model/VerticalLaw.h"

#include "Filters/Model/NormalQuantile.h"
#include "Filters/Model/SameClones.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double lorentzianCut = 10;

template <class F>
inline __attribute__((always_inline)) void replaceAll(Deviates& numbers, F function)
{
#pragma omp simd
  for (double& number : numbers)
  {
    number = function(number);
  }
}
} // namespace

double shareWithin(LayerLaw law, double z)
{
  switch (law)
  {
    case LayerLaw::Gaussian:
      return std::erf(z * std::sqrt(0.5));
    case LayerLaw::Sech2:
      return std::tanh(z);
    case LayerLaw::Exponential:
      return -std::expm1(-z);
    case LayerLaw::Lorentzian:
      return std::min(1.0, std::atan(z) / std::atan(lorentzianCut));
    default:
      return std::min(1.0, z);
  }
}

GALAXY_SAME_CLONES void sharesToHeights(LayerLaw law, Deviates& shares)
{
  switch (law)
  {
    case LayerLaw::Gaussian:
      replaceAll(shares, normalQuantile);
      break;
    case LayerLaw::Sech2: // artanh
      replaceAll(shares, [](double x) { return 0.5 * logarithm((1 + x) / (1 - x)); });
      break;
    case LayerLaw::Exponential:
      replaceAll(shares, [](double x) { return std::copysign(logarithm(1 - std::abs(x)), x); });
      break;
    case LayerLaw::Lorentzian:
      replaceAll(shares, [](double x) { return std::tan(x * std::atan(lorentzianCut)); });
      break;
    default:
      break;
  }
}

double rmsHeight(LayerLaw law)
{
  switch (law)
  {
    case LayerLaw::Gaussian:
      return 1;
    case LayerLaw::Sech2:
      return pi / std::sqrt(12.0);
    case LayerLaw::Exponential:
      return std::sqrt(2.0);
    case LayerLaw::Lorentzian:
      return std::sqrt(lorentzianCut / std::atan(lorentzianCut) - 1);
    default:
      return 1 / std::sqrt(3.0);
  }
}

double fwhmHeight(LayerLaw law)
{
  switch (law)
  {
    case LayerLaw::Gaussian:
      return 2 * std::sqrt(2 * std::log(2.0));
    case LayerLaw::Sech2:
      return 2 * std::acosh(std::sqrt(2.0));
    case LayerLaw::Exponential:
      return 2 * std::log(2.0);
    default:
      return 2;
  }
}
} // namespace galaxy
