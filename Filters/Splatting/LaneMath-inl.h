// Functions of the optical model for all lanes of a vector.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_LaneMath_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_LaneMath_inl_h
#undef galaxy_LaneMath_inl_h
#else
#define galaxy_LaneMath_inl_h
#endif

#include "Filters/Splatting/GaussianKernel.h"

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 8>; ///< more lanes would run over the edges of most splats
using V = hn::Vec<Tag>;
constexpr Tag tag;

template <class D>
HWY_INLINE int lanes(D d)
{
  return static_cast<int>(hn::Lanes(d));
}
HWY_INLINE int lanes()
{
  return lanes(tag);
}

/// gaussianCumulative(), 2e-7: the polynomial's even and odd terms apart, so that neither waits for
/// the other.
template <class D>
HWY_INLINE hn::Vec<D> cumulative(D d, hn::Vec<D> u)
{
  constexpr float end = GaussianPolynomial::end;
  const auto v = hn::Max(hn::Min(u, hn::Set(d, end)), hn::Set(d, -end));
  const auto s = hn::MulSub(hn::Mul(v, v), hn::Set(d, 2 / (end * end)), hn::Set(d, 1.0F));
  const auto s2 = hn::Mul(s, s);
  constexpr int last = GaussianPolynomial::degree;
  static_assert(last % 2 == 1, "as many even terms as odd ones");
  const float* c = gaussianPolynomial.coefficients;
  auto even = hn::Set(d, c[last - 1]);
  auto odd = hn::Set(d, c[last]);
  for (int k = last - 3; k >= 0; k -= 2)
  {
    even = hn::MulAdd(even, s2, hn::Set(d, c[k]));
    odd = hn::MulAdd(odd, s2, hn::Set(d, c[k + 1]));
  }
  return hn::Mul(v, hn::MulAdd(odd, s, even));
}

/// phi(t) by its Taylor series, 2e-8 for t < 1/8.
template <class D>
HWY_INLINE hn::Vec<D> phiOfThin(D d, hn::Vec<D> t)
{
  auto sum = hn::Set(d, 1.0F / 120);
  sum = hn::NegMulAdd(sum, t, hn::Set(d, 1.0F / 24));
  sum = hn::NegMulAdd(sum, t, hn::Set(d, 1.0F / 6));
  sum = hn::NegMulAdd(sum, t, hn::Set(d, 0.5F));
  return hn::NegMulAdd(sum, t, hn::Set(d, 1.0F));
}

/// phi(t) and e^-t by phi's series below 1/2 and by definition above: 2e-7 everywhere.
template <class D>
HWY_INLINE void phiOfAny(D d, hn::Vec<D> t, hn::Vec<D>& phi, hn::Vec<D>& decay)
{
  auto sum = hn::Set(d, 1.0F / 362880);
  for (const float c :
    { 1.0F / 40320, 1.0F / 5040, 1.0F / 720, 1.0F / 120, 1.0F / 24, 1.0F / 6, 0.5F, 1.0F })
  {
    sum = hn::NegMulAdd(sum, t, hn::Set(d, c));
  }
  const auto one = hn::Set(d, 1.0F);
  const auto thick = hn::Exp(d, hn::Neg(t));
  const auto isThin = hn::Lt(t, hn::Set(d, 0.5F));
  phi = hn::IfThenElse(isThin, sum, hn::Div(hn::Sub(one, thick), t));
  decay = hn::IfThenElse(isThin, hn::NegMulAdd(t, sum, one), thick);
}
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
