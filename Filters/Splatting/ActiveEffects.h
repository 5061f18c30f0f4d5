#ifndef galaxy_ActiveEffects_h
#define galaxy_ActiveEffects_h

#include "Filters/Splatting/Projection.h"

#include <string>

namespace galaxy
{
/// Tiles with absorbers, by what their order needs.
struct OrderNeeds
{
  std::size_t ordered = 0;
  std::size_t oneSource = 0; ///< all splats emit in proportion to what they absorb: no order
  std::size_t thin = 0;      ///< too thin for their order to matter, within what is allowed
  OrderNeeds& operator+=(const OrderNeeds& other);
};

/// What a scene called for, in words: "emission; grey absorption; depth order among ...".
std::string activeEffects(const ProjectionCounts& counts, const OrderNeeds& tiles);

/// 950, 12 k, 1.2 M.
std::string shortCount(std::size_t count);
} // namespace galaxy

#endif
