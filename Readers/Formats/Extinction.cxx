#include "Readers/Formats/Extinction.h"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace galaxy
{
namespace
{
constexpr double wavelengthOfV = 0.545;

/// c0 + c1 y + c2 y^2 + ...
double polynomial(double y, std::initializer_list<double> coefficients)
{
  double sum = 0;
  for (auto c = coefficients.end(); c != coefficients.begin();)
  {
    sum = sum * y + *--c;
  }
  return sum;
}

/// a and b of A/A_V = a + b/R_V.
struct Coefficients
{
  double a;
  double b;
};

// Equations 2 to 5 of the paper, by 1/wavelength in 1/um.
Coefficients cardelliInfrared(double x)
{
  const double power = std::pow(x, 1.61);
  return { 0.574 * power, -0.527 * power };
}

Coefficients cardelliOptical(double x)
{
  const double y = x - 1.82;
  return { polynomial(y, { 1, 0.17699, -0.50447, -0.02427, 0.72085, 0.01979, -0.77530, 0.32999 }),
    polynomial(y, { 0, 1.41338, 2.28305, 1.07233, -5.38434, -0.62251, 5.30260, -2.09002 }) };
}

Coefficients cardelliUltraviolet(double x)
{
  const double y = std::fmax(0, x - 5.9);
  const double a = 1.752 - 0.316 * x - 0.104 / ((x - 4.67) * (x - 4.67) + 0.341);
  const double b = -3.090 + 1.825 * x + 1.206 / ((x - 4.62) * (x - 4.62) + 0.263);
  return { a + polynomial(y, { 0, 0, -0.04473, -0.009779 }),
    b + polynomial(y, { 0, 0, 0.2130, 0.1207 }) };
}

Coefficients cardelliFarUltraviolet(double x)
{
  const double y = x - 8;
  return { polynomial(y, { -1.073, -0.628, 0.137, -0.070 }),
    polynomial(y, { 13.670, 4.257, -0.420, 0.374 }) };
}

double cardelli(double wavelength, double R_V)
{
  const double x = 1 / wavelength;
  const Coefficients c = x < 1.1 ? cardelliInfrared(x)
    : x < 3.3                    ? cardelliOptical(x)
    : x < 8                      ? cardelliUltraviolet(x)
                                 : cardelliFarUltraviolet(x);
  return c.a + c.b / R_V;
}

// Equation 4 of the paper.
double calzetti(double wavelength, double R_V)
{
  const double x = 1 / wavelength;
  const double k = wavelength < 0.63 ? polynomial(x, { -2.156, 1.509, -0.198, 0.011 })
                                     : polynomial(x, { -1.857, 1.040 });
  return 1 + 2.659 * k / R_V;
}
} // namespace

const std::vector<Band>& knownBands()
{
  static const std::vector<Band> bands = { { "FUV", 0.153 }, { "NUV", 0.227 }, { "U", 0.366 },
    { "B", 0.438 }, { "V", wavelengthOfV }, { "R", 0.641 }, { "Halpha", 0.6563 }, { "I", 0.798 },
    { "J", 1.22 }, { "H", 1.63 }, { "K", 2.19 }, { "3.6um", 3.55 }, { "4.5um", 4.49 } };
  return bands;
}

std::array<double, 2> wavelengthRange(ExtinctionLaw law)
{
  switch (law)
  {
    case ExtinctionLaw::CCM89:
      return { 0.1, 5 };
    case ExtinctionLaw::Calzetti:
      return { 0.12, 2.2 };
    default:
      return { 0, std::numeric_limits<double>::infinity() };
  }
}

double usualTotalToSelective(ExtinctionLaw law)
{
  switch (law)
  {
    case ExtinctionLaw::CCM89:
      return 3.1;
    case ExtinctionLaw::Calzetti:
      return 4.05;
    default:
      return 0;
  }
}

double extinctionCurve(ExtinctionLaw law, double wavelength, double totalToSelective)
{
  switch (law)
  {
    case ExtinctionLaw::CCM89:
      return cardelli(wavelength, totalToSelective);
    case ExtinctionLaw::Calzetti:
      return calzetti(wavelength, totalToSelective);
    case ExtinctionLaw::Grey:
      return 1;
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

Color absorptionInBands(
  ExtinctionLaw law, const std::array<double, 3>& bands, double totalToSelective)
{
  const double inV = extinctionCurve(law, wavelengthOfV, totalToSelective);
  Color absorption;
  for (int c = 0; c < 3; ++c)
  {
    absorption[c] = extinctionCurve(law, bands[c], totalToSelective) / inV;
  }
  return absorption;
}
} // namespace galaxy
