#include "Filters/Model/FractalNoise.h"

#include "Filters/Model/NormalQuantile.h"
#include "Filters/Model/SineCosine.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
const double meanOfAbsolute = std::sqrt(2 / pi);
const double varianceOfAbsolute = 1 - 2 / pi;

/// A bijection of 64 bits in which every bit depends on all (Stafford's 13th variant of
/// MurmurHash3's finalizer, as in SplitMix64: Steele, Lea & Flood 2014).
std::uint64_t scrambled(std::uint64_t bits)
{
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111eb;
  return bits ^ bits >> 31;
}

/// Normal deviates by 64 random bits: the quantiles at the middles of 4096 equal shares, but in the
/// first and the last, the tails, where the bits themselves say, to 6.2 sigma. That makes the
/// variance 1 to 1e-4, and the exponentials of large contrasts what they should be.
class DeviateTable
{
public:
  DeviateTable()
  {
    for (std::size_t k = 0; k < this->values.size(); ++k)
    {
      this->values[k] = normalQuantile((2 * k + 1.0) / this->values.size() - 1);
    }
  }
  double operator[](std::uint64_t bits) const
  {
    const std::uint64_t k = bits >> 52;
    return k > 0 && k + 1 < this->values.size() ? this->values[k] : tail(bits);
  }

private:
  static double tail(std::uint64_t bits)
  {
    constexpr double largest = 1 - 0x1p-32;
    const double x = (static_cast<double>(bits >> 11) + 0.5) * 0x1p-52 - 1;
    return normalQuantile(std::clamp(x, -largest, largest));
  }

  std::array<double, 4096> values;
};

/// The cell of a coordinate and the weights of its two ends.
struct Cell
{
  explicit Cell(double x)
    : index(static_cast<std::int64_t>(x))
  {
    this->index -= x < static_cast<double>(this->index) ? 1 : 0;
    const double f = x - static_cast<double>(this->index);
    this->weights[1] = f * f * f * (f * (6 * f - 15) + 10);
    this->weights[0] = 1 - this->weights[1];
  }
  double sumOfSquares() const
  {
    return this->weights[0] * this->weights[0] + this->weights[1] * this->weights[1];
  }
  std::int64_t index;
  double weights[2];
};

double valueNoise(const Vec3& p, std::uint64_t seed)
{
  static const DeviateTable deviates;
  const Cell x(p.x), y(p.y), z(p.z);
  // Odd factors keep neighbours apart before they are scrambled.
  constexpr std::uint64_t a = 0x9e3779b97f4a7c15, b = 0xc2b2ae3d27d4eb4f, c = 0x165667b19e3779f9;
  const std::uint64_t origin = seed + a * x.index + b * y.index + c * z.index;
  double sum = 0;
  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      const std::uint64_t row = origin + j * b + k * c;
      const double atRow =
        x.weights[0] * deviates[scrambled(row)] + x.weights[1] * deviates[scrambled(row + a)];
      sum += y.weights[j] * z.weights[k] * atRow;
    }
  }
  return sum / std::sqrt(x.sumOfSquares() * y.sumOfSquares() * z.sumOfSquares());
}

/// A turn by 60 degrees about the diagonal.
Vec3 turned(const Vec3& p)
{
  return { (2 * p.x - p.y + 2 * p.z) / 3, (2 * p.x + 2 * p.y - p.z) / 3,
    (2 * p.y + 2 * p.z - p.x) / 3 };
}
} // namespace

FractalNoise::FractalNoise(const DustDescription& dust, const RandomKey& key)
  : ridged(dust.noise == FractalKind::Ridged)
{
  // Nothing of an octave depends on how many there are.
  constexpr std::uint64_t lattices = 1 << 16;
  double squares = 0;
  for (int k = 0; k < dust.octaves; ++k)
  {
    Random random(key, RandomStream::FractalNoise, k);
    Octave octave;
    octave.frequency = std::pow(dust.lacunarity, k) / dust.noiseScale;
    octave.amplitude = std::pow(dust.lacunarity, -dust.hurst * k);
    octave.shift = { random.uniform(), random.uniform(), random.uniform() };
    const auto bits = randomBits(key, RandomStream::FractalNoise, lattices + k, 0);
    octave.seed = static_cast<std::uint64_t>(bits[0]) << 32 | bits[1];
    squares += octave.amplitude * octave.amplitude;
    this->octaves.push_back(octave);
  }
  squares *= this->ridged ? varianceOfAbsolute : 1;
  for (Octave& octave : this->octaves)
  {
    octave.amplitude /= std::sqrt(squares);
  }
}

double FractalNoise::operator()(const Vec3& p) const
{
  double sum = 0;
  Vec3 q = p;
  for (const Octave& octave : this->octaves)
  {
    q = turned(q);
    const double n = valueNoise(octave.frequency * q + octave.shift, octave.seed);
    sum += octave.amplitude * (this->ridged ? meanOfAbsolute - std::abs(n) : n);
  }
  return sum;
}

double FractalNoise::meanExponential(double s) const
{
  double mean = 1;
  for (const Octave& octave : this->octaves)
  {
    const double t = s * octave.amplitude;
    mean *= std::exp(0.5 * t * t);
    mean *= this->ridged ? std::exp(t * meanOfAbsolute) * std::erfc(t / std::sqrt(2.0)) : 1;
  }
  return mean;
}

FractalClouds::FractalClouds(const DustDescription& dust, const RandomKey& key)
  : noise(dust, key)
  , contrast(dust.contrast)
  , scale(dust.noiseScale)
  , winding(dust.winding)
  , mean(this->noise.meanExponential(dust.contrast))
{
}

double FractalClouds::weight(double r, double cosTheta, double sinTheta, double z) const
{
  const auto [s, c] = sineCosine(this->winding * std::log1p(r / this->scale));
  const Vec3 p = { r * (cosTheta * c - sinTheta * s), r * (sinTheta * c + cosTheta * s), z };
  return std::exp(this->contrast * this->noise(p)) / this->mean;
}
} // namespace galaxy
