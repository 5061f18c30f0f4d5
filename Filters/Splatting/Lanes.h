#ifndef galaxy_Lanes_h
#define galaxy_Lanes_h

#include <cstdint>
#include <cstring>

/// A function compiled anew for each instruction set of the GALAXY_CLONES function that calls it.
#define GALAXY_INLINE inline __attribute__((always_inline))

/// Compiles a function for several instruction sets; the loader takes the best the machine has.
#define GALAXY_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))

namespace galaxy
{
/// Sixteen floats that every arithmetic operator treats alike.
constexpr int laneCount = 16;
using Lanes = float __attribute__((vector_size(4 * laneCount)));
using IntLanes = std::int32_t __attribute__((vector_size(4 * laneCount)));

GALAXY_INLINE Lanes loadLanes(const float* from)
{
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

GALAXY_INLINE void storeLanes(float* to, Lanes lanes)
{
  std::memcpy(to, &lanes, sizeof(lanes));
}

/// 0, 1, 2, ...
GALAXY_INLINE Lanes laneNumbers()
{
  return Lanes{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15 };
}

/// The lanes r g b r g b ... from the first three lanes, beginning with channel `first`; the
/// sixteen lanes that follow sixteen others begin one channel later.
GALAXY_INLINE Lanes channelPattern(Lanes rgb, int first)
{
  const IntLanes zero = { 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0 };
  const IntLanes one = { 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1 };
  const IntLanes two = { 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2 };
  return __builtin_shuffle(rgb, first == 0 ? zero : first == 1 ? one : two);
}

/// Each lane three times: lanes 0 to 15 become 48 floats.
GALAXY_INLINE void storeThrice(float* to, Lanes lanes)
{
  const IntLanes low = { 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5 };
  const IntLanes middle = { 5, 5, 6, 6, 6, 7, 7, 7, 8, 8, 8, 9, 9, 9, 10, 10 };
  const IntLanes high = { 10, 11, 11, 11, 12, 12, 12, 13, 13, 13, 14, 14, 14, 15, 15, 15 };
  storeLanes(to, __builtin_shuffle(lanes, low));
  storeLanes(to + laneCount, __builtin_shuffle(lanes, middle));
  storeLanes(to + 2 * laneCount, __builtin_shuffle(lanes, high));
}

GALAXY_INLINE Lanes maximum(Lanes a, Lanes b)
{
  return a > b ? a : b;
}

GALAXY_INLINE Lanes minimum(Lanes a, Lanes b)
{
  return a < b ? a : b;
}

/// e^-x for 0 <= x; relative error below 2e-7 up to 87, where it stays.
GALAXY_INLINE Lanes decay(Lanes x)
{
  const Lanes y = minimum(x, Lanes{} + 87.0f) * -1.44269504f;
  // Adding 1.5 2^23 leaves the nearest integer in the low bits of the mantissa.
  const Lanes shifted = y + 12582912.0f;
  const Lanes whole = shifted - 12582912.0f;
  // ln 2 in two parts: x - n ln 2 without losing the digits that the product y has lost.
  const Lanes r = -minimum(x, Lanes{} + 87.0f) - whole * 0.693359375f + whole * 2.12194440e-4f;
  Lanes sum = Lanes{} + 1.0f / 720;
  sum = sum * r + 1.0f / 120;
  sum = sum * r + 1.0f / 24;
  sum = sum * r + 1.0f / 6;
  sum = sum * r + 0.5f;
  sum = sum * r + 1.0f;
  sum = sum * r + 1.0f;
  const IntLanes exponent = (IntLanes(shifted) - 0x4B400000) << 23;
  const IntLanes bits = IntLanes(sum) + exponent;
  return Lanes(bits);
}

/// Through a slab of optical depth t: the light kept is (base + change) times what came.
struct SlabLanes
{
  Lanes escape; ///< phi(t)
  Lanes base;   ///< 1 where t is small, so that 1 - t phi(t) can be added up in double; else 0
  Lanes change; ///< -t phi(t) where t is small, else e^-t
};

/// phi(t) by its Taylor series below 1/2 and by definition above: 2e-7 everywhere (physics: the
/// two agree to rounding where they meet, which (1 - e^-t) / t alone does not near 0).
GALAXY_INLINE SlabLanes slabLanes(Lanes t)
{
  Lanes series = Lanes{} + 1.0f / 362880;
  series = series * -t + 1.0f / 40320;
  series = series * -t + 1.0f / 5040;
  series = series * -t + 1.0f / 720;
  series = series * -t + 1.0f / 120;
  series = series * -t + 1.0f / 24;
  series = series * -t + 1.0f / 6;
  series = series * -t + 0.5f;
  series = series * -t + 1.0f;
  const IntLanes thin = t < 0.5f;
  const Lanes kept = decay(t);
  const Lanes one = Lanes{} + 1.0f;
  SlabLanes slab;
  slab.escape = thin ? series : (one - kept) / (thin ? one : t);
  slab.base = thin ? one : Lanes{};
  slab.change = thin ? -t * series : kept;
  return slab;
}
} // namespace galaxy

#endif
