#include "Filters/Splatting/SplatBlock.h"

#include "Filters/Splatting/TileSums.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Filters/Splatting/SplatBlock.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

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

HWY_INLINE W clamped(W v, double low, double high)
{
  return hn::Min(hn::Max(v, hn::Set(wide, low)), hn::Set(wide, high));
}

/// The pixels from floor(x - h) to floor(x + h) that lie in the image.
struct Range
{
  hn::Vec<Ints> first, end;
  HWY_INLINE Range(W x, W h, int size)
  {
    const W low = hn::Floor(clamped(hn::Sub(x, h), 0, size));
    const W high = hn::Floor(clamped(hn::Add(x, h), -1, size - 1));
    this->first = hn::DemoteTo(ints, low);
    this->end = hn::Add(hn::DemoteTo(ints, high), hn::Set(ints, 1));
  }
};

/// Particles seen through a camera.
struct Seen
{
  W right, up, forward; ///< kpc from the eye
  W ratio;              ///< pixels per kpc
  W x, y, h;            ///< pixels; h is negative, which touches nothing, of what is not shown
  hn::Mask<Wide> isSane;

  HWY_INLINE Seen(const BlockPlaces& p, int k, const Camera& c)
  {
    const auto coordinate = [k](const float* from, double eye) {
      return hn::Sub(hn::PromoteTo(wide, hn::LoadU(half, from + k)), hn::Set(wide, eye));
    };
    const W dx = coordinate(p.x, c.eye.x);
    const W dy = coordinate(p.y, c.eye.y);
    const W dz = coordinate(p.z, c.eye.z);
    const W r = hn::PromoteTo(wide, hn::LoadU(half, p.radius + k));
    this->right = sumOfProducts(dx, c.right.x, dy, c.right.y, dz, c.right.z);
    this->up = sumOfProducts(dx, c.up.x, dy, c.up.y, dz, c.up.z);
    this->forward = sumOfProducts(dx, c.forward.x, dy, c.forward.y, dz, c.forward.z);
    const W size = hn::Add(hn::Add(hn::Abs(dx), hn::Abs(dy)), hn::Add(hn::Abs(dz), r));
    this->isSane = hn::And(hn::Lt(size, hn::Set(wide, 1e30)), hn::Ge(r, hn::Zero(wide)));
    const auto isBefore = hn::Gt(this->forward, hn::Zero(wide));
    const W scale = hn::Set(wide, c.scale);
    this->ratio = c.parallel
      ? scale
      : hn::Div(scale, hn::IfThenElse(isBefore, this->forward, hn::Set(wide, 1.0)));
    this->x = hn::MulAdd(this->ratio, this->right, hn::Set(wide, c.centerX));
    this->y = hn::MulAdd(this->ratio, this->up, hn::Set(wide, c.centerY));
    const auto isShown = c.parallel ? this->isSane : hn::And(this->isSane, isBefore);
    this->h = hn::IfThenElse(isShown, hn::Mul(this->ratio, r), hn::Set(wide, -1e300));
  }
};

/// The pixel of a coordinate and the place in it.
HWY_INLINE void storePlace(W x, std::int32_t* pixel, float* part)
{
  constexpr double far = 1 << 30;
  const W whole = hn::Floor(clamped(x, -far, far));
  hn::StoreU(hn::DemoteTo(ints, whole), ints, pixel);
  hn::StoreU(hn::DemoteTo(half, hn::Sub(x, whole)), half, part);
}

/// gaussianGain(): 1 to the last bit below 1.6 pixels.
HWY_INLINE hn::Vec<Half> gain(hn::Vec<Half> h)
{
  const auto one = hn::Set(half, 1.0F);
  if (hn::AllTrue(half, hn::Lt(h, hn::Set(half, 1.6F))))
  {
    return one;
  }
  const auto width = hn::Max(h, hn::Set(half, 1e-4F));
  const auto edge = hn::Add(hn::Set(half, 3.0F), hn::Div(hn::Set(half, 1.909859317F), width));
  return hn::Div(one, hn::Sub(one, hn::Exp(half, hn::Neg(hn::Mul(edge, edge)))));
}

