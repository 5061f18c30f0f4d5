#include "Readers/Formats/CelestialFrame.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

namespace galaxy
{
namespace
{
struct Vector
{
  double p[3];
};
struct Matrix
{
  double r[3][3];
};
constexpr Matrix identity = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
constexpr double arcsec = ERFA_DAS2R;

// ERFA takes its arguments without const, hence all by value.
Vector operator*(Matrix m, Vector v)
{
  Vector out;
  eraRxp(m.r, v.p, out.p);
  return out;
}

Matrix operator*(Matrix a, Matrix b)
{
  Matrix out;
  eraRxr(a.r, b.r, out.r);
  return out;
}

Matrix transpose(Matrix m)
{
  Matrix out;
  eraTr(m.r, out.r);
  return out;
}

/// The inverse of a matrix that is orthogonal to 1e-8: a Newton step from the transpose, whose
/// error is the square of that.
Matrix inverse(const Matrix& m)
{
  const Matrix guess = transpose(m);
  Matrix step = m * guess;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      step.r[i][j] = (i == j ? 2 : 0) - step.r[i][j];
    }
  }
  return guess * step;
}

Vector toVector(const SkyPosition& position)
{
  Vector v;
  eraS2c(position.ra * ERFA_DD2R, position.dec * ERFA_DD2R, v.p);
  return v;
}

SkyPosition toPosition(Vector v)
{
  double ra, dec;
  eraC2s(v.p, &ra, &dec);
  // An angle just below zero becomes a full turn when rounded.
  const double degrees = eraAnp(ra) * ERFA_DR2D;
  return { degrees < 360 ? degrees : 0, dec * ERFA_DR2D };
}

struct JulianDate
{
  double day, fraction;
};

JulianDate julianEpoch(double year)
{
  JulianDate date;
  eraEpj2jd(year, &date.day, &date.fraction);
  return date;
}

JulianDate besselianEpoch(double year)
{
  JulianDate date;
  eraEpb2jd(year, &date.day, &date.fraction);
  return date;
}

// J2000 differs from ICRS by 0.02 arcsec (Mignard and Froeschle 2000, A&A 354, 732).
Matrix fk5ToIcrs()
{
  Matrix m;
  double spin[3];
  eraFk5hip(m.r, spin);
  return m;
}

/// IAU 2006 precession from J2000.
Matrix precessionFromJ2000(double equinox)
{
  const JulianDate date = julianEpoch(equinox);
  Matrix bias, precession, both;
  eraBp06(date.day, date.fraction, bias.r, precession.r, both.r);
  return precession;
}

/// Newcomb's precession to B1950 (Explanatory Supplement 1992, 3.214).
Matrix precessionToB1950(double equinox)
{
  const double t1 = (equinox - 1850) / 1000;
  const double t = (1950 - equinox) / 1000;
  const double rate = 23035.545 + t1 * (139.720 + t1 * 0.060);
  const double zeta = t * (rate + t * (30.240 - 0.27 * t1 + t * 17.995));
  const double z = t * (rate + t * (109.480 + 0.39 * t1 + t * 18.325));
  const double theta =
    t * (20051.12 - t1 * (85.29 + 0.37 * t1) + t * (-42.65 - 0.37 * t1 - t * 41.8));
  Matrix m = identity;
  eraRz(-zeta * arcsec, m.r);
  eraRy(theta * arcsec, m.r);
  eraRz(-z * arcsec, m.r);
  return m;
}

/// FK4 at B1950 without E-terms to FK5 at J2000, for positions observed at a Besselian epoch
/// (Murray 1989, A&A 218, 325, equations 28 and 29).
Matrix fk4ToFk5(double epoch)
{
  constexpr Matrix atB1950 = { {
    { 0.9999256794956877, -0.0111814832204662, -0.0048590038153592 },
    { 0.0111814832391717, 0.9999374848933135, -0.0000271625947142 },
    { 0.0048590037723143, -0.0000271702937440, 0.9999881946023742 },
  } };
  constexpr Matrix aCentury = { {
    { -0.0026455262e-6, -1.1539918689e-6, 2.1111346190e-6 },
    { 1.1540628161e-6, -0.0129042997e-6, 0.0236021478e-6 },
    { -2.1112979048e-6, -0.0056024448e-6, 0.0102587734e-6 },
  } };
  const JulianDate date = besselianEpoch(epoch);
  const double centuries = (eraEpj(date.day, date.fraction) - 1950) / 100;
  Matrix m = atB1950;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      m.r[i][j] += centuries * aCentury.r[i][j];
    }
  }
  return m;
}

