#include "Filters/Model/RadialLaw.h"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>

#include <cmath>

namespace galaxy
{
namespace
{
namespace bm = boost::math;
constexpr double pi = 3.14159265358979323846;

/// Doubles throughout; values at the ends of their range are what they are, not exceptions.
using Plain = bm::policies::policy<bm::policies::promote_double<false>,
  bm::policies::underflow_error<bm::policies::ignore_error>,
  bm::policies::overflow_error<bm::policies::ignore_error>>;

/// Newton's method in ln s: `step` gives the step at s. It converges quadratically, so that after
/// a step of 1e-9 nothing is left but rounding.
template <class Step>
double solvedInLog(double s, const Step& step)
{
  for (double d = 1; std::abs(d) > 1e-9;)
  {
    d = step(s);
    s *= std::exp(d);
  }
  return s;
}

/// rho = s^(k/n - 3) exp(-b s^(1/n)): x = b s^(1/n) is distributed as Gamma(k).
class GammaLaw : public RadialLaw
{
public:
  GammaLaw(double k, double b, double n)
    : k(k)
    , b(b)
    , n(n)
    , norm(std::exp(k * std::log(b) - bm::lgamma(k)) / (4 * pi * n))
  {
  }
  MassSplit split(double s) const override
  {
    const double x = this->b * std::pow(s, 1 / this->n);
    return { bm::gamma_p(this->k, x, Plain()), bm::gamma_q(this->k, x, Plain()) };
  }
  double density(double s) const override
  {
    return this->norm * std::pow(s, this->k / this->n - 3) *
      std::exp(-this->b * std::pow(s, 1 / this->n));
  }
  double radius(const MassSplit& split) const override
  {
    const double x = split.inside < split.outside
      ? bm::gamma_p_inv(this->k, split.inside, Plain())
      : bm::gamma_q_inv(this->k, split.outside, Plain());
    return std::pow(x / this->b, this->n);
  }

private:
  double k;
  double b;
  double n;
  double norm;
};

/// Prugniel and Simien (1997), p after Lima Neto et al. (1999); the projected law's b solves
/// P(2n, b) = 1/2 (Ciotti 1991).
std::unique_ptr<RadialLaw> sersicLaw(double n)
{
  const double p = 1 - 0.6097 / n + 0.05463 / (n * n);
  return std::make_unique<GammaLaw>(n * (3 - p), bm::gamma_p_inv(2 * n, 0.5), n);
}

/// Hernquist (1990).
class HernquistLaw : public RadialLaw
{
public:
  MassSplit split(double s) const override
  {
    const double inverse = 1 / (1 + s);
    return { s * s * inverse * inverse, (1 + 2 * s) * inverse * inverse };
  }
  double density(double s) const override { return 1 / (2 * pi * s * std::pow(1 + s, 3)); }
  double radius(const MassSplit& split) const override
  {
    const double root = std::sqrt(split.inside);
    return root * (1 + root) / split.outside;
  }
};

/// rho = (1 + s^2)^(-slope/2): t = s^2/(1 + s^2) is distributed as Beta(3/2, (slope - 3)/2).
/// The slope 5 is Plummer's (1911).
class CoredLaw : public RadialLaw
{
public:
  explicit CoredLaw(double slope)
    : slope(slope)
    , tail((slope - 3) / 2)
    , norm(1 / (2 * pi * bm::beta(1.5, this->tail)))
  {
  }
  MassSplit split(double s) const override
  {
    const double t = s * s / (1 + s * s);
    const double rest = 1 / (1 + s * s);
    // Far out, 1 - t tells more than t.
    return t < 0.5
      ? MassSplit{ bm::ibeta(1.5, this->tail, t, Plain()), bm::ibetac(1.5, this->tail, t, Plain()) }
      : MassSplit{ bm::ibetac(this->tail, 1.5, rest, Plain()),
          bm::ibeta(this->tail, 1.5, rest, Plain()) };
  }
  double density(double s) const override
  {
    return this->norm * std::pow(1 + s * s, -this->slope / 2);
  }
  /// ln M and ln(1 - M) are concave functions of ln s, below those of the uniform core and of the
  /// pure power outside, where Newton's steps start: none passes the root.
  double radius(const MassSplit& split) const override
  {
    const double full = 4 * pi * this->norm;
    const auto shell = [this](double s) { return 4 * pi * s * s * s * this->density(s); };
    if (split.inside < split.outside)
    {
      return solvedInLog(std::cbrt(3 * split.inside / full), [&](double s) {
        const double inside = this->split(s).inside;
        return std::log(split.inside / inside) * inside / shell(s);
      });
    }
    return solvedInLog(
      std::pow(full / (2 * this->tail * split.outside), 0.5 / this->tail), [&](double s) {
        const double outside = this->split(s).outside;
        return std::log(outside / split.outside) * outside / shell(s);
      });
  }

private:
  double slope;
  double tail;
  double norm;
};

/// Navarro, Frenk and White (1997): M = m(s)/m(end), m = ln(1 + s) - s/(1 + s).
class NfwLaw : public RadialLaw
{
public:
  explicit NfwLaw(double end)
    : whole(mass(end))
  {
  }
  MassSplit split(double s) const override
  {
    const double inside = mass(s) / this->whole;
    return { inside, 1 - inside };
  }
  double density(double s) const override
  {
    return 1 / (4 * pi * this->whole * s * (1 + s) * (1 + s));
  }
  /// ln m is a concave function of ln s, and m < s^2/2: Newton's steps in these from
  /// s = sqrt(2m) grow towards the root without passing it.
  double radius(const MassSplit& split) const override
  {
    const double m = split.inside * this->whole;
    return solvedInLog(std::sqrt(2 * m), [m](double s) {
      const double reached = mass(s);
      return std::log(m / reached) * reached * (1 + s) * (1 + s) / (s * s);
    });
  }

private:
  /// Of the two forms of m, the one in which less cancels.
  static double mass(double s)
  {
    const double outer = s / (1 + s);
    return s < 1 ? bm::log1pmx(s) + s * outer : std::log1p(s) - outer;
  }

  double whole;
};
} // namespace

std::unique_ptr<RadialLaw> radialLaw(const SpheroidDescription& spheroid, double end)
{
  switch (spheroid.profile)
  {
    case SpheroidProfile::Sersic:
      return sersicLaw(spheroid.sersicIndex);
    case SpheroidProfile::Hernquist:
      return std::make_unique<HernquistLaw>();
    case SpheroidProfile::Exponential:
      return std::make_unique<GammaLaw>(3, 1, 1);
    case SpheroidProfile::Plummer:
      return std::make_unique<CoredLaw>(5);
    case SpheroidProfile::NFW:
      return std::make_unique<NfwLaw>(end);
    case SpheroidProfile::Cored:
      return std::make_unique<CoredLaw>(spheroid.slope);
    default:
      return std::make_unique<GammaLaw>(1.5, 0.5, 0.5);
  }
}
} // namespace galaxy
