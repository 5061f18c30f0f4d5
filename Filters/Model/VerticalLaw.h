#ifndef galaxy_VerticalLaw_h
#define galaxy_VerticalLaw_h

#include "Readers/Formats/RingTable.h"

#include <array>

namespace galaxy
{
// Layers over a disc's plane for scale height 1, after TiRiFiC's layer types: the densities
// exp(-z^2/2), sech^2(z), exp(-|z|), 1/(1 + z^2) cut off at |z| = 10 (its variance would be
// infinite), and a box |z| < 1.

/// The share of the layer between -z and z, for z >= 0.
double shareWithin(LayerLaw law, double z);

/// How many numbers the functions below turn at once.
constexpr int deviatesAtOnce = 128;
using Deviates = std::array<double, deviatesAtOnce>;

/// Replaces every share x, |x| <= 1 - 2^-32, by the height z of its sign with shareWithin(|z|) =
/// |x|, to 2e-9 of z: uniform shares between -1 and 1 become heights of the layer.
void sharesToHeights(LayerLaw law, Deviates& shares);

/// Root mean square of the heights.
double rmsHeight(LayerLaw law);

/// Full width at half maximum of the densities.
double fwhmHeight(LayerLaw law);
} // namespace galaxy

#endif
