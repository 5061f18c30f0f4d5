#ifndef galaxy_OpticalModel_h
#define galaxy_OpticalModel_h

#include <cmath>

namespace galaxy
{
/// phi(t) = (1 - e^-t) / t with phi(0) = 1, for t >= 0: the share of a slab's own light that leaves
/// a slab of optical depth t. Accurate to rounding everywhere, since expm1 is.
template <typename Real>
Real escapeFraction(Real t)
{
  return t > 0 ? -std::expm1(-t) / t : Real(1);
}

/// The paper's slab update I <- (I - E/A) e^-t + E/A, written with the column emission e and the
/// optical depth t = A/E e so that nothing is divided by A and nothing cancels.
template <typename Real>
Real throughSlab(Real I, Real e, Real t)
{
  return I * std::exp(-t) + e * escapeFraction(t);
}
} // namespace galaxy

#endif
