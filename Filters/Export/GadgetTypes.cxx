#include "Filters/Export/GadgetTypes.h"

#include "Filters/Model/ComponentKind.h"

#include <algorithm>

namespace galaxy
{
GadgetType gadgetTypeOf(const ComponentInfo& component)
{
  switch (kindOf(component))
  {
    case ComponentKind::Dust:
      return GadgetType::Boundary;
    case ComponentKind::AtomicGas:
    case ComponentKind::IonizedGas:
    case ComponentKind::MolecularGas:
      return GadgetType::Gas;
    case ComponentKind::Halo:
      return GadgetType::Halo;
    case ComponentKind::Bulge:
      return GadgetType::Bulge;
    case ComponentKind::YoungStars:
      return GadgetType::Stars;
    default:
      return GadgetType::Disk;
  }
}

TypeOrder::TypeOrder(const ParticleTable& table)
  : table(table)
  , chunkCounts((table.size + chunk - 1) / chunk)
{
  const std::size_t components = std::min(table.components.size(), this->typeOfComponent.size());
  for (std::size_t k = 0; k < components; ++k)
  {
    this->typeOfComponent[k] = static_cast<std::uint8_t>(gadgetTypeOf(table.components[k]));
  }
  for (std::size_t i = 0; i < table.size; ++i)
  {
    ++this->chunkCounts[i / chunk][this->typeOf(i)];
  }
  for (const auto& counts : this->chunkCounts)
  {
    for (int type = 0; type < gadgetTypes; ++type)
    {
      this->totals[type] += counts[type];
    }
  }
}

void TypeOrder::visit(int type, std::uint64_t first, std::uint64_t last, const Use& use) const
{
  std::vector<std::size_t> particles;
  std::uint64_t rank = 0; // of the next particle of this type
  for (std::size_t k = 0; k < this->chunkCounts.size() && rank < last; ++k)
  {
    const std::uint64_t next = rank + this->chunkCounts[k][type];
    if (next > std::max(rank, first))
    {
      particles.clear();
      const std::size_t end = std::min((k + 1) * chunk, this->table.size);
      for (std::size_t i = k * chunk; i < end; ++i)
      {
        if (this->typeOf(i) == type)
        {
          particles.push_back(i);
        }
      }
      const std::uint64_t from = std::max(first, rank) - rank;
      const std::uint64_t to = std::min(last, next) - rank;
      use(particles.data() + from, static_cast<std::size_t>(to - from));
    }
    rank = next;
  }
}
} // namespace galaxy
