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

/// e^-z for 0 <= z <= 10, as the eighth power of a polynomial: 4e-7.
HWY_INLINE V decay(V z)
{
  V sum = hn::Set(tag, -5.11935616e-11F);
  for (const float c : { 4.66749227e-9F, -2.49263528e-7F, 1.01495882e-5F, -3.25463543e-4F,
         0.00781242919F, -0.124999966F, 0.999999997F })
  {
    sum = hn::MulAdd(sum, z, hn::Set(tag, c));
  }
  sum = hn::Mul(sum, sum);
  sum = hn::Mul(sum, sum);
  return hn::Mul(sum, sum);
}

/// (e^t - 1) / t by its Taylor series: 1e-7 for t <= 1/8, or for t <= 2.
template <bool isThin, class D>
HWY_INLINE hn::Vec<D> growth(D d, hn::Vec<D> t)
{
  auto sum = hn::Set(d, isThin ? 1.0F / 120 : 1.0F / 87178291200);
  if constexpr (!isThin)
  {
    for (const float c : { 1.0F / 6227020800, 1.0F / 479001600, 1.0F / 39916800, 1.0F / 3628800,
           1.0F / 362880, 1.0F / 40320, 1.0F / 5040, 1.0F / 720, 1.0F / 120 })
    {
      sum = hn::MulAdd(sum, t, hn::Set(d, c));
    }
  }
  for (const float c : { 1.0F / 24, 1.0F / 6, 0.5F, 1.0F })
  {
    sum = hn::MulAdd(sum, t, hn::Set(d, c));
  }
  return sum;
}

/// phi(t) = (1 - e^-t) / t, from its series below 1/2 and by definition above: 2e-7.
template <class D>
HWY_INLINE hn::Vec<D> escapeOf(D d, hn::Vec<D> t)
{
  const auto decay = hn::Exp(d, hn::Neg(t));
  const auto thin = hn::Min(t, hn::Set(d, 0.5F));
  const auto series = hn::Mul(growth<false>(d, thin), decay);
  const auto thick = hn::Div(hn::Sub(hn::Set(d, 1.0F), decay), hn::Max(t, hn::Set(d, 0.5F)));
  return hn::IfThenElse(hn::Lt(t, hn::Set(d, 0.5F)), series, thick);
}
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
