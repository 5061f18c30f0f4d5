#include "Readers/Formats/PlateCards.h"

#include "Readers/Formats/CardWriter.h"

#include <optional>

namespace galaxy
{
std::string plateCards(const FitsHeader& header)
{
  const std::string sign = header.text("PLTDECSN").value_or("");
  if (sign != "+" && sign != "-")
  {
    return "";
  }
  CardWriter out;
  // WCSLIB has room for 7 characters of its name, among the coefficients.
  out.text("PLATEID", "plate");
  out.number("NAXIS", 2);
  // It knows a minus by the blank behind it.
  out.text("PLTDECSN", sign + " ");
  for (const char* keyword : { "PLTRAH", "PLTRAM", "PLTRAS", "PLTDECD", "PLTDECM", "PLTDECS",
         "CNPIX1", "CNPIX2", "XPIXELSZ", "YPIXELSZ", "PPO3", "PPO6" })
  {
    const std::optional<double> number = header.number(keyword);
    if (!number)
    {
      return "";
    }
    out.number(keyword, *number);
  }
  constexpr int coefficients = 20;
  constexpr int linear = 3, known = 13; // those that must be, and those that WCSLIB knows
  for (const char* root : { "AMDX", "AMDY" })
  {
    for (int m = 1; m <= coefficients; ++m)
    {
      const std::string keyword = fitsKeyword(root, static_cast<std::size_t>(m));
      const std::optional<double> number = header.number(keyword);
      const bool isBad = number ? m > known && *number != 0 : m <= linear || header.text(keyword);
      if (isBad)
      {
        return "";
      }
      if (number && m <= known)
      {
        out.number(keyword, *number);
      }
    }
  }
  return out.cards();
}
} // namespace galaxy
