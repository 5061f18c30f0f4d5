#ifndef galaxy_HoleFilling_h
#define galaxy_HoleFilling_h

#include <cstdint>
#include <vector>

namespace galaxy
{
/// Replaces the masked pixels by a smooth continuation of those about them: a solution of Laplace's
/// equation with the unmasked pixels as boundary, which continues a gradient as it is. It starts
/// from the same on an image of half the size, and is then relaxed; blank pixels (NaN) take no part
/// and stay blank where unmasked. A mask without any finite pixel about it becomes blank.
void fillHoles(
  int width, int height, const std::vector<std::uint8_t>& mask, std::vector<float>& values);
} // namespace galaxy

#endif
