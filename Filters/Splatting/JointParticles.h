#ifndef galaxy_JointParticles_h
#define galaxy_JointParticles_h

#include "Filters/Splatting/ParticleArrays.h"

#include <cstddef>
#include <vector>

namespace galaxy
{
/// Several sets of particles as one, so that they hide and dim one another in true depth order.
class JointParticles
{
public:
  /// Copies the particles. Throws Error if they have more than 256 components together.
  explicit JointParticles(const std::vector<ParticleView>& parts);

  /// All of them, with the component tables that the same parts have by now.
  ParticleView view(const std::vector<ParticleView>& parts);

  /// Whether the components' colours become part of the copies, as they do where a part has
  /// `emission` or `absorption`: the others' Intensity and Color are then made the same.
  static bool keepsColors(const std::vector<ParticleView>& parts);

private:
  void add(const ParticleView& part, std::size_t at, std::size_t first);
  void addLight(const ParticleView& part, std::size_t at);

  ParticleArrays arrays;
  std::vector<ComponentInfo> components;
  std::vector<bool> visible;
};
} // namespace galaxy

#endif
