#ifndef galaxy_TileSlicer_h
#define galaxy_TileSlicer_h

#include "Filters/Splatting/ErrorFunction.h"
#include "Filters/Splatting/FootprintShare.h"
#include "Filters/Splatting/GaussianKernel.h"
#include "Filters/Splatting/OpticalModel.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/Projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace galaxy
{

/// A splat with what the slices need.
struct Ball
{
  double x, y;     ///< centre, pixels from the tile's corner
  double h;        ///< pixels
  double distance; ///< from the eye (parallel: depth), kpc
  double sigma;    ///< along the ray, kpc
  double e[3], t[3];
  std::shared_ptr<const NearParticle> near; ///< then x, y and h mean nothing
};

/// The direction of the ray through a pixel's middle, as (tan x, tan y, 1), of no length.
struct Ray
{
  double u, v;
  double length() const { return std::sqrt(1 + this->u * this->u + this->v * this->v); }
  double dot(const Ray& other) const { return 1 + this->u * other.u + this->v * other.v; }
};

/// Slices of equal thickness through the depths where something absorbs, one for all before them
/// and one for all behind: there light adds up, however it lies.
struct Slices
{
  double observer = 0; ///< what lies behind him is not seen
  double start = 0;
  double thickness = 1;
  int inner = 0;

  int count() const { return this->inner + 2; }
  /// Where slice s begins.
  double edge(int s) const
  {
    return s == 0          ? this->observer
      : s == this->count() ? std::numeric_limits<double>::infinity()
                           : this->start + (s - 1) * this->thickness;
  }
  int at(double depth) const
  {
    const double s = std::floor((depth - this->start) / this->thickness) + 1;
    return s > 0 ? static_cast<int>(std::min(s, double(this->count() - 1))) : 0;
  }
};

/// The particles of a tile in slices of depth, in each of which emission and absorption are mixed
/// evenly, row by row of its pixels.
class TileSlicer
{
public:
  TileSlicer(const Camera& camera, const RenderOptions& options, const TileGrid& grid, int tile)
    : camera(camera)
    , options(options)
    , number(tile)
    , left(grid.leftOf(tile))
    , bottom(grid.bottomOf(tile))
    , box(grid.pixelsOf(tile))
    , columns(box.x1 - box.x0)
    , rows(box.y1 - box.y0)
  {
  }

  /// To be called before any row is drawn.
  void set(
    const Splat* splats, std::size_t count, const TileDepths& depths, const Projection& projection)
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      this->balls.push_back(this->ballOf(splats[k], depths, projection));
    }
    this->slices = this->slicesOf();
  }

  /// How many sums along rays it takes: one for every slice that a particle reaches into, in every
  /// pixel.
  double work() const
  {
    double sum = double(this->columns) * this->rows * this->slices.count();
    for (const Ball& ball : this->balls)
    {
      const double slices = 1 + this->slices.at(ball.distance + reach * ball.sigma) -
        this->slices.at(ball.distance - reach * ball.sigma);
      sum += slices * this->rowsOf(ball).count() * this->columnsOf(ball).count();
    }
    return sum;
  }

  int tile() const { return this->number; }
  /// Rows of pixels that lie in the picture.
  int firstRow() const { return this->box.y0; }
  int lastRow() const { return this->box.y1; }

  /// Light is counted in such a unit; says how many values single precision does not hold.
  std::size_t drawRow(int y, double unit, RenderedImage& image)
  {
    this->sums.assign(std::size_t(this->columns) * this->slices.count() * 6, 0.0);
    for (const Ball& ball : this->balls)
    {
      if (this->rowsOf(ball).has(y))
      {
        this->spread(ball, y);
      }
    }
    return this->march(y, unit, image);
  }

  /// Whether there are fewer slices than the options ask for.
  bool isCoarse() const { return this->slices.inner == mostSlices; }

