#ifndef galaxy_NormalQuantile_h
#define galaxy_NormalQuantile_h

#include <cstdint>
#include <cstring>

namespace galaxy
{
// Functions without a branch or a table, of loops over which a compiler makes vector code.

/// c0 + c1 x + c2 x^2 + ...
inline double polynomial(double, double c0)
{
  return c0;
}
template <class... Rest>
inline double polynomial(double x, double c0, Rest... rest)
{
  return c0 + x * polynomial(x, rest...);
}

/// The natural logarithm of a normal positive number to 1e-13 of itself: with u = 2^k m,
/// sqrt(1/2) <= m < sqrt 2, it is k log 2 + 2 artanh s, s = (m - 1)/(m + 1), by the series to s^17.
inline double logarithm(double u)
{
  constexpr std::uint64_t one = 0x3ff0000000000000;
  constexpr std::uint64_t rootOfHalf = 0x3fe6a09e667f3bcd;
  constexpr std::uint64_t fraction = 0x000fffffffffffff;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &u, sizeof(bits));
  bits += one - rootOfHalf;
  // The exponent as the last digits of 2^52 + k, because few vector units convert 64-bit integers.
  const std::uint64_t exponent = bits >> 52 | 0x4330000000000000;
  const std::uint64_t mantissa = (bits & fraction) + rootOfHalf;
  double k = 0, m = 0;
  std::memcpy(&k, &exponent, sizeof(k));
  std::memcpy(&m, &mantissa, sizeof(m));
  k -= 0x1p52 + 1023;
  const double s = (m - 1) / (m + 1);
  const double z = s * s;
  const double series =
    polynomial(z, 1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17);
  return k * 0.69314718055994531 + 2 * (s + s * z * series);
}

/// The z of sign x between which and -z lies the share |x| <= 1 - 2^-32 of a normal distribution of
/// unit variance, sqrt(2) erfinv(x), to 2e-9 of itself. Its ratio to x is a smooth function of
/// w = -log(1 - x^2): one rational minimax approximation (Remez) from the middle to the tails.
inline double normalQuantile(double x)
{
  const double w = -logarithm((1 - x) * (1 + x));
  const double p = polynomial(w, 1.2533141394205911, 0.55441064649995994, 0.12841261067023808,
    0.020120619437336305, 0.0021893038197747069, 0.00015457651960857445, 6.2037547466210393e-6,
    2.2603090997553518e-8);
  const double q = polynomial(w, 1, 0.18055636946390284, 0.04215649307551107, 0.0053000417741597595,
    0.0004292560068028861, 2.695671476985037e-5, 4.0898901086617235e-7);
  return x * p / q;
}
} // namespace galaxy

#endif
