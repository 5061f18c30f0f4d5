#ifndef galaxy_Footprint_h
#define galaxy_Footprint_h

#include "Filters/Splatting/CubicSpline.h"
#include "Filters/Splatting/Lanes.h"
#include "Filters/Splatting/Projection.h"
#include "Filters/Splatting/Tiles.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
/// Red, green and blue of the pixels of a row lie side by side, so that even a footprint of five
/// pixels fills a vector. A row and what a step from its last pixel may touch beyond, in floats:
constexpr int tileStride = 3 * tileWidth + laneCount;

/// erf(u) for |u| <= 4 and +-1 beyond, to 2e-7: u P(u^2), P through the Chebyshev nodes.
class ErfPolynomial
{
public:
  static constexpr int degree = 15;
  ErfPolynomial();
  GALAXY_INLINE Lanes operator()(Lanes u) const
  {
    const Lanes v = maximum(minimum(u, Lanes{} + 4.0f), Lanes{} - 4.0f);
    const Lanes s = v * v * 0.125f - 1.0f;
    Lanes sum = Lanes{} + this->coefficients[degree];
    for (int k = degree - 1; k >= 0; --k)
    {
      sum = sum * s + this->coefficients[k];
    }
    return v * sum;
  }

private:
  float coefficients[degree + 1];
};
extern const ErfPolynomial erfPolynomial;

/// The pixels of a tile that a splat touches.
struct TileBox
{
  int x0, y0, columns, rows;
  /// False if there are none.
  GALAXY_INLINE bool clip(const Splat& splat, float h)
  {
    this->x0 = first(splat.column, splat.x - h);
    this->y0 = first(splat.row, splat.y - h);
    this->columns = end(splat.column, splat.x + h, tileWidth) - this->x0;
    this->rows = end(splat.row, splat.y + h, tileHeight) - this->y0;
    return this->columns > 0 && this->rows > 0;
  }
  /// Vectors of a row.
  int steps() const { return (3 * this->columns + laneCount - 1) / laneCount; }
  /// The centre, pixels from the box's corner.
  float centerX(const Splat& splat) const { return splat.x + (splat.column - this->x0); }
  float centerY(const Splat& splat) const { return splat.y + (splat.row - this->y0); }

private:
  GALAXY_INLINE static int first(int pixel, float low)
  {
    return static_cast<int>(std::max(pixel + std::floor(low), 0.0f));
  }
  GALAXY_INLINE static int end(int pixel, float high, int size)
  {
    return static_cast<int>(std::min(pixel + std::floor(high) + 1, float(size)));
  }
};

/// exp(-b^2/sigma^2), sigma = h/3, in the pixels that touch the disc b < h: in each the pixel's
/// mean, which is a product of a function of its column and one of its row. The sum over all pixels
/// is 1 to 2e-5 for any size and place.
class GaussianFootprint
{
public:
  /// False if the splat misses the tile.
  GALAXY_INLINE bool prepare(const Splat& splat)
  {
    const float h = std::max(splat.h, 1e-4f);
    if (!this->box.clip(splat, h))
    {
      return false;
    }
    this->h2 = h * h;
    const float a = 3 / h;
    const float x = this->box.centerX(splat);
    const float y = this->box.centerY(splat);
    const float gain = 1 / (1 - missingShare(a));
    if (a > narrowest && std::max(this->box.columns, this->box.rows) <= half)
    {
      this->smallAxes(x, y, a, gain);
      return true;
    }
    for (int i = 0; i < this->box.columns; i += laneCount)
    {
      const PixelMeans means(laneNumbers() + (i - x), a);
      storeThrice(this->column + 3 * i, gain * means.share);
      storeThrice(this->columnGap + 3 * i, means.gap2);
    }
    for (int j = 0; j < this->box.rows; j += laneCount)
    {
      const PixelMeans means(laneNumbers() + (j - y), a);
      storeLanes(this->row + j, means.share);
      storeLanes(this->rowGap + j, means.gap2);
    }
    return true;
  }

  /// The weights of one vector's pixels, row by row.
  struct Step
  {
    const GaussianFootprint& footprint;
    Lanes share;
    Lanes gap2;
    GALAXY_INLINE Lanes operator()(int y) const
    {
      const Lanes inside =
        this->gap2 < this->footprint.h2 - this->footprint.rowGap[y] ? this->share : Lanes{};
      return this->footprint.row[y] * inside;
    }
  };
  GALAXY_INLINE Step step(int s) const
  {
    return { *this, loadLanes(this->column + laneCount * s),
      loadLanes(this->columnGap + laneCount * s) };
  }
  TileBox box;

private:
  /// Above this, 1/2.5 pixels, differences of erf are used; below, where they would lose digits,
  /// the series. They agree to 2e-6 of the centre there.
  static constexpr float narrowest = 0.4f;
  static constexpr int half = laneCount / 2 - 1; ///< pixels between half a vector of edges

