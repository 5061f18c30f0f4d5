#include "Readers/Formats/FitsPixels.h"

#include "Readers/Formats/AsinhScale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Pixels read at once: enough to be fast, few enough that progress is told often.
constexpr long long chunkPixels = 1 << 18;

/// The pixels of an HDU as physical values, NaN where blank.
class PixelSource
{
public:
  PixelSource(const FitsHandle& fits, const FitsHdu& hdu, const std::vector<double>& maskValues)
    : fits(fits)
    , maskValues(maskValues)
    , asinh(AsinhScale::of(hdu.header))
  {
    const bool scaled =
      hdu.header.number("BSCALE").value_or(1) != 1 || hdu.header.number("BZERO").value_or(0) != 0;
    // Quantised values are those of the image's own type, not of a wider one.
    this->single = hdu.bitpix == FLOAT_IMG && !scaled;
    this->maskInSingle = hdu.bitpix == FLOAT_IMG || (scaled && hdu.bitpix > 0);
    // CFITSIO's search for NaN in plain floats takes the smallest numbers for zero.
    this->findsBlanks = hdu.compressed || hdu.bitpix > 0;
  }

  /// The values of a box, in the file's order.
  const std::vector<double>& read(std::vector<long> first, std::vector<long> last, long long count)
  {
    this->values.resize(static_cast<std::size_t>(count));
    if (this->single)
    {
      this->singles.resize(this->values.size());
      float blank = std::numeric_limits<float>::quiet_NaN();
      this->readAs(TFLOAT, first, last, &blank, this->singles.data());
      std::copy(this->singles.begin(), this->singles.end(), this->values.begin());
    }
    else
    {
      double blank = nan;
      this->readAs(TDOUBLE, first, last, &blank, this->values.data());
    }
    for (double& value : this->values)
    {
      value = std::isfinite(value) && !this->isMasked(value) ? this->linear(value) : nan;
    }
    return this->values;
  }

private:
  void readAs(
    int type, std::vector<long>& first, std::vector<long>& last, void* blank, void* out) const
  {
    std::vector<long> step(first.size(), 1);
    int anyBlank = 0; // not optional, whatever the manual says: CFITSIO writes to it
    int status = 0;
    fits_read_subset(this->fits, type, first.data(), last.data(), step.data(),
      this->findsBlanks ? blank : nullptr, out, &anyBlank, &status);
    this->fits.check(status, "");
  }

  double linear(double value) const
  {
    const double flux = this->asinh ? this->asinh->flux(value) : value;
    return std::isfinite(flux) ? flux : nan;
  }

  bool isMasked(double value) const
  {
    return std::any_of(this->maskValues.begin(), this->maskValues.end(), [&](double mask) {
      return value == mask ||
        (this->maskInSingle && static_cast<float>(value) == static_cast<float>(mask));
    });
  }

  const FitsHandle& fits;
  const std::vector<double>& maskValues;
  const std::optional<AsinhScale> asinh;
  bool single = false;
  bool maskInSingle = false;
  bool findsBlanks = false;
  std::vector<double> values;
  std::vector<float> singles;
};

/// Sums the slabs of a plan into an image.
class SlabSum
{
public:
  SlabSum(PixelSource& source, const FitsPlan& plan, const Progress& progress, Image& image)
    : source(source)
    , plan(plan)
    , progress(progress)
    , image(image)
    , x(static_cast<std::size_t>(plan.axes[0] - 1))
    , y(static_cast<std::size_t>(plan.axes[1] - 1))
  {
    const std::size_t pixels = static_cast<std::size_t>(image.width) * image.height;
    image.values.assign(pixels, -0.0); // to which -0 can be added without becoming +0
    this->weights.assign(pixels, 0);
    for (const FitsSlab& slab : plan.slabs)
    {
      this->total += pixelsOf(slab.first, slab.last);
    }
  }

  void run()
  {
    for (const FitsSlab& slab : this->plan.slabs)
    {
      this->add(slab, slab.first, slab.last);
    }
    for (std::size_t i = 0; i < this->weights.size(); ++i)
    {
      double& value = this->image.values[i];
      value = this->weights[i] == 0 ? nan : this->plan.isMean ? value / this->weights[i] : value;
    }
  }

private:
  static long long pixelsOf(const std::vector<long>& first, const std::vector<long>& last)
  {
    long long pixels = 1;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      pixels *= last[i] - first[i] + 1;
    }
    return pixels;
  }

  /// Adds a box of the slab; a large one is cut along its slowest axis.
  void add(const FitsSlab& slab, const std::vector<long>& first, const std::vector<long>& last)
  {
    const long long pixels = pixelsOf(first, last);
    if (pixels <= chunkPixels)
    {
      this->deposit(slab, first, last, this->source.read(first, last, pixels));
      this->report(pixels);
      return;
    }
    std::size_t axis = first.size() - 1;
    while (first[axis] == last[axis])
    {
      --axis;
    }
    const long long slice = pixels / (last[axis] - first[axis] + 1);
    const long step = static_cast<long>(std::max<long long>(1, chunkPixels / slice));
    for (long start = first[axis]; start <= last[axis]; start += step)
    {
      std::vector<long> from = first;
      std::vector<long> to = last;
      from[axis] = start;
      to[axis] = std::min(start + step - 1, last[axis]);
      this->add(slab, from, to);
    }
  }

  void deposit(const FitsSlab& slab, const std::vector<long>& first, const std::vector<long>& last,
    const std::vector<double>& values)
  {
    std::vector<long> at = first;
    const std::size_t width = static_cast<std::size_t>(this->image.width);
    for (const double value : values)
    {
      if (!std::isnan(value))
      {
        const std::size_t pixel = static_cast<std::size_t>(at[this->y] - 1) * width +
          static_cast<std::size_t>(at[this->x] - 1);
        const bool sums = slab.weights.size() > 1;
        const long channel = sums ? at[slab.summedAxis] - slab.first[slab.summedAxis] : 0;
        const double weight = slab.weights[static_cast<std::size_t>(channel)];
        this->image.values[pixel] += weight * value;
        this->weights[pixel] += weight;
      }
      for (std::size_t axis = 0; axis < at.size() && ++at[axis] > last[axis]; ++axis)
      {
        at[axis] = first[axis];
      }
    }
  }

  void report(long long pixels)
  {
    this->done += pixels;
    if (this->progress &&
      !this->progress(static_cast<double>(this->done) / static_cast<double>(this->total)))
    {
      throw Aborted(this->image.file, "", "reading was ended");
    }
  }

  PixelSource& source;
  const FitsPlan& plan;
  const Progress& progress;
  Image& image;
  const std::size_t x;
  const std::size_t y;
  std::vector<double> weights;
  long long total = 0;
  long long done = 0;
};
} // namespace

void readPixels(const FitsHandle& fits, const FitsHdu& hdu, const FitsPlan& plan,
  const std::vector<double>& maskValues, const Progress& progress, Image& image)
{
  PixelSource source(fits, hdu, maskValues);
  SlabSum(source, plan, progress, image).run();
}
} // namespace galaxy
