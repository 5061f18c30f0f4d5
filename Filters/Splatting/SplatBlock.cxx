#include "Filters/Splatting/SplatBlock.h"

#include "Filters/Splatting/TileSums.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Filters/Splatting/SplatBlock.cxx"
#include <hwy/foreach_target.h>

#include "Filters/Splatting/SeenParticles-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
constexpr int tileBits = tileSide == 16 ? 4 : tileSide == 32 ? 5 : 6;
static_assert(1 << tileBits == tileSide);

HWY_INLINE W clamped(W v, double low, double high)
{
  return hn::Min(hn::Max(v, hn::Set(wide, low)), hn::Set(wide, high));
}

/// The pixels from floor(x - h) to floor(x + h) that lie in the image, which begins at `begin`.
struct Range
{
  hn::Vec<Ints> first, last;
  HWY_INLINE Range(W x, W h, int begin, int size)
  {
    const W low = hn::Floor(clamped(hn::Sub(x, h), begin, begin + size));
    const W high = hn::Floor(clamped(hn::Add(x, h), begin - 1, begin + size - 1));
    this->first = hn::DemoteTo(ints, low);
    this->last = hn::DemoteTo(ints, high);
  }
  HWY_INLINE hn::Vec<Ints> firstTile() const { return hn::ShiftRight<tileBits>(this->first); }
  HWY_INLINE hn::Vec<Ints> lastTile() const { return hn::ShiftRight<tileBits>(this->last); }
};

/// Particles with a place and a size: neither NaN nor infinite, the size not negative.
HWY_INLINE hn::Mask<Wide> areSane(const BlockPlaces& p, int k)
{
  const W r = loaded(p.radius + k);
  const W size = sizeOf(loaded(p.x + k), loaded(p.y + k), loaded(p.z + k));
  return hn::And(hn::Lt(hn::Add(size, r), hn::Set(wide, 1e30)), hn::Ge(r, hn::Zero(wide)));
}

/// The tiles that particles touch.
HWY_INLINE void storeTiles(
  const Seen& seen, bool isParallel, const TileGrid& grid, int k, BlockTiles& tiles)
{
  const W reach = hn::Mul(seen.h, hn::Set(wide, kernelCut));
  const Range columns(seen.x, reach, grid.left, grid.width);
  const Range rows(seen.y, reach, grid.bottom, grid.height);
  const auto column0 = columns.firstTile(), row0 = rows.firstTile();
  const auto column1 = columns.lastTile(), row1 = rows.lastTile();
  hn::StoreU(column0, ints, tiles.column0 + k);
  hn::StoreU(row0, ints, tiles.row0 + k);
  hn::StoreU(column1, ints, tiles.column1 + k);
  hn::StoreU(row1, ints, tiles.row1 + k);
  const auto code = [](std::uint32_t c) { return hn::Set(ints, static_cast<std::int32_t>(c)); };
  const auto isSome =
    hn::Not(hn::Or(hn::Lt(columns.last, columns.first), hn::Lt(rows.last, rows.first)));
  const auto isOne = hn::And(hn::Eq(column0, column1), hn::Eq(row0, row1));
  const auto tile = hn::Add(hn::Mul(row0, hn::Set(ints, grid.columns)), column0);
  const auto several = hn::Or(code(TileHome::several), hn::Or(hn::ShiftLeft<15>(row1), row0));
  const auto home =
    hn::IfThenElse(isSome, hn::IfThenElse(isOne, tile, several), code(TileHome::nowhere));
  hn::StoreU(home, ints, reinterpret_cast<std::int32_t*>(tiles.home) + k);
  hn::StoreU(isParallel ? seen.forward : seen.distance, wide, tiles.depth + k);
}

void locateVectors(
  const BlockPlaces& places, int count, const Lens& lens, const TileGrid& grid, BlockTiles& tiles)
{
  for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(wide)))
  {
    const Seen seen(places, k, lens, grid);
    storeTiles(seen, lens.camera().parallel, grid, k, tiles);
    const auto isSane = areSane(places, k);
    if (!hn::AllTrue(wide, isSane))
    {
      HWY_ALIGN double odd[8];
      hn::StoreU(hn::IfThenElse(isSane, hn::Zero(wide), hn::Set(wide, 1.0)), wide, odd);
      for (std::size_t lane = 0; lane < hn::Lanes(wide); ++lane)
      {
        tiles.home[k + lane] = odd[lane] > 0 ? TileHome::invalid : tiles.home[k + lane];
      }
    }
  }
}