  /// What the pixels that touch the disc leave out, averaged over the centre's place in its pixel:
  /// a disc of radius h touches pi h^2 + 4 h + 1 pixels, those of a disc 2/pi wider.
  GALAXY_INLINE static float missingShare(float a)
  {
    const float edge = 3 + 0.6366f * a;
    return decay(Lanes{} + edge * edge)[0];
  }

  GALAXY_INLINE static Lanes squaredGap(Lanes d)
  {
    const Lanes x = d + 0.5f;
    const Lanes gap = maximum(maximum(x, -x) - 0.5f, Lanes{});
    return gap * gap;
  }

  /// The means of a/sqrt(pi) exp(-(a x)^2) over the pixels of an axis that begin at d from the
  /// centre, and their squared distance to it.
  struct PixelMeans
  {
    Lanes share;
    Lanes gap2;
    GALAXY_INLINE PixelMeans(Lanes d, float a)
      : share(a > narrowest ? 0.5f * (erfPolynomial(a * (d + 1.0f)) - erfPolynomial(a * d))
                            : wideMean(d + 0.5f, a))
      , gap2(squaredGap(d))
    {
    }
  };

  /// exp(-a^2 (x+u)^2) = exp(-a^2 x^2) exp(-2 a^2 x u - a^2 u^2), expanded in u and averaged over
  /// the pixel |u| < 1/2 to fourth order.
  GALAXY_INLINE static Lanes wideMean(Lanes x, float a)
  {
    const Lanes q = a * x;
    const float B = a * a;
    const Lanes A = 4 * B * (q * q);
    const Lanes second = 0.5f * A - B;
    const Lanes fourth = A * A * (1.0f / 24) - 0.5f * B * A + 0.5f * B * B;
    return a * 0.564189584f * decay(q * q) * (1 + second * (1.0f / 12) + fourth * (1.0f / 80));
  }

  /// Both axes in one vector: edges of columns in its first half, of rows in its second.
  GALAXY_INLINE void smallAxes(float x, float y, float a, float gain)
  {
    const Lanes edge = { 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7 };
    const Lanes center = { x, x, x, x, x, x, x, x, y, y, y, y, y, y, y, y };
    const IntLanes following = { 1, 2, 3, 4, 5, 6, 7, 7, 9, 10, 11, 12, 13, 14, 15, 15 };
    const Lanes d = edge - center;
    const Lanes cumulative = erfPolynomial(a * d);
    const Lanes share = 0.5f * (__builtin_shuffle(cumulative, following) - cumulative);
    const Lanes gap2 = squaredGap(d);
    const Lanes columnShare = laneNumbers() < half + 0.5f ? share : Lanes{};
    storeThrice(this->column, gain * columnShare);
    storeThrice(this->columnGap, gap2);
    const IntLanes upper = { 8, 9, 10, 11, 12, 13, 14, 15, 8, 9, 10, 11, 12, 13, 14, 15 };
    storeLanes(this->row, __builtin_shuffle(share, upper));
    storeLanes(this->rowGap, __builtin_shuffle(gap2, upper));
  }

  float h2;
  alignas(64) float column[tileStride + 3 * laneCount];
  alignas(64) float columnGap[tileStride + 3 * laneCount];
  alignas(64) float row[tileHeight + laneCount];
  alignas(64) float rowGap[tileHeight + laneCount];
};

/// The projected cubic spline: in each pixel the mean over n x n cells of four Gauss points each,
/// so many that a cell is at most h/4 wide. The sum over all pixels is 1 to 3e-5.
class SplineFootprint
{
public:
  bool prepare(const Splat& splat);

  struct Step
  {
    const float* first;
    GALAXY_INLINE Lanes operator()(int y) const { return loadLanes(this->first + tileStride * y); }
  };
  GALAXY_INLINE Step step(int s) const { return { this->weights[0] + laneCount * s }; }
  TileBox box;

private:
  /// Of the 2 n Gauss points a pixel along one axis, those that may touch the splat.
  struct Points
  {
    int first, last;
    float cell; ///< 1/n pixels
    float at(int k) const;
  };
  static Points points(float center, float h, int pixels, int n);

  float pixel[tileHeight][tileWidth];
  alignas(64) float weights[tileHeight][tileStride]; ///< each pixel's three times
};
} // namespace galaxy

#endif
