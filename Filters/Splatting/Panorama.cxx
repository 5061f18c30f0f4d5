#include "Filters/Splatting/Panorama.h"

#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/WorkProgress.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/SkyFace.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// The directions of samples x samples points of every pixel, evenly over it.
class Samples
{
public:
  static constexpr int aSide = 2;
  static constexpr int aPixel = aSide * aSide;

  explicit Samples(const Panorama& panorama)
    : panorama(panorama)
  {
    if (panorama.kind == Panorama::Kind::Equirectangular)
    {
      // Sines and cosines would else take longer than all the rest.
      this->longitudes = circle(aSide * panorama.width, 2 * M_PI);
      this->latitudes = circle(aSide * panorama.height, M_PI);
    }
  }

  /// Sample k of a pixel; false outside of the dome.
  bool direction(int column, int row, int k, Vec3& direction) const
  {
    const int i = aSide * column + k % aSide, j = aSide * row + k / aSide;
    if (this->longitudes.empty())
    {
      return this->panorama.direction((i + 0.5) / aSide, (j + 0.5) / aSide, direction);
    }
    const Point& longitude = this->longitudes[i];
    const Point& latitude = this->latitudes[j];
    const Camera& ahead = this->panorama.ahead;
    direction = (latitude.cosine * longitude.sine) * ahead.right + latitude.sine * ahead.up +
      (latitude.cosine * longitude.cosine) * ahead.forward;
    return true;
  }

private:
  struct Point
  {
    double sine, cosine;
  };
  static std::vector<Point> circle(int count, double whole)
  {
    std::vector<Point> points;
    for (int k = 0; k < count; ++k)
    {
      const double angle = ((k + 0.5) / count - 0.5) * whole;
      points.push_back({ std::sin(angle), std::cos(angle) });
    }
    return points;
  }

  const Panorama& panorama;
  std::vector<Point> longitudes, latitudes;
};

/// The quadratic B-spline over the three pixels around a point, from the left one's middle on. Far
/// from a face's axis samples lie a pixel apart: between fewer pixels, a point of light
/// would count more or less as it happens to lie.
struct PixelSpline
{
  int first;
  double of[3];

  PixelSpline(double x, int side)
  {
    const int middle = std::clamp(static_cast<int>(x), 1, side - 2);
    const double t = x - middle - 0.5;
    this->first = middle - 1;
    this->of[0] = 0.5 * (0.5 - t) * (0.5 - t);
    this->of[1] = 0.75 - t * t;
    this->of[2] = 0.5 * (0.5 + t) * (0.5 + t);
  }
};

void addInterpolated(const std::vector<float>& values, int side, const PixelSpline& x,
  const PixelSpline& y, double weight, double* sum)
{
  for (int j = 0; j < 3; ++j)
  {
    const float* row = &values[3 * (std::size_t(y.first + j) * side + x.first)];
    const double inRow = weight * y.of[j];
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += inRow * (x.of[0] * row[c] + x.of[1] * row[3 + c] + x.of[2] * row[6 + c]);
    }
  }
}

/// What a face adds to a pixel.
void addFace(const Samples& samples, const SkyFace& face, const RenderedImage& picture, int column,
  int row, RenderedImage& to)
{
  double light[3] = {}, through[3] = {};
  for (int k = 0; k < Samples::aPixel; ++k)
  {
    Vec3 direction;
    double x, y;
    if (!samples.direction(column, row, k, direction))
    {
      continue;
    }
    const double share = face.share(direction, x, y) / Samples::aPixel;
    if (share > 0)
    {
      const PixelSpline columns(x, picture.width), rows(y, picture.width);
      addInterpolated(picture.radiance, picture.width, columns, rows, share, light);
      addInterpolated(picture.transmittance, picture.width, columns, rows, share, through);
    }
  }
  const std::size_t pixel = 3 * (std::size_t(row) * to.width + column);
  for (int c = 0; c < 3; ++c)
  {
    to.radiance[pixel + c] += static_cast<float>(light[c]);
    to.transmittance[pixel + c] += static_cast<float>(through[c]);
  }
}

/// False where `progress` has ended it.
bool addFace(const Panorama& panorama, const Samples& samples, const SkyFace& face,
  const RenderedImage& picture, const Progress& progress, RenderedImage& to)
{
  WorkProgress work(progress);
  work.begin(1, to.height);
  const double cosine = std::cos(std::min(SkyFace::farthest() + panorama.largestPixel(), M_PI));
  parallelForDynamic<int>(0, to.height, 8, [&](int row) {
    const bool isWanted = work.advance(1);
    for (int column = 0; isWanted && column < to.width; ++column)
    {
      Vec3 one;
      const bool isSeen = samples.direction(column, row, 0, one);
      if (!isSeen || dot(one, face.camera().forward) >= cosine)
      {
        addFace(samples, face, picture, column, row, to);
      }
    }
  });
  return !work.isAborted();
}

/// The light from outside of the dome, which nothing hides.
void fillOutside(const Samples& samples, RenderedImage& image)
{
  for (int row = 0; row < image.height; ++row)
  {
    for (int column = 0; column < image.width; ++column)
    {
      int outside = 0;
      for (int k = 0; k < Samples::aPixel; ++k)
      {
        Vec3 direction;
        outside += !samples.direction(column, row, k, direction);
      }
      const float share = static_cast<float>(outside) / Samples::aPixel;
      std::fill_n(&image.transmittance[3 * (std::size_t(row) * image.width + column)], 3, share);
    }
  }
}

