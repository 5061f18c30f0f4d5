#include "Filters/Export/GadgetTypes.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace galaxy
{
namespace
{
std::vector<std::string> wordsOf(const std::string& text)
{
  std::vector<std::string> words(1);
  for (const unsigned char letter : text)
  {
    if (std::isalnum(letter))
    {
      words.back() += static_cast<char>(std::tolower(letter));
    }
    else if (!words.back().empty())
    {
      words.emplace_back();
    }
  }
  return words;
}
} // namespace

GadgetType gadgetTypeOf(const ComponentInfo& component)
{
  if (component.absorbs)
  {
    return GadgetType::Boundary;
  }
  static const std::vector<std::pair<GadgetType, std::vector<std::string>>> kinds = {
    { GadgetType::Gas, { "gas", "ism", "hi", "hii", "h", "h2", "co", "hydrogen", "halpha" } },
    { GadgetType::Halo, { "halo", "dark" } },
    { GadgetType::Bulge, { "bulge", "spheroid", "elliptical" } },
    { GadgetType::Stars, { "young", "newborn" } },
  };
  const std::vector<std::string> words = wordsOf(component.name);
  for (const auto& [type, keywords] : kinds)
  {
    if (std::find_first_of(words.begin(), words.end(), keywords.begin(), keywords.end()) !=
      words.end())
    {
      return type;
    }
  }
  return GadgetType::Disk;
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
