#include "Readers/Formats/AxesCards.h"

#include "Readers/Formats/NoCoordinates.h"
#include "Readers/Formats/WatCorrection.h"

#include <cmath>

namespace galaxy
{
/// Distortions by records and tables (FITS paper IV, HST) are not read. HST says how far its tables
/// move a place, a tenth of a pixel.
void AxesCards::requireKnownDistortions() const
{
  constexpr double smallest = 1; // pixel
  for (const auto& [name, error] :
    { std::pair("CPDIS", "CPERR"), { "CQDIS", "CQERR" }, { "D2IMDIS", "D2IMERR" } })
  {
    for (int k = 0; k < 2; ++k)
    {
      const std::string keyword = name + this->named(k);
      const std::string type = this->header.text(keyword).value_or("");
      if (type.empty() || !std::isalpha(static_cast<unsigned char>(type[0])))
      {
        continue;
      }
      const std::string size = error + this->named(k);
      if (upperCase(type) != "LOOKUP")
      {
        throw NoCoordinates(
          this->file, keyword, "distortions of the kind '" + type + "' are not supported");
      }
      if (!(std::abs(this->header.number(size).value_or(2 * smallest)) <= smallest))
      {
        throw NoCoordinates(this->file, keyword,
          "a distortion table (LOOKUP) that moves places by more than a pixel, or says not by how "
          "much (" +
            size + "), is not supported; the drizzled image has none");
      }
    }
  }
}

bool AxesCards::hasSip() const
{
  return this->version.empty() && this->header.number("A_ORDER") && this->header.number("B_ORDER");
}

void AxesCards::writeSip()
{
  constexpr double highest = 9;
  for (int k = 0; k < 2; ++k)
  {
    const std::string root = k == 0 ? "A_" : "B_";
    const double order = this->header.number(root + "ORDER").value_or(0);
    if (!(order >= 0 && order <= highest && order == std::floor(order)))
    {
      throw NoCoordinates(this->file, root + "ORDER", "must be a whole number from 0 to 9");
    }
    for (int p = 0; p <= order; ++p)
    {
      for (int q = 0; p + q <= order; ++q)
      {
        this->copy(indexedKeyword(root, p, q), indexedKeyword(root, p, q));
      }
    }
  }
}

void AxesCards::writeWat()
{
  std::array<WatCorrection, 2> corrections;
  for (int k = 0; k < 2; ++k)
  {
    corrections[static_cast<std::size_t>(k)] =
      watCorrectionOf(this->file, this->header, this->axes[static_cast<std::size_t>(k)]);
  }
  // Both axes repeat the projection's parameters.
  this->parameters[static_cast<std::size_t>(1 - this->longitude)] =
    corrections[static_cast<std::size_t>(1 - this->longitude)].parameters;
  if (corrections[0].polynomial.empty() && corrections[1].polynomial.empty())
  {
    return;
  }
  if (this->longitude != 0)
  {
    // IRAF's polynomials are of longitude and latitude, WCSLIB's of the first axis and the second.
    throw NoCoordinates(this->file, "CTYPE" + this->named(0),
      "the projection " + this->projection + " must have its longitude first");
  }
  for (int k = 0; k < 2; ++k)
  {
    const std::string& polynomial = corrections[static_cast<std::size_t>(k)].polynomial;
    const std::string text = std::string("wtype=") + (this->projection == "TNX" ? "tnx" : "zpx") +
      " cor = \"" + (polynomial.empty() ? noCorrection() : polynomial) + "\"";
    constexpr std::size_t length = 68;
    for (std::size_t at = 0, card = 1; at < text.size(); at += length, ++card)
    {
      this->out.text("WAT" + std::to_string(k + 1) + "_" + std::to_string(1000 + card).substr(1),
        text.substr(at, length));
    }
  }
}

void AxesCards::writeParameters()
{
  if (this->projection == "TAN" && this->hasSip())
  {
    return;
  }
  const int count = this->projection == "TPV" ? 40 : 30;
  for (int k = 0; k < 2; ++k)
  {
    std::map<int, double>& own = this->parameters[static_cast<std::size_t>(k)];
    if (this->projection == "TPV")
    {
      own[1] = 1; // where it is absent
    }
    for (int m = 0; m < count; ++m)
    {
      std::optional<double> value = this->numberOf(this->parameter(k, m));
      if (!value && k != this->longitude && this->version.empty() && m < 10)
      {
        value = this->header.number(fitsKeyword("PROJP", m)); // before PVi_m was settled on
      }
      if (value)
      {
        own[m] = *value;
      }
    }
    for (const auto& [m, value] : own)
    {
      this->out.number(indexedKeyword("PV", k + 1, m), value);
    }
  }
}
} // namespace galaxy
