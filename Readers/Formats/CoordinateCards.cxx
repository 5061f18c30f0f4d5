#include "Readers/Formats/CoordinateCards.h"

#include "Readers/Formats/AxesCards.h"
#include "Readers/Formats/PlateCards.h"

namespace galaxy
{
namespace
{
/// Of a keyword that stands twice the last counts, as in WCSLIB and astropy.
FitsHeader lastFirst(const std::string& cards)
{
  constexpr std::size_t length = FitsHeader::cardLength;
  FitsHeader header;
  for (std::size_t end = cards.size() / length; end > 0; --end)
  {
    header.add(cards.substr((end - 1) * length, length));
  }
  return header;
}

} // namespace

CoordinateCards::CoordinateCards(
  const std::string& file, const std::string& cards, const std::array<int, 2>& axes)
  : all(lastFirst(cards))
  , file(file)
  , axes(axes)
{
  for (char letter = 'A' - 1; letter <= 'Z'; ++letter)
  {
    const std::string version = letter < 'A' ? "" : std::string(1, letter);
    const auto hasType = [&](int axis) {
      return !this->all.text(fitsKeyword("CTYPE", axis) + version).value_or("").empty();
    };
    if (hasType(axes[0]) && hasType(axes[1]))
    {
      this->described.push_back(version);
    }
  }
}

std::string CoordinateCards::axesOf(const std::string& version) const
{
  return AxesCards(this->file, this->all, this->axes, version).write();
}

std::string CoordinateCards::types() const
{
  const std::string x = this->all.text(fitsKeyword("CTYPE", this->axes[0])).value_or("");
  const std::string y = this->all.text(fitsKeyword("CTYPE", this->axes[1])).value_or("");
  return x.empty() && y.empty() ? "" : " (" + x + ", " + y + ")";
}

std::string CoordinateCards::plate() const
{
  return this->axes == std::array<int, 2>{ 1, 2 } ? plateCards(this->all) : "";
}
} // namespace galaxy