private:
  Ray rayThrough(double x, double y) const
  {
    return { (this->left + x - this->camera.centerX) / this->camera.scale,
      (this->bottom + y - this->camera.centerY) / this->camera.scale };
  }

  Ball ballOf(const Splat& splat, const TileDepths& depths, const Projection& projection) const
  {
    Ball ball = {};
    ball.x = double(splat.column()) + splat.x;
    ball.y = double(splat.row()) + splat.y;
    ball.h = splat.h;
    ball.distance = depths.depthOf(splat.depth);
    const SlabLight light = projection.lightOf(splat);
    std::copy_n(light.e, 3, ball.e);
    std::copy_n(light.t, 3, ball.t);
    if (splat.kind() == SplatKind::Near)
    {
      const NearParticle near = projection.near(splat);
      ball.near = std::make_shared<const NearParticle>(near);
      ball.sigma = near.sigma;
      return ball;
    }
    const Ray middle = this->rayThrough(ball.x, ball.y);
    const double h = projection.lens().smoothingLength(
      middle.u, middle.v, ball.h / this->camera.scale, ball.distance);
    // A point keeps a width of its own, so that it has a place among the slices.
    const double least = 1e-7 * std::max(1e-3, std::abs(ball.distance));
    ball.sigma = std::max(NearParticle::sigmas(this->options.kernel) * h, least);
    return ball;
  }

  Slices slicesOf() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double near = infinity, far = -infinity, smallest = infinity;
    for (const Ball& ball : this->balls)
    {
      if (ball.t[0] > 0 || ball.t[1] > 0 || ball.t[2] > 0)
      {
        // On a ray beside its centre a ball is nearer than that by less than so much.
        const double b = 3 * ball.sigma;
        const double nearer = this->camera.parallel ? 0 : b * b / std::max(ball.distance, b);
        near = std::min(near, ball.distance - reach * ball.sigma - nearer);
        far = std::max(far, ball.distance + reach * ball.sigma);
        smallest = std::min(smallest, ball.sigma);
      }
    }
    Slices slices;
    slices.observer = this->camera.parallel ? -infinity : 0;
    if (far > near)
    {
      slices.start = std::max(near, slices.observer);
      const double wanted = (far - slices.start) / smallest * this->options.slices;
      slices.inner = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, double(mostSlices)));
      slices.thickness = (far - slices.start) / slices.inner;
    }
    return slices;
  }

  double* sumsAt(int x, int s)
  {
    return &this->sums[6 * (std::size_t(x - this->box.x0) * this->slices.count() + s)];
  }
  const double* sumsAt(int x, int s) const { return const_cast<TileSlicer*>(this)->sumsAt(x, s); }

  /// Of a row or a column of pixels, those that a ball may touch.
  struct Range
  {
    int first, last; ///< one beyond
    int count() const { return std::max(0, this->last - this->first); }
    bool has(int pixel) const { return pixel >= this->first && pixel < this->last; }
  };
  static Range range(double centre, double radius, int first, int last)
  {
    const double h = std::max(radius, 1e-4);
    const auto within = [first, last](double pixel) {
      return static_cast<int>(std::clamp(std::floor(pixel), double(first), double(last)));
    };
    return { within(centre - h), within(centre + h + 1) };
  }
  Range columnsOf(const Ball& ball) const
  {
    return ball.near ? Range{ this->box.x0, this->box.x1 }
                     : range(ball.x, ball.h, this->box.x0, this->box.x1);
  }
  Range rowsOf(const Ball& ball) const
  {
    return ball.near ? Range{ this->box.y0, this->box.y1 }
                     : range(ball.y, ball.h, this->box.y0, this->box.y1);
  }

  void spread(const Ball& ball, int y)
  {
    const Range across = this->columnsOf(ball);
    FootprintShares shares(this->options.kernel, ball.x, ball.y, ball.h);
    for (int x = across.first; x < across.last; ++x)
    {
      const double share = ball.near ? this->nearShare(ball, x, y) : shares.of(x, y);
      if (share > 0)
      {
        this->spreadOnRay(ball, x, y, share);
      }
    }
  }

  double nearShare(const Ball& ball, int x, int y) const
  {
    const double sigma = this->camera.scale * NearParticle::sigmas(this->options.kernel);
    const Ray ray = this->rayThrough(x + 0.5, y + 0.5);
    return ball.near->profile(ray.u, ray.v) / (sigma * sigma);
  }

  std::size_t march(int y, double unit, RenderedImage& image) const
  {
    std::size_t tooBright = 0;
    for (int x = this->box.x0; x < this->box.x1; ++x)
    {
      const std::size_t pixel = std::size_t(this->bottom + y) * this->camera.width + this->left + x;
      for (int c = 0; c < 3; ++c)
      {
        double I = 0, T = 1;
        for (int s = 0; s < this->slices.count(); ++s)
        {
          const double* sum = this->sumsAt(x, s);
          const double tau = sum[3 + c];
          I += T * sum[c] * (tau > 0 ? escapeFraction(tau) : 1);
          T *= tau > 0 ? std::exp(-tau) : 1;
        }
        image.radiance[3 * pixel + c] = toSingle(unit * I, tooBright);
        image.transmittance[3 * pixel + c] = static_cast<float>(T);
      }
    }
    return tooBright;
  }

  /// Where along the pixel's ray the ball's centre is nearest.
  double depthOnRay(const Ball& ball, int x, int y) const
  {
    if (ball.near)
    {
      const Ray ray = this->rayThrough(x + 0.5, y + 0.5);
      return ball.near->along(ray.u, ray.v) * ball.sigma;
    }
    if (this->camera.parallel)
    {
      return ball.distance;
    }
    const Ray ray = this->rayThrough(x + 0.5, y + 0.5);
    const Ray centre = this->rayThrough(ball.x, ball.y);
    return ball.distance * ray.dot(centre) / (ray.length() * centre.length());
  }

  void spreadOnRay(const Ball& ball, int x, int y, double share)
  {
    const double depth = this->depthOnRay(ball, x, y);
    const std::size_t pixel = std::size_t(this->bottom + y) * this->camera.width + this->left + x;
    const double opaque = this->options.opaqueDepth ? this->options.opaqueDepth[pixel]
                                                    : std::numeric_limits<double>::infinity();
    const int last = this->slices.at(depth + reach * ball.sigma);
    int s = this->slices.at(depth - reach * ball.sigma);
    // What lies beyond the reach counts to the first slice and to the last.
    double before = s > 0 ? -1 : this->erf((this->slices.observer - depth) / ball.sigma);
    for (; s <= last && this->slices.edge(s) < opaque; ++s)
    {
      const double end = std::min(
        s < last ? this->slices.edge(s + 1) : std::numeric_limits<double>::infinity(), opaque);
      const double after = this->erf((end - depth) / ball.sigma);
      const double part = 0.5 * (after - before) * share;
      double* sum = this->sumsAt(x, s);
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += part * ball.e[c];
        sum[3 + c] += part * ball.t[c];
      }
      before = after;
    }
  }

  static const ErrorFunction& table()
  {
    static const ErrorFunction function;
    return function;
  }

  /// A Gaussian's part beyond so many sigma is left out along the ray: erfc(4) = 2e-8.
  static constexpr double reach = 4;
  static constexpr int mostSlices = 4096;

  const ErrorFunction& erf = table();
  const Camera& camera;
  const RenderOptions& options;
  int number;
  int left, bottom; ///< the tile's corner
  PixelBox box;     ///< of the tile that lie in the picture
  int columns, rows;
  std::vector<Ball> balls;
  Slices slices;
  std::vector<double>
    sums; ///< of a row, by pixel and slice: emission and optical depth of three channels
};
} // namespace galaxy

#endif
