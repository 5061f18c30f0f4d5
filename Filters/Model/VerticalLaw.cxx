#include "Filters/Model/VerticalLaw.h"

#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double lorentzianCut = 10;
} // namespace

double sampleHeight(LayerLaw law, Random& random)
{
  if (law == LayerLaw::Gaussian)
  {
    return random.normal();
  }
  const double u = random.uniform();
  switch (law)
  {
    case LayerLaw::Sech2: // atanh(2u - 1)
      return 0.5 * std::log(u / (1 - u));
    case LayerLaw::Exponential:
      return u < 0.5 ? std::log(2 * u) : -std::log(2 * (1 - u));
    case LayerLaw::Lorentzian:
      return std::tan((2 * u - 1) * std::atan(lorentzianCut));
    default:
      return 2 * u - 1;
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