/// E-terms of aberration (Explanatory Supplement 1992, 3.53): eccentricity and perigee of the
/// Sun's orbit, obliquity IAU 1980.
Vector eTermsAt(double equinox)
{
  constexpr double aberration = 0.0056932 * ERFA_DD2R;
  const JulianDate date = besselianEpoch(equinox);
  const JulianDate b1950 = besselianEpoch(1950);
  const double t = (date.day - b1950.day + (date.fraction - b1950.fraction)) / 36525;
  const double ek = aberration * (0.01673011 - t * (0.00004193 + t * 0.000000126));
  const double perigee = (1015489.951 + t * (6190.67 + t * (1.65 + t * 0.012))) * arcsec;
  const double obliquity = eraObl80(date.day, date.fraction);
  const double y = -ek * std::cos(perigee);
  return { { ek * std::sin(perigee), y * std::cos(obliquity), y * std::sin(obliquity) } };
}
} // namespace

struct CelestialFrame::Way
{
  Matrix toIcrs;
  Matrix fromIcrs;
  Vector eTerms; // zero but for FK4
};

CelestialFrame::CelestialFrame(const Way& way)
  : way(std::make_shared<Way>(way))
{
}

CelestialFrame CelestialFrame::icrs()
{
  return CelestialFrame({ identity, identity, {} });
}

// The pole and the longitude of the celestial pole, the values of 1958 brought from B1950.
CelestialFrame CelestialFrame::galactic()
{
  Matrix m = identity;
  eraRz(192.8594812065348 * ERFA_DD2R, m.r);
  eraRy((90 - 27.12825118085622) * ERFA_DD2R, m.r);
  eraRz((180 - 122.9319185680026) * ERFA_DD2R, m.r);
  m = m * transpose(fk5ToIcrs());
  return CelestialFrame({ transpose(m), m, {} });
}

CelestialFrame CelestialFrame::ecliptic(double equinox)
{
  const JulianDate date = julianEpoch(equinox);
  Matrix m;
  eraEcm06(date.day, date.fraction, m.r);
  return CelestialFrame({ transpose(m), m, {} });
}

CelestialFrame CelestialFrame::fk5(double equinox)
{
  const Matrix m = precessionFromJ2000(equinox) * transpose(fk5ToIcrs());
  return CelestialFrame({ transpose(m), m, {} });
}

CelestialFrame CelestialFrame::fk4WithoutETerms(double equinox)
{
  const Matrix m = fk5ToIcrs() * fk4ToFk5(equinox) * precessionToB1950(equinox);
  return CelestialFrame({ m, inverse(m), {} });
}

CelestialFrame CelestialFrame::fk4(double equinox)
{
  Way way = *fk4WithoutETerms(equinox).way;
  way.eTerms = eTermsAt(equinox);
  return CelestialFrame(way);
}

SkyPosition CelestialFrame::toIcrs(const SkyPosition& position) const
{
  Vector r = toVector(position);
  Vector e = this->way->eTerms;
  const double along = eraPdp(r.p, e.p);
  for (int i = 0; i < 3; ++i)
  {
    r.p[i] += along * r.p[i] - e.p[i];
  }
  return toPosition(this->way->toIcrs * r);
}

SkyPosition CelestialFrame::fromIcrs(const SkyPosition& position) const
{
  Vector r = this->way->fromIcrs * toVector(position);
  Vector e = this->way->eTerms;
  // toIcrs undone: d r' = r + (e.r) r - e, so that r is parallel to d r' + e, where the length d is
  // 1 to the square of e, 3e-12.
  for (int i = 0; i < 3; ++i)
  {
    r.p[i] += e.p[i];
  }
  return toPosition(r);
}
} // namespace galaxy
