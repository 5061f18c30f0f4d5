#ifndef galaxy_GadgetTypes_h
#define galaxy_GadgetTypes_h

#include "Filters/Export/ParticleTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace galaxy
{
/// The six particle types of Gadget, by the names that its users know.
enum class GadgetType
{
  Gas,
  Halo,
  Disk,
  Bulge,
  Stars,
  Boundary
};
constexpr int gadgetTypes = 6;

/// The type of a component: Boundary for every absorber, and for no emitter; of emitters the first
/// of Gas (a word of the name is gas, ism, hi, hii, h, h2, co, hydrogen or halpha), Halo (halo,
/// dark), Bulge (bulge, spheroid, elliptical), Stars (young, newborn) that fits, else Disk. Words
/// are compared without case.
GadgetType gadgetTypeOf(const ComponentInfo& component);

/// The particles in the order of their types, those of one type in their own order, without a
/// table of the permutation: a few bytes for every 65536 particles.
class TypeOrder
{
public:
  /// `table` must outlive the order; its component indices must lie within its components.
  explicit TypeOrder(const ParticleTable& table);

  const std::array<std::uint64_t, gadgetTypes>& counts() const { return this->totals; }

  /// Calls `use` with the indices of at most `chunk` particles at a time: those of `type` from the
  /// first-th on until before the last-th.
  using Use = std::function<void(const std::size_t* particles, std::size_t count)>;
  void visit(int type, std::uint64_t first, std::uint64_t last, const Use& use) const;

  static constexpr std::size_t chunk = 65536;

private:
  int typeOf(std::size_t particle) const
  {
    return this->typeOfComponent[this->table.componentOf(particle)];
  }

  const ParticleTable& table;
  std::array<std::uint8_t, 256> typeOfComponent{};
  std::vector<std::array<std::uint32_t, gadgetTypes>> chunkCounts;
  std::array<std::uint64_t, gadgetTypes> totals{};
};
} // namespace galaxy

#endif
