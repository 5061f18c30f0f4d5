#include "Readers/Formats/HistoryBeam.h"

#include "Readers/Formats/FitsHeader.h"

#include <algorithm>

namespace galaxy
{
namespace
{
constexpr double arcsecPerDegree = 3600;

/// The number that the text behind `at` begins with.
std::optional<double> numberAt(const std::string& text, std::size_t at)
{
  at = text.find_first_not_of(' ', at);
  if (at == std::string::npos)
  {
    return std::nullopt;
  }
  const std::size_t end = std::min(text.find_first_of(" ,;()'/", at), text.size());
  return fitsNumber(text.substr(at, end - at));
}

/// The number behind "NAME=" or "NAME =".
std::optional<double> numberBehind(const std::string& text, const std::string& name)
{
  const std::size_t at = text.find(name);
  const std::size_t sign =
    at == std::string::npos ? at : text.find_first_not_of(' ', at + name.size());
  const bool isGiven = sign != std::string::npos && text[sign] == '=';
  return isGiven ? numberAt(text, sign + 1) : std::nullopt;
}

std::optional<Beam> checked(double major, double minor, double positionAngle)
{
  return major > 0 && minor > 0
    ? std::optional<Beam>(Beam{ std::max(major, minor), std::min(major, minor), positionAngle })
    : std::nullopt;
}

std::optional<Beam> beamOfAips(const std::string& line)
{
  const auto major = numberBehind(line, "BMAJ"), minor = numberBehind(line, "BMIN");
  const double unit = upperCase(line).find("ARCSEC") == std::string::npos ? arcsecPerDegree : 1;
  return checked(unit * major.value_or(0), unit * minor.value_or(major.value_or(0)),
    numberBehind(line, "BPA").value_or(0));
}

std::optional<Beam> beamOfCasa(const std::string& line)
{
  const std::string start = "restoration:";
  const std::size_t at = line.find(start), by = line.find(" by ", at);
  if (at == std::string::npos || by == std::string::npos ||
    line.find("(arcsec)", by) == std::string::npos)
  {
    return std::nullopt;
  }
  const std::string angle = "at pa ";
  const std::size_t pa = line.find(angle, by);
  return checked(numberAt(line, at + start.size()).value_or(0), numberAt(line, by + 4).value_or(0),
    pa == std::string::npos ? 0 : numberAt(line, pa + angle.size()).value_or(0));
}
} // namespace

std::optional<Beam> beamOfHistory(const std::string& cards)
{
  constexpr std::size_t length = FitsHeader::cardLength;
  std::optional<Beam> restored, other;
  for (std::size_t at = 0; at + length <= cards.size(); at += length)
  {
    const std::string line = cards.substr(at, length);
    if (line.rfind("HISTORY", 0) != 0)
    {
      continue;
    }
    const std::optional<Beam> aips = beamOfAips(line), casa = beamOfCasa(line);
    if (aips && line.find("CLEAN") != std::string::npos)
    {
      restored = aips;
    }
    else if (aips || casa)
    {
      other = aips ? aips : casa;
    }
  }
  return restored ? restored : other;
}
} // namespace galaxy
