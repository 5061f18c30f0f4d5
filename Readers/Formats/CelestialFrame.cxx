#include "Readers/Formats/CelestialFrame.h"

#include <cmath>

namespace galaxy
{
namespace
{
using Vector = std::array<double, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;

const double radians = std::acos(-1.0) / 180;
constexpr Matrix identity = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector operator*(const Matrix& m, const Vector& v)
{
  return { dot(m[0], v), dot(m[1], v), dot(m[2], v) };
}

Matrix transpose(const Matrix& m)
{
  Matrix t{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      t[i][j] = m[j][i];
    }
  }
  return t;
}

Matrix operator*(const Matrix& a, const Matrix& b)
{
  const Matrix columns = transpose(b);
  Matrix product{};
  for (int i = 0; i < 3; ++i)
  {
    product[i] = columns * a[i];
  }
  return product;
}

Vector toVector(const SkyPosition& position)
{
  const double alpha = position.ra * radians;
  const double delta = position.dec * radians;
  return { std::cos(delta) * std::cos(alpha), std::cos(delta) * std::sin(alpha), std::sin(delta) };
}

SkyPosition toPosition(const Vector& v)
{
  SkyPosition position;
  position.ra = std::atan2(v[1], v[0]) / radians;
  position.dec = std::atan2(v[2], std::hypot(v[0], v[1])) / radians;
  if (position.ra < 0)
  {
    position.ra += 360;
  }
  if (position.ra >= 360)
  {
    position.ra = 0;
  }
  return position;
}

/// Rz(-z) Ry(theta) Rz(-zeta), the equatorial precession matrix; angles in arcsec.
Matrix precession(double zeta, double z, double theta)
{
  const double arcsec = radians / 3600;
  const double cosZeta = std::cos(zeta * arcsec), sinZeta = std::sin(zeta * arcsec);
  const double cosZ = std::cos(z * arcsec), sinZ = std::sin(z * arcsec);
  const double cosTheta = std::cos(theta * arcsec), sinTheta = std::sin(theta * arcsec);
  return { { { cosZ * cosTheta * cosZeta - sinZ * sinZeta,
               -cosZ * cosTheta * sinZeta - sinZ * cosZeta, -cosZ * sinTheta },
    { sinZ * cosTheta * cosZeta + cosZ * sinZeta, -sinZ * cosTheta * sinZeta + cosZ * cosZeta,
      -sinZ * sinTheta },
    { sinTheta * cosZeta, -sinTheta * sinZeta, cosTheta } } };
}

/// IAU 1976 precession from J2000 to a Julian equinox (Lieske et al. 1977, A&A 58, 1).
Matrix precessionFromJ2000(double equinox)
{
  const double t = (equinox - 2000) / 100;
  return precession(t * (2306.2181 + t * (0.30188 + t * 0.017998)),
    t * (2306.2181 + t * (1.09468 + t * 0.018203)),
    t * (2004.3109 + t * (-0.42665 - t * 0.041833)));
}

/// Newcomb's precession from B1950 to a Besselian equinox (Explanatory Supplement 1992, 3.214).
Matrix precessionFromB1950(double equinox)
{
  constexpr double t1 = (1950.0 - 1850.0) / 1000;
  const double t = (equinox - 1950) / 1000;
  constexpr double rate = 23035.545 + t1 * (139.720 + t1 * 0.060);
  return precession(t * (rate + t * (30.240 - 0.27 * t1 + t * 17.995)),
    t * (rate + t * (109.480 + 0.39 * t1 + t * 18.325)),
    t * (20051.12 - t1 * (85.29 + 0.37 * t1) + t * (-42.65 - 0.37 * t1 - t * 41.8)));
}

// FK4 without E-terms at B1950 to FK5 at J2000 (Murray 1989, A&A 218, 325).
constexpr Matrix fk4ToFk5 = { {
  { 0.9999256794956877, -0.0111814832204662, -0.0048590038153592 },
  { 0.0111814832391717, 0.9999374848933135, -0.0000271625947142 },
  { 0.0048590037723143, -0.0000271702937440, 0.9999881946023742 },
} };

// E-terms of aberration at B1950 (Explanatory Supplement 1992, 3.53).
constexpr Vector eTerms1950 = { -1.62557e-6, -0.31919e-6, -0.13843e-6 };

// ICRS to Galactic (ESA 1997, The Hipparcos Catalogue, volume 1, equation 1.5.11).
constexpr Matrix icrsToGalactic = { {
  { -0.0548755604162154, -0.8734370902348850, -0.4838350155487132 },
  { 0.4941094278755837, -0.4448296299600112, 0.7469822444972189 },
  { -0.8676661490190047, -0.1980763734312015, 0.4559837761750669 },
} };
} // namespace

CelestialFrame::CelestialFrame(const Matrix& rotation, bool hasETerms, const Matrix& fromB1950)
  : rotation(rotation)
  , hasETerms(hasETerms)
  , fromB1950(fromB1950)
{
}

CelestialFrame CelestialFrame::icrs()
{
  return { identity, false, identity };
}

CelestialFrame CelestialFrame::galactic()
{
  return { transpose(icrsToGalactic), false, identity };
}

CelestialFrame CelestialFrame::ecliptic()
{
  const double obliquity = 84381.448 / 3600 * radians; // IAU 1976
  const double c = std::cos(obliquity), s = std::sin(obliquity);
  return { { { { 1, 0, 0 }, { 0, c, -s }, { 0, s, c } } }, false, identity };
}

CelestialFrame CelestialFrame::fk5(double equinox)
{
  return { transpose(precessionFromJ2000(equinox)), false, identity };
}

CelestialFrame CelestialFrame::fk4(double equinox)
{
  const Matrix fromB1950 = precessionFromB1950(equinox);
  return { fk4ToFk5 * transpose(fromB1950), true, fromB1950 };
}

SkyPosition CelestialFrame::toIcrs(const SkyPosition& position) const
{
  Vector r = toVector(position);
  if (this->hasETerms)
  {
    const Vector e = this->fromB1950 * eTerms1950;
    const double along = dot(r, e);
    for (int i = 0; i < 3; ++i)
    {
      r[i] += along * r[i] - e[i];
    }
  }
  return toPosition(this->rotation * r);
}

SkyPosition CelestialFrame::fromIcrs(const SkyPosition& position) const
{
  Vector r = transpose(this->rotation) * toVector(position);
  if (this->hasETerms)
  {
    const Vector e = this->fromB1950 * eTerms1950;
    for (int i = 0; i < 3; ++i)
    {
      r[i] += e[i];
    }
  }
  return toPosition(r);
}
} // namespace galaxy