/// The pixel of a coordinate from the corner of its first tile, and the place in that pixel.
HWY_INLINE hn::Vec<Ints> storePlace(W x, hn::Vec<Ints> tile, float* part)
{
  const W from = hn::Sub(x, hn::PromoteTo(wide, hn::ShiftLeft<tileBits>(tile)));
  const W whole = hn::Floor(clamped(from, -Splat::farPixel, Splat::farPixel));
  hn::StoreU(hn::DemoteTo(half, hn::Sub(from, whole)), half, part);
  return hn::Add(hn::DemoteTo(ints, whole), hn::Set(ints, Splat::middle));
}

HWY_INLINE void storeFinite(W v, float* to)
{
  const W largest = hn::Set(wide, std::numeric_limits<float>::max());
  hn::StoreU(hn::DemoteTo(half, hn::Min(v, largest)), half, to);
}

void projectPlaces(const BlockPlaces& places, const BlockLights& areas, int count, const Lens& lens,
  const TileGrid& grid, SplatBlock& block)
{
  for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(wide)))
  {
    const Seen seen(places, k, lens, grid);
    storeTiles(seen, lens.camera().parallel, grid, k, block.tiles);
    const auto column = storePlace(seen.x, hn::LoadU(ints, block.tiles.column0 + k), block.x + k);
    const auto row = storePlace(seen.y, hn::LoadU(ints, block.tiles.row0 + k), block.y + k);
    hn::StoreU(hn::Or(column, hn::ShiftLeft<Splat::rowBit>(row)), ints,
      reinterpret_cast<std::int32_t*>(block.where + k));
    hn::StoreU(hn::DemoteTo(half, hn::Min(seen.h, hn::Set(wide, 1e15))), half, block.h + k);
    const W perArea = hn::Mul(seen.ratio, seen.ratio);
    storeFinite(hn::Mul(perArea, hn::Set(wide, areas.areaOfLight)), block.lightArea + k);
    storeFinite(hn::Mul(perArea, hn::Set(wide, areas.areaOfDepth)), block.depthArea + k);
    const W all = hn::IfThenElseZero(seen.isNear, hn::Set(wide, -1.0));
    hn::StoreU(hn::DemoteTo(ints, all), ints, block.near + k);
  }
}

using Floats = hn::CappedTag<float, 8>;
using Words = hn::RebindToSigned<Floats>;
using F = hn::Vec<Floats>;
using I = hn::Vec<Words>;
constexpr Floats floats;
constexpr Words words;

HWY_INLINE F mostOf(F a, F b, F c)
{
  return hn::Max(a, hn::Max(b, c));
}

/// All bits where a condition on floats holds.
HWY_INLINE I flags(hn::Mask<Floats> mask)
{
  return hn::BitCast(words, hn::VecFromMask(floats, mask));
}

HWY_INLINE I choose(I condition, I yes, I no)
{
  return hn::Or(hn::And(condition, yes), hn::AndNot(condition, no));
}

HWY_INLINE I wordOf(Fate fate)
{
  return hn::Set(words, static_cast<std::int32_t>(fate));
}

/// All bits of the lanes from k on that are before `count`.
HWY_INLINE I countedLanes(int k, int count)
{
  return hn::BitCast(
    words, hn::VecFromMask(words, hn::Lt(hn::Iota(words, k), hn::Set(words, count))));
}

