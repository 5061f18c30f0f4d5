#ifndef galaxy_ErfPolynomial_h
#define galaxy_ErfPolynomial_h

namespace galaxy
{
/// erf(u) for |u| <= end, where all but 7e-7 of 1 is reached, to 2e-7 in single precision: as
/// u P(2 u^2/end^2 - 1), P through the Chebyshev nodes.
struct ErfPolynomial
{
  static constexpr int degree = 13;
  static constexpr float end = 3.5F;
  ErfPolynomial();
  float coefficients[degree + 1];
};
extern const ErfPolynomial erfPolynomial;
} // namespace galaxy

#endif
