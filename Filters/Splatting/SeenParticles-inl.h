// Particles seen through a lens, as many at once as vectors have lanes.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_SeenParticles_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_SeenParticles_inl_h
#undef galaxy_SeenParticles_inl_h
#else
#define galaxy_SeenParticles_inl_h
#endif

#include "Filters/Splatting/SplatBlock.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using Wide = hn::CappedTag<double, 8>;
using Half = hn::Rebind<float, Wide>;
using Ints = hn::Rebind<std::int32_t, Wide>;
using W = hn::Vec<Wide>;
constexpr Wide wide;
constexpr Half half;
constexpr Ints ints;

HWY_INLINE W sumOfProducts(W a, double x, W b, double y, W c, double z)
{
  return hn::MulAdd(
    a, hn::Set(wide, x), hn::MulAdd(b, hn::Set(wide, y), hn::Mul(c, hn::Set(wide, z))));
}

HWY_INLINE W loaded(const float* from)
{
  return hn::PromoteTo(wide, hn::LoadU(half, from));
}

HWY_INLINE W sizeOf(W x, W y, W z)
{
  return hn::Add(hn::Abs(x), hn::Add(hn::Abs(y), hn::Abs(z)));
}

/// Particles as they are seen through a lens, in double precision.
struct Seen
{
  W right, up, forward; ///< kpc from the eye
  W distance;           ///< kpc
  W ratio; ///< pixels of h per kpc; of a NearParticle, pixels at its smoothing length's distance
  hn::Mask<Wide> isNear;
  W x, y, h; ///< pixels from the grid's corner; h is negative, which touches nothing, of what is
             ///< not shown

  HWY_INLINE Seen(const BlockPlaces& p, int k, const Lens& lens, const TileGrid& grid)
  {
    const Camera& c = lens.camera();
    const W dx = hn::Sub(loaded(p.x + k), hn::Set(wide, c.eye.x));
    const W dy = hn::Sub(loaded(p.y + k), hn::Set(wide, c.eye.y));
    const W dz = hn::Sub(loaded(p.z + k), hn::Set(wide, c.eye.z));
    const W r = loaded(p.radius + k);
    // NaN is not less than anything.
    const auto isSeen = hn::Lt(sizeOf(dx, dy, dz), hn::Set(wide, 1e30));
    this->right = sumOfProducts(dx, c.right.x, dy, c.right.y, dz, c.right.z);
    this->up = sumOfProducts(dx, c.up.x, dy, c.up.y, dz, c.up.z);
    this->forward = sumOfProducts(dx, c.forward.x, dy, c.forward.y, dz, c.forward.z);
    const W distance2 = hn::MulAdd(this->right, this->right,
      hn::MulAdd(this->up, this->up, hn::Mul(this->forward, this->forward)));
    this->distance = hn::Sqrt(distance2);
    const auto isBefore = this->divide(lens, distance2, r);
    W scale = hn::Set(wide, c.scale); // of the place
    this->ratio = scale;
    if (!c.parallel)
    {
      const W depth = hn::IfThenElse(isBefore, this->forward, hn::Set(wide, 1.0));
      this->toCircle(lens, hn::IfThenElse(this->isNear, r, depth), r, scale);
    }
    this->x = hn::MulAdd(scale, this->right, hn::Set(wide, c.centerX + grid.left));
    this->y = hn::MulAdd(scale, this->up, hn::Set(wide, c.centerY + grid.bottom));
    const auto isShown = c.parallel ? isSeen : hn::And(isSeen, isBefore);
    this->x = hn::IfThenElseZero(hn::AndNot(this->isNear, isShown), this->x);
    this->y = hn::IfThenElseZero(hn::AndNot(this->isNear, isShown), this->y);
    this->h = hn::IfThenElse(isShown, hn::Mul(this->ratio, r), hn::Set(wide, -1e300));
    // On every pixel.
    this->h = hn::IfThenElse(hn::And(this->isNear, isSeen), hn::Set(wide, 1e15), this->h);
  }

private:
  /// Into near ones and those before the eye, as Lens has it.
  HWY_INLINE hn::Mask<Wide> divide(const Lens& lens, W distance2, W r)
  {
    const W r2 = hn::Mul(r, r);
    const auto isWithin = [&](double radii2) {
      return hn::Lt(distance2, hn::Mul(r2, hn::Set(wide, radii2)));
    };
    const auto isBeside = hn::Or(hn::Lt(this->forward, r), isWithin(Lens::within * Lens::within));
    this->isNear = hn::And(isBeside, isWithin(lens.nearReach2()));
    if (!hn::AllFalse(wide, this->isNear))
    {
      this->isNear = hn::And(this->isNear, this->reachField(lens, distance2, r));
    }
    return hn::AndNot(isBeside, hn::Gt(this->forward, hn::Zero(wide)));
  }

  HWY_INLINE hn::Mask<Wide> reachField(const Lens& lens, W distance2, W r) const
  {
    const W zero = hn::Zero(wide), r2 = hn::Mul(r, r);
    const W beside =
      hn::Sqrt(hn::Max(hn::NegMulAdd(this->forward, this->forward, distance2), zero));
    const W tangent = hn::Sqrt(hn::Max(hn::Sub(distance2, r2), zero));
    const W along = hn::MulAdd(this->forward, tangent, hn::Mul(beside, r));
    const W field = hn::Mul(distance2, hn::Set(wide, lens.cosineOfField()));
    const auto isOnAxis = hn::And(hn::Gt(this->forward, zero), hn::Lt(beside, r));
    return hn::Or(hn::Lt(distance2, r2), hn::Or(isOnAxis, hn::Gt(along, field)));
  }

  /// The scales of a perspective at a depth, see Lens::circle().
  HWY_INLINE void toCircle(const Lens& lens, W depth, W r, W& scale)
  {
    const auto number = [](double x) { return hn::Set(wide, x); };
    const W perDepth = hn::Div(number(1), depth);
    const W secant = hn::Mul(this->distance, perDepth);
    const W cosine = hn::Div(number(1), secant);
    const W part = hn::Mul(r, perDepth);
    const W w = hn::Mul(number(lens.variance()), hn::Mul(part, part));
    const W area =
      hn::MulAdd(w, hn::NegMulAdd(number(2), hn::Mul(cosine, cosine), number(6)), number(1));
    const W terms = hn::MulAdd(number(6.5), w, hn::MulAdd(number(1.5), cosine, number(1.5)));
    const W out = hn::MulAdd(w, terms, number(1));
    const W flat = hn::Mul(scale, perDepth);
    scale = hn::Mul(flat, out);
    this->ratio =
      hn::IfThenElse(this->isNear, flat, hn::Mul(flat, hn::Sqrt(hn::Mul(area, secant))));
  }
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
