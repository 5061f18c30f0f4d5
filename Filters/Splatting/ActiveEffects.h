#ifndef galaxy_ActiveEffects_h
#define galaxy_ActiveEffects_h

#include "Filters/Splatting/Projection.h"

#include <string>

namespace galaxy
{
/// What a scene called for, in words: "emission; grey absorption; depth order among ...".
std::string activeEffects(const ProjectionCounts& counts);

/// 950, 12 k, 1.2 M.
std::string shortCount(std::size_t count);
} // namespace galaxy

#endif