void addStatistics(const RenderStatistics& from, RenderStatistics& to)
{
  const std::size_t invalid = std::max(to.invalid, from.invalid);
  to += from;
  to.invalid = invalid;
  to.tiles += from.tiles;
  to.bySlices |= from.bySlices;
  to.sampled = std::max(to.sampled, from.sampled);
  to.untouched += from.untouched;
  to.faint += from.faint;
  to.tooBright += from.tooBright;
  to.bound.light = std::max(to.bound.light, from.bound.light);
  to.bound.share = std::max(to.bound.share, from.bound.share);
  to.thickest = std::max(to.thickest, from.thickest);
  to.coarse += from.coarse;
  to.raySums += from.raySums;
  to.addSeconds(from);
}

/// The faces that a panorama shows something of.
std::vector<int> facesOf(const Panorama& panorama)
{
  const bool isDome = panorama.kind == Panorama::Kind::Dome;
  const double farthest = isDome ? panorama.domeAngle * M_PI / 360 : M_PI;
  std::vector<int> faces;
  for (int face = 0; face < SkyFace::count; ++face)
  {
    if (SkyFace::nearest(face) < farthest)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

RenderedImage emptyPanorama(const Panorama& panorama, const Samples& samples)
{
  RenderedImage image;
  image.width = panorama.width;
  image.height = panorama.height;
  const std::size_t values = 3 * std::size_t(image.width) * std::size_t(image.height);
  image.radiance.assign(values, 0.0F);
  image.transmittance.assign(values, 0.0F);
  if (panorama.kind == Panorama::Kind::Dome)
  {
    fillOutside(samples, image);
  }
  return image;
}
} // namespace

bool Panorama::direction(double x, double y, Vec3& direction) const
{
  double right, up, forward;
  if (this->kind == Kind::Equirectangular)
  {
    const double longitude = (x / this->width - 0.5) * 2 * M_PI;
    const double latitude = (y / this->height - 0.5) * M_PI;
    right = std::cos(latitude) * std::sin(longitude);
    up = std::sin(latitude);
    forward = std::cos(latitude) * std::cos(longitude);
  }
  else
  {
    const double radius = 0.5 * std::min(this->width, this->height);
    const double u = (x - 0.5 * this->width) / radius, v = (y - 0.5 * this->height) / radius;
    const double r = std::hypot(u, v);
    if (r > 1)
    {
      return false;
    }
    const double angle = r * this->domeAngle * M_PI / 360;
    const double sine = r > 0 ? std::sin(angle) / r : 0;
    right = sine * u;
    up = sine * v;
    forward = std::cos(angle);
  }
  direction = right * this->ahead.right + up * this->ahead.up + forward * this->ahead.forward;
  return true;
}

double Panorama::finest() const
{
  if (this->kind == Kind::Equirectangular)
  {
    return std::max(this->width / (2 * M_PI), this->height / M_PI);
  }
  const double half = this->domeAngle * M_PI / 360;
  const double outward = 0.5 * std::min(this->width, this->height) / half;
  // Around the zenith a circle at the angle t has t / sin t times as many pixels a radian.
  const double angle = std::min(half, M_PI / 2);
  return outward * angle / std::sin(angle);
}

double Panorama::largestPixel() const
{
  return this->kind == Kind::Equirectangular
    ? 2 * M_PI / this->width + M_PI / this->height
    : this->domeAngle * M_PI / 90 / std::min(this->width, this->height);
}

RenderedImage renderPanorama(
  const ParticleView& particles, const Panorama& panorama, const RenderOptions& options)
{
  requireMemoryOfPicture(panorama.width, panorama.height);
  const Samples samples(panorama);
  RenderedImage image = emptyPanorama(panorama, samples);
  const std::vector<int> faces = facesOf(panorama);
  const double count = static_cast<double>(faces.size());
  constexpr double drawingShare = 0.7; // of a face's time; the rest is spreading it over the sky
  RenderOptions faceOptions = options;
  faceOptions.opaqueDepth = nullptr;
  faceOptions.previewTime = options.previewTime / count;
  for (std::size_t k = 0; k < faces.size(); ++k)
  {
    const double begin = double(k) / count, end = double(k + 1) / count;
    const double drawn = begin + drawingShare * (end - begin);
    faceOptions.progress = partOf(options.progress, begin, drawn);
    const Progress adding = partOf(options.progress, drawn, end);
    const SkyFace face(panorama.ahead, faces[k], panorama.finest());
    const RenderedImage picture = render(particles, face.camera(), faceOptions);
    if (picture.aborted || !addFace(panorama, samples, face, picture, adding, image))
    {
      std::fill(image.radiance.begin(), image.radiance.end(), 0.0F);
      std::fill(image.transmittance.begin(), image.transmittance.end(), 1.0F);
      image.aborted = true;
      return image;
    }
    addStatistics(picture.statistics, image.statistics);
  }
  return image;
}
} // namespace galaxy
