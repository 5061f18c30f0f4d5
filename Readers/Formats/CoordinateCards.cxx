#include "Readers/Formats/CoordinateCards.h"

#include "Readers/Formats/FitsHeader.h"
#include "Readers/Formats/HeaderCards.h"

#include <cmath>
#include <cstdlib>

namespace galaxy
{
namespace
{
constexpr std::size_t cardLength = FitsHeader::cardLength;

bool startsWith(const std::string& card, const char* start)
{
  return card.rfind(start, 0) == 0;
}

/// PV1_4 and the like.
bool isAxisParameter(const std::string& card)
{
  return startsWith(card, "PV") && card[3] == '_';
}

/// Every card as `change` returns it.
template <class Change>
std::string changedCards(const std::string& cards, const Change& change)
{
  std::string changed;
  for (std::size_t at = 0; at + cardLength <= cards.size(); at += cardLength)
  {
    changed += change(cards.substr(at, cardLength));
  }
  return changed;
}
} // namespace

std::string repairedCoordinateCards(const std::string& cards)
{
  const bool hasSip = !cardValue(cards, "A_ORDER").empty();
  const bool hasPolynomials =
    !cardValue(cards, "PV1_1").empty() && !cardValue(cards, "PV2_1").empty();
  std::string repaired = changedCards(cards, [&](std::string card) {
    if (startsWith(card, "CTYPE") || startsWith(card, "RADE"))
    {
      card = upperCase(card);
      const std::size_t tangent = card.find("-TAN'");
      if (hasPolynomials && !hasSip && tangent != std::string::npos)
      {
        card.replace(tangent, 5, "-TPV'");
      }
    }
    return hasSip && isAxisParameter(card) ? "" : card;
  });
  for (const char axis : { '1', '2' })
  {
    const std::string linear = std::string("PV") + axis + "_1";
    if (cardValue(repaired, std::string("CTYPE") + axis).find("-TPV") != std::string::npos &&
      cardValue(repaired, linear).empty())
    {
      std::string card = linear + "   = 1.0";
      card.resize(cardLength, ' ');
      repaired += card;
    }
  }
  return repaired;
}

bool epochIsPlateDate(const std::string& cards)
{
  const std::string epoch = cardValue(cards, "EPOCH");
  if (epoch.empty() || !cardValue(cards, "EQUINOX").empty() ||
    !cardValue(cards, "RADESYS").empty() || !cardValue(cards, "RADECSYS").empty())
  {
    return false;
  }
  const std::size_t digit = epoch.find_first_of("0123456789");
  const double year = digit == std::string::npos ? 0 : std::atof(epoch.c_str() + digit);
  return std::fmod(year, 25.0) != 0;
}

bool hasPlateSolutionBesideAxes(const std::string& cards)
{
  return !cardValue(cards, "AMDX1").empty() && !cardValue(cards, "CTYPE1").empty();
}

std::string withoutPlateSolution(const std::string& cards)
{
  return changedCards(cards, [](const std::string& card) -> std::string {
    for (const char* start : { "AMDX", "AMDY", "PLT", "PPO", "CNPIX", "XPIXELSZ", "YPIXELSZ" })
    {
      if (startsWith(card, start))
      {
        return "";
      }
    }
    return card;
  });
}
} // namespace galaxy
