#ifndef galaxy_Knobs_h
#define galaxy_Knobs_h

// What drawing is built with. Testing/Benchmarks/accuracy_cost.py --builds builds others, to tell
// what each of these costs and gains.

#ifndef GALAXY_TILE_SIDE
#define GALAXY_TILE_SIDE 32
#endif
#ifndef GALAXY_DEPTH_BITS
#define GALAXY_DEPTH_BITS 32
#endif
#ifndef GALAXY_KERNEL_CUT
#define GALAXY_KERNEL_CUT 1
#endif
#ifndef GALAXY_SUM
#define GALAXY_SUM double
#endif

namespace galaxy
{
/// Pixels of a tile along each side, 16, 32 or 64: with 32, its float sums stay in the first cache
/// of a core.
constexpr int tileSide = GALAXY_TILE_SIDE;
/// Of Splat::depth, up to 32.
constexpr int depthBits = GALAXY_DEPTH_BITS;
/// Smoothing lengths from the centre, along each axis, where a footprint is cut off; less than 1
/// loses the light beyond.
constexpr float kernelCut = GALAXY_KERNEL_CUT;
/// What spans are added up in, see TileSums.
using SpanSum = GALAXY_SUM;
} // namespace galaxy

#endif
