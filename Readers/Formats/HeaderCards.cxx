#include "Readers/Formats/HeaderCards.h"

#include "Readers/Formats/FitsHeader.h"

namespace galaxy
{
namespace
{
/// The first card with this keyword and a value; empty where there is none.
std::string cardOf(const std::string& cards, const std::string& keyword)
{
  constexpr std::size_t cardLength = FitsHeader::cardLength;
  const std::string start = (keyword + "        ").substr(0, 8) + "=";
  for (std::size_t at = 0; at + cardLength <= cards.size(); at += cardLength)
  {
    if (cards.compare(at, start.size(), start) == 0)
    {
      return cards.substr(at, cardLength);
    }
  }
  return "";
}
}

std::string cardValue(const std::string& cards, const std::string& keyword)
{
  const std::string card = cardOf(cards, keyword);
  return card.empty() ? card : card.substr(9);
}

std::optional<double> cardNumber(const std::string& cards, const std::string& keyword)
{
  FitsHeader header;
  header.add(cardOf(cards, keyword));
  return header.number(keyword);
}
}