/// Puts the light to the places.
void lightPlaces(const BlockLights& lights, int count, SplatBlock& block)
{
  const F zero = hn::Zero(floats), largest = hn::Set(floats, std::numeric_limits<float>::max());
  const F mostDepth = hn::Set(floats, Projection::mostDepth);
  // In a pixel: the peak of a Gaussian, which is above that of a spline, is 2.87 where h is 1.
  const F peak = hn::Set(floats, 2.87F), thick = hn::Set(floats, Projection::thick);
  F brightest = zero;
  for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(floats)))
  {
    F L[3], K[3];
    auto isValid = hn::Eq(zero, zero);
    for (int c = 0; c < 3; ++c)
    {
      L[c] = hn::LoadU(floats, lights.L[c] + k);
      K[c] = hn::LoadU(floats, lights.K[c] + k);
      // NaN fails every comparison.
      isValid = hn::And(isValid, hn::And(hn::Ge(L[c], zero), hn::Le(L[c], largest)));
      isValid = hn::And(isValid, hn::And(hn::Ge(K[c], zero), hn::Le(K[c], largest)));
    }
    const F mostL = mostOf(L[0], L[1], L[2]), mostK = mostOf(K[0], K[1], K[2]);
    const auto emits = hn::Gt(mostL, zero), absorbs = hn::Gt(mostK, zero);
    const F lightArea = hn::LoadU(floats, block.lightArea + k);
    const F depthArea = hn::LoadU(floats, block.depthArea + k);
    const auto isShown = hn::Or(emits, absorbs);
    const auto isGrey = hn::And(hn::Eq(K[0], K[1]), hn::Eq(K[1], K[2]));

    const I absorbing = flags(absorbs), grey = flags(isGrey);
    const I slab = hn::And(flags(emits), absorbing);
    const I near = hn::LoadU(words, block.near + k);
    const F radius = hn::LoadU(floats, block.h + k);
    const F depth = hn::Min(hn::Mul(mostK, depthArea), mostDepth);
    const I isThick =
      flags(hn::Gt(hn::Mul(depth, peak), hn::Mul(thick, hn::Max(hn::Mul(radius, radius), peak))));
    const I named = hn::Or(slab, hn::And(absorbing, isThick));
    const I isNamed = hn::Or(named, near);
    const auto wordOfKind = [](SplatKind kind) {
      return hn::Set(words, static_cast<std::int32_t>(kind));
    };
    const I farKind = hn::And(
      absorbing, choose(named, wordOfKind(SplatKind::Slab), wordOfKind(SplatKind::Absorbs)));
    const I kind = choose(near, wordOfKind(SplatKind::Near), farKind);
    I fate = choose(slab, choose(grey, wordOf(Fate::SlabGrey), wordOf(Fate::SlabColors)),
      choose(grey, wordOf(Fate::AbsorbsGrey), wordOf(Fate::AbsorbsColors)));
    fate = hn::And(fate, absorbing); // Fate::Emits is 0
    const I valid = flags(isValid), shown = hn::And(valid, flags(isShown));
    fate = choose(shown, fate, choose(valid, wordOf(Fate::Culled), wordOf(Fate::Invalid)));
    hn::StoreU(fate, words, reinterpret_cast<std::int32_t*>(block.fate) + k);

    F light[3];
    for (int c = 0; c < 3; ++c)
    {
      light[c] = hn::IfThenElse(
        absorbs, hn::Min(hn::Mul(K[c], depthArea), mostDepth), hn::Mul(L[c], lightArea));
    }
    const I name = hn::LoadU(words, reinterpret_cast<const std::int32_t*>(lights.particle) + k);
    const auto asFloat = [](I bits) { return hn::BitCast(floats, bits); };
    light[0] = asFloat(choose(isNamed, name, hn::BitCast(words, light[0])));
    const auto areaOr = [&](F area, F other) {
      return asFloat(choose(isNamed, hn::BitCast(words, area), hn::BitCast(words, other)));
    };
    light[1] = areaOr(lightArea, light[1]);
    light[2] = areaOr(depthArea, light[2]);
    const I bright = hn::And(shown, hn::BitCast(words, hn::Mul(mostL, lightArea)));
    brightest = hn::Max(brightest, hn::And(asFloat(bright), asFloat(countedLanes(k, count))));
    for (F& l : light)
    {
      l = asFloat(hn::And(shown, hn::BitCast(words, l)));
    }
    // What is not shown lies beside every tile.
    const F h = asFloat(hn::And(shown, hn::BitCast(words, radius)));
    const I beside = hn::Set(words,
      static_cast<std::int32_t>(Splat::pack(-Splat::farPixel, -Splat::farPixel, SplatKind::Emits)));
    const I place = hn::LoadU(words, reinterpret_cast<const std::int32_t*>(block.where) + k);
    const I where = choose(shown, hn::Or(place, hn::ShiftLeft<Splat::kindBit>(kind)), beside);
    hn::StoreInterleaved4(asFloat(where), hn::LoadU(floats, block.x + k),
      hn::LoadU(floats, block.y + k), h, floats, block.head[k]);
    hn::StoreInterleaved4(zero, light[0], light[1], light[2], floats, block.tail[k]);
  }
  block.brightest = hn::GetLane(hn::MaxOfLanes(floats, brightest));
}

