#ifndef galaxy_VerticalLaw_h
#define galaxy_VerticalLaw_h

#include "Filters/Model/Random.h"
#include "Readers/Formats/RingTable.h"

namespace galaxy
{
/// Heights over a disc's plane for scale height 1, after TiRiFiC's layer types: the densities
/// exp(-z^2/2), sech^2(z), exp(-|z|), 1/(1 + z^2) cut off at |z| = 10 (its variance would be
/// infinite), and a box |z| < 1.
double sampleHeight(LayerLaw law, Random& random);

/// Root mean square of those heights.
double rmsHeight(LayerLaw law);

/// Full width at half maximum of those densities.
double fwhmHeight(LayerLaw law);
} // namespace galaxy

#endif
