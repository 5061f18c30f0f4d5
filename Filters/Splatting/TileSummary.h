#ifndef galaxy_TileSummary_h
#define galaxy_TileSummary_h

#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/TileComposite.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace galaxy
{
/// Sums of numbers by their binary exponent: so that the smallest of them are found whose sum is
/// small.
class SumsBySize
{
public:
  void add(float x);
  double total() const { return this->all; }
  /// Of the smallest numbers, as many as their sum is no more than `most`.
  struct Smallest
  {
    float below = 0; ///< they are; 0: none
    double sum = 0;
    std::size_t count = 0;
  };
  Smallest smallest(double most) const;

private:
  static constexpr int exponents = 255;
  std::array<double, exponents> sums = {};
  std::array<std::uint32_t, exponents> counts = {};
  double all = 0;
};

/// Whether all splats emit in proportion to their absorption, channel by channel, as absorbers
/// alone do: their light is then S (1 - e^-tau), whatever their order.
class OneSource
{
public:
  bool holds() const { return this->isOne; }
  double source(int channel) const;
  void add(const SlabLight& slab);

private:
  bool isOne = true;
  double S[3] = { -1, -1, -1 }; ///< negative: not known yet
};

/// What a picture leaves out of a tile.
struct Omission
{
  float light = 0;       ///< emitters fainter than this over a pixel
  float tau = 0;         ///< absorbers thinner than this in a pixel
  bool isOrdered = true; ///< whether the others' order matters
  ErrorBound bound;      ///< on the error

  bool omits() const { return this->light > 0 || this->tau > 0; }
  bool omits(const Splat& splat, const TileTask& task) const;
};

/// What the splats of a tile are in sum.
struct TileSummary
{
  TileAbsorption absorption = TileAbsorption::None;
  OneSource source;
  float brightest = 0; ///< the largest luminosity of one over a pixel's area
  float thickest = 0;  ///< the largest optical depth of one in a pixel

  /// Of the task's splats; `sums` are needed to know what may be left out.
  TileSummary(const TileTask& task, bool sums);

  /// What may be left out. Half of what is allowed is for the faintest splats, half for what their
  /// order, or what lies behind them, would change.
  Omission omission(const ErrorBound& allowed) const;

private:
  template <bool sums>
  void add(const TileTask& task);

  std::size_t splats;
  SumsBySize light, tau; ///< over a pixel that all of them have in their middle
};
} // namespace galaxy

#endif