void projectVectors(const BlockPlaces& places, const BlockLights& lights, int count,
  const Lens& lens, const TileGrid& grid, SplatBlock& block)
{
  projectPlaces(places, lights, count, lens, grid, block);
  lightPlaces(lights, count, block);
}

int listVectors(const std::uint32_t* home, int count, const TileSpan& span, std::uint32_t* which)
{
  const I first = hn::Set(words, span.first), end = hn::Set(words, span.end);
  const I firstRow = hn::Set(words, span.firstRow()), lastRow = hn::Set(words, span.lastRow());
  const I mask = hn::Set(words, 0x7fff);
  int listed = 0;
  int k = 0;
  for (; k + static_cast<int>(hn::Lanes(words)) <= count; k += static_cast<int>(hn::Lanes(words)))
  {
    const I h = hn::LoadU(words, reinterpret_cast<const std::int32_t*>(home) + k);
    const auto isOne = hn::AndNot(hn::Lt(h, first), hn::Lt(h, end));
    // Several tiles' homes are negative numbers; the last two name no tile, whatever their rows.
    const auto isBeside = hn::Or(
      hn::Gt(hn::And(h, mask), lastRow), hn::Lt(hn::And(hn::ShiftRight<15>(h), mask), firstRow));
    const auto isIn = hn::Or(isOne, hn::AndNot(isBeside, hn::Lt(h, hn::Set(words, -2))));
    // One after the other, without branches: a vector's lanes are compressed through a table that
    // compilers copy each time.
    HWY_ALIGN std::int32_t found[8];
    hn::Store(hn::IfThenElseZero(isIn, hn::Set(words, 1)), words, found);
    for (int lane = 0; lane < static_cast<int>(hn::Lanes(words)); ++lane)
    {
      which[listed] = static_cast<std::uint32_t>(k + lane);
      listed += found[lane];
    }
  }
  for (; k < count; ++k)
  {
    const std::uint32_t h = home[k];
    const int row0 = static_cast<int>(h & 0x7fff), row1 = static_cast<int>(h >> 15 & 0x7fff);
    const bool isIn = TileHome::isOne(h)
      ? span.has(static_cast<int>(h))
      : h < TileHome::invalid && row0 <= span.lastRow() && row1 >= span.firstRow();
    which[listed] = static_cast<std::uint32_t>(k);
    listed += isIn;
  }
  return listed;
}
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace galaxy
{
HWY_EXPORT(listVectors);
HWY_EXPORT(locateVectors);
HWY_EXPORT(projectVectors);

void locateBlock(
  const BlockPlaces& places, int count, const Lens& lens, const TileGrid& grid, BlockTiles& tiles)
{
  HWY_DYNAMIC_DISPATCH(locateVectors)(places, count, lens, grid, tiles);
}

void projectBlock(const BlockPlaces& places, const BlockLights& lights, int count, const Lens& lens,
  const TileGrid& grid, SplatBlock& block)
{
  HWY_DYNAMIC_DISPATCH(projectVectors)(places, lights, count, lens, grid, block);
}

int listInTiles(const std::uint32_t* home, int count, const TileSpan& span, std::uint32_t* which)
{
  return HWY_DYNAMIC_DISPATCH(listVectors)(home, count, span, which);
}
} // namespace galaxy
#endif