void projectVectors(
  const BlockPlaces& places, int count, const Camera& c, bool isGaussian, SplatBlock& block)
{
  for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(wide)))
  {
    const Seen seen(places, k, c);
    const Range columns(seen.x, seen.h, c.width), rows(seen.y, seen.h, c.height);
    hn::StoreU(columns.first, ints, block.x0 + k);
    hn::StoreU(columns.end, ints, block.x1 + k);
    hn::StoreU(rows.first, ints, block.y0 + k);
    hn::StoreU(rows.end, ints, block.y1 + k);
    storePlace(seen.x, block.column + k, block.x + k);
    storePlace(seen.y, block.row + k, block.y + k);
    const auto h = hn::DemoteTo(half, hn::Min(seen.h, hn::Set(wide, 1e15)));
    hn::StoreU(h, half, block.h + k);
    const W distance = c.parallel
      ? seen.forward
      : hn::Sqrt(hn::MulAdd(seen.right, seen.right,
          hn::MulAdd(seen.up, seen.up, hn::Mul(seen.forward, seen.forward))));
    hn::StoreU(hn::DemoteTo(half, distance), half, block.depth + k);
    const auto perArea = hn::DemoteTo(half, hn::Mul(seen.ratio, seen.ratio));
    hn::StoreU(isGaussian ? hn::Mul(perArea, gain(h)) : perArea, half, block.perArea + k);
  }
}

void locateVectors(
  const BlockPlaces& places, int count, const Camera& c, int gridColumns, BlockTiles& tiles)
{
  static_assert(tileSide == 32, "five bits");
  const auto one = hn::Set(ints, 1);
  for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(wide)))
  {
    const Seen seen(places, k, c);
    const Range columns(seen.x, seen.h, c.width), rows(seen.y, seen.h, c.height);
    const auto column0 = hn::ShiftRight<5>(columns.first), row0 = hn::ShiftRight<5>(rows.first);
    const auto column1 = hn::ShiftRight<5>(hn::Sub(columns.end, one));
    const auto row1 = hn::ShiftRight<5>(hn::Sub(rows.end, one));
    hn::StoreU(column0, ints, tiles.column0 + k);
    hn::StoreU(row0, ints, tiles.row0 + k);
    hn::StoreU(column1, ints, tiles.column1 + k);
    hn::StoreU(row1, ints, tiles.row1 + k);
    const auto tile = hn::Add(hn::Mul(row0, hn::Set(ints, gridColumns)), column0);
    const auto isOne = hn::And(hn::Eq(column0, column1), hn::Eq(row0, row1));
    const auto isSome = hn::And(hn::Gt(columns.end, columns.first), hn::Gt(rows.end, rows.first));
    const auto code = [](std::uint32_t c) { return hn::Set(ints, static_cast<std::int32_t>(c)); };
    const auto several = hn::Or(code(TileHome::several), hn::Or(hn::ShiftLeft<15>(row1), row0));
    const auto home =
      hn::IfThenElse(isSome, hn::IfThenElse(isOne, tile, several), code(TileHome::nowhere));
    hn::StoreU(home, ints, reinterpret_cast<std::int32_t*>(tiles.home) + k);
    if (!hn::AllTrue(wide, seen.isSane))
    {
      HWY_ALIGN double odd[8];
      hn::StoreU(hn::IfThenElse(seen.isSane, hn::Zero(wide), hn::Set(wide, 1.0)), wide, odd);
      for (std::size_t lane = 0; lane < hn::Lanes(wide); ++lane)
      {
        tiles.home[k + lane] = odd[lane] > 0 ? TileHome::odd : tiles.home[k + lane];
      }
    }
  }
}
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace galaxy
{
HWY_EXPORT(locateVectors);
HWY_EXPORT(projectVectors);

void locateBlock(
  const BlockPlaces& places, int count, const Camera& camera, int gridColumns, BlockTiles& tiles)
{
  HWY_DYNAMIC_DISPATCH(locateVectors)(places, count, camera, gridColumns, tiles);
}

void projectBlock(
  const BlockPlaces& places, int count, const Camera& camera, Kernel kernel, SplatBlock& block)
{
  HWY_DYNAMIC_DISPATCH(projectVectors)(places, count, camera, kernel == Kernel::Gaussian, block);
}
} // namespace galaxy
#endif
