#ifndef galaxy_ComponentLimit_h
#define galaxy_ComponentLimit_h

#include <cstddef>

namespace galaxy
{
/// A particle keeps its component's index in a byte.
constexpr std::size_t mostComponents = 256;
} // namespace galaxy

#endif
