#include "Readers/Formats/AxesCards.h"

#include "Readers/Formats/NoCoordinates.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// A text that WCSLIB can take: printable, and short enough for a card.
std::string plainText(const FitsHeader& header, const std::string& keyword)
{
  constexpr std::size_t longest = 68;
  std::string text = header.text(keyword).value_or("");
  const bool isPlain =
    std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~' && c != '\''; });
  return isPlain && text.size() <= longest ? text : "";
}

/// The matrix that the header has, PC before CD.
class Matrix
{
public:
  Matrix(const FitsHeader& header, const std::array<int, 2>& axes, std::string version)
    : header(header)
    , version(std::move(version))
  {
    bool hasPc = false;
    for (const int row : axes)
    {
      for (int column = 1; column <= mostAxes; ++column)
      {
        hasPc |= this->element("PC", row, column).has_value();
        this->isCd |= this->element("CD", row, column).has_value();
      }
    }
    this->isCd &= !hasPc;
  }

  double at(int row, int column) const
  {
    return this->element(this->isCd ? "CD" : "PC", row, column)
      .value_or(!this->isCd && row == column ? 1 : 0);
  }

  static constexpr int mostAxes = 99;

private:
  std::optional<double> element(const char* root, int row, int column) const
  {
    return this->header.number(indexedKeyword(root, row, column) + this->version);
  }

  const FitsHeader& header;
  const std::string version;
  bool isCd = false;
};

} // namespace

std::string indexedKeyword(const std::string& root, int i, int j)
{
  return root + std::to_string(i) + "_" + std::to_string(j);
}

AxesCards::AxesCards(const std::string& file, const FitsHeader& header,
  const std::array<int, 2>& axes, const std::string& version)
  : file(file)
  , header(header)
  , axes(axes)
  , version(version)
{
}

std::string AxesCards::write()
{
  this->writeTypes();
  this->writeLinearPart();
  for (const char* pole : { "LONPOLE", "LATPOLE" })
  {
    this->copy(pole + this->version, pole);
  }
  this->requireKnownDistortions();
  if (this->hasSip())
  {
    this->writeSip();
  }
  if (this->projection == "TNX" || this->projection == "ZPX")
  {
    this->writeWat();
  }
  this->writeParameters();
  return this->out.cards();
}

std::string AxesCards::named(int k) const
{
  return std::to_string(this->axes[static_cast<std::size_t>(k)]) + this->version;
}

std::string AxesCards::parameter(int k, int m) const
{
  return indexedKeyword("PV", this->axes[static_cast<std::size_t>(k)], m) + this->version;
}

std::optional<double> AxesCards::numberOf(const std::string& keyword) const
{
  const std::optional<std::string> text = this->header.text(keyword);
  const std::optional<double> number = this->header.number(keyword);
  if (text && !text->empty() && !number)
  {
    throw NoCoordinates(this->file, keyword, "'" + *text + "' is not a number");
  }
  return number;
}

void AxesCards::copy(const std::string& from, const std::string& to)
{
  if (const std::optional<double> number = this->numberOf(from))
  {
    this->out.number(to, *number);
  }
}

void AxesCards::writeTypes()
{
  this->out.number("NAXIS", 2);
  std::array<std::string, 2> types = { upperCase(plainText(this->header, "CTYPE" + this->named(0))),
    upperCase(plainText(this->header, "CTYPE" + this->named(1))) };
  this->longitude =
    types[1].rfind("RA", 0) == 0 || types[1].find("LON") == 1 || types[1].find("LN") == 2 ? 1 : 0;
  this->projection = types[0].size() >= 8 ? types[0].substr(5, 3) : "";
  if (this->projection == "TAB")
  {
    throw NoCoordinates(
      this->file, "CTYPE" + this->named(0), "tabulated coordinates (-TAB) are not supported");
  }
  const std::string known = this->knownProjection();
  for (int k = 0; k < 2; ++k)
  {
    std::string& type = types[static_cast<std::size_t>(k)];
    // Behind the projection stands the name of a distortion, which its own keywords describe.
    if (type.size() >= 8 && type.substr(5, 3) == this->projection)
    {
      type = type.substr(0, 5) + known;
    }
    this->out.text(fitsKeyword("CTYPE", k + 1), type);
    const std::string unit = plainText(this->header, "CUNIT" + this->named(k));
    if (!unit.empty())
    {
      this->out.text(fitsKeyword("CUNIT", k + 1), unit);
    }
  }
  this->projection = known;
}

std::string AxesCards::knownProjection() const
{
  const bool isTangent = this->projection == "TAN" || this->projection == "TPV";
  if (isTangent && this->hasSip())
  {
    return "TAN";
  }
  const bool hasPolynomials =
    this->header.number(this->parameter(0, 1)) && this->header.number(this->parameter(1, 1));
  return isTangent && hasPolynomials ? "TPV" : this->projection;
}

void AxesCards::writeLinearPart()
{
  const Matrix matrix(this->header, this->axes, this->version);
  const int x = this->axes[0], y = this->axes[1];
  // The further axes stand at their first pixel.
  double shiftX = 0, shiftY = 0;
  for (int other = 1; other <= Matrix::mostAxes; ++other)
  {
    const double addsX = matrix.at(x, other), addsY = matrix.at(y, other);
    if (other != x && other != y && (addsX != 0 || addsY != 0))
    {
      const double step =
        1 - this->numberOf(fitsKeyword("CRPIX", other) + this->version).value_or(0);
      shiftX += addsX * step;
      shiftY += addsY * step;
    }
  }
  std::array<double, 2> shift = { 0, 0 };
  const double determinant = matrix.at(x, x) * matrix.at(y, y) - matrix.at(x, y) * matrix.at(y, x);
  if (determinant != 0)
  {
    shift[0] = (matrix.at(y, y) * shiftX - matrix.at(x, y) * shiftY) / determinant;
    shift[1] = (matrix.at(x, x) * shiftY - matrix.at(y, x) * shiftX) / determinant;
  }
  for (int k = 0; k < 2; ++k)
  {
    const int axis = k + 1;
    this->out.number(fitsKeyword("CRPIX", axis),
      this->numberOf("CRPIX" + this->named(k)).value_or(0) - shift[static_cast<std::size_t>(k)]);
    for (const char* root : { "CRVAL", "CDELT", "CROTA" })
    {
      this->copy(root + this->named(k), fitsKeyword(root, axis));
    }
    for (int j = 0; j < 2; ++j)
    {
      for (const char* root : { "PC", "CD" })
      {
        const std::string name = indexedKeyword(
          root, this->axes[static_cast<std::size_t>(k)], this->axes[static_cast<std::size_t>(j)]);
        this->copy(name + this->version, indexedKeyword(root, axis, j + 1));
      }
    }
  }
}

} // namespace galaxy
