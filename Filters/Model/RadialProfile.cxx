#include "Filters/Model/RadialProfile.h"

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double mostLogit = 37; // ln(u/(1 - u)) of the last double below 1
constexpr double stepsPerLogit = 32;
constexpr int steps = static_cast<int>(2 * mostLogit * stepsPerLogit);

/// Where the profile ends, in units of its scale.
double endOf(const SpheroidDescription& spheroid)
{
  const bool endless =
    spheroid.profile != SpheroidProfile::NFW && spheroid.profile != SpheroidProfile::Cored;
  return std::isfinite(spheroid.truncation) || endless ? spheroid.truncation / scaleOf(spheroid)
                                                       : spheroid.concentration;
}
} // namespace

RadialProfile::RadialProfile(const SpheroidDescription& spheroid)
  : kind(spheroid.profile)
  , last(endOf(spheroid))
  , law(radialLaw(spheroid, this->last))
  , kept(std::isfinite(this->last) ? this->law->split(this->last) : MassSplit{ 1, 0 })
{
  for (int k = 0; k <= steps; ++k)
  {
    const double logit = k / stepsPerLogit - mostLogit;
    const double u = 1 / (1 + std::exp(-logit));
    const double v = 1 / (1 + std::exp(logit));
    const double s = this->law->radius({ u * this->kept.inside, v + u * this->kept.outside });
    const double massPerLogRadius = 4 * pi * s * s * s * this->law->density(s) / this->kept.inside;
    this->logRadius.push_back(std::log(s));
    this->slope.push_back(u * v / massPerLogRadius / stepsPerLogit);
  }
}

double RadialProfile::massWithin(double s) const
{
  return s < this->last ? this->law->split(s).inside / this->kept.inside : 1;
}

double RadialProfile::radius(double u) const
{
  const double logit = std::clamp(std::log(u / (1 - u)), -mostLogit, mostLogit);
  const double x = (logit + mostLogit) * stepsPerLogit;
  const int k = std::min(static_cast<int>(x), steps - 1);
  const double t = x - k;
  const double rise = this->logRadius[k + 1] - this->logRadius[k];
  const double first = this->slope[k] - rise;
  const double second = rise - this->slope[k + 1];
  const double logRadius =
    this->logRadius[k] + t * (rise + (1 - t) * (first * (1 - t) + second * t));
  return std::min(std::exp(logRadius), this->last);
}

double RadialProfile::brightnessRadius() const
{
  switch (this->kind)
  {
    case SpheroidProfile::Sersic:
      return std::min(1.0, this->radius(0.5));
    case SpheroidProfile::Hernquist:
    case SpheroidProfile::NFW:
      return this->radius(0.5);
    default:
      return 0;
  }
}

double RadialProfile::surfaceBrightness() const
{
  return this->surfaceDensity(this->brightnessRadius());
}

double RadialProfile::surfaceDensity(double s) const
{
  const auto alongSight = [&](double z) { return this->law->density(std::hypot(s, z)); };
  const double half = std::isfinite(this->last)
    ? boost::math::quadrature::tanh_sinh<double>().integrate(
        alongSight, 0.0, std::sqrt(this->last * this->last - s * s))
    : boost::math::quadrature::exp_sinh<double>().integrate(alongSight);
  return 2 * half / this->kept.inside;
}
} // namespace galaxy
