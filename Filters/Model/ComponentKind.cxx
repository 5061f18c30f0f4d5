#include "Filters/Model/ComponentKind.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

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

ComponentKind kindOf(const ComponentInfo& component)
{
  if (component.absorbs)
  {
    return ComponentKind::Dust;
  }
  // In this order: "molecular gas" is not any gas.
  static const std::vector<std::pair<ComponentKind, std::vector<std::string>>> kinds = {
    { ComponentKind::IonizedGas, { "hii", "halpha", "ionized", "ionised" } },
    { ComponentKind::MolecularGas, { "h2", "co", "molecular" } },
    { ComponentKind::AtomicGas, { "gas", "ism", "hi", "h", "hydrogen", "atomic" } },
    { ComponentKind::Halo, { "halo", "dark" } },
    { ComponentKind::Bulge, { "bulge", "spheroid", "elliptical" } },
    { ComponentKind::YoungStars, { "young", "newborn" } },
  };
  const std::vector<std::string> words = wordsOf(component.name);
  for (const auto& [kind, keywords] : kinds)
  {
    if (std::find_first_of(words.begin(), words.end(), keywords.begin(), keywords.end()) !=
      words.end())
    {
      return kind;
    }
  }
  return ComponentKind::Stars;
}
} // namespace galaxy
