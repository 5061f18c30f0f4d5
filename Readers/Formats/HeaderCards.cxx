#include "Readers/Formats/HeaderCards.h"

#include "Readers/Formats/RingText.h"

namespace galaxy
{
std::optional<double> cardNumber(const std::string& cards, const std::string& keyword)
{
  constexpr std::size_t cardLength = 80;
  const std::string start = (keyword + "        ").substr(0, 8) + "=";
  for (std::size_t at = 0; at + cardLength <= cards.size(); at += cardLength)
  {
    if (cards.compare(at, start.size(), start) != 0)
    {
      continue;
    }
    std::string value = cards.substr(at + start.size(), cardLength - start.size());
    value = value.substr(0, value.find('/'));
    const std::vector<std::string> cells = splitCells(value);
    double number;
    return cells.size() == 1 && parseNumber(cells[0], number) ? std::optional<double>(number)
                                                              : std::nullopt;
  }
  return std::nullopt;
}
} // namespace galaxy
