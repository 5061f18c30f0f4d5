#include "Readers/Formats/WidthTable.h"

#include "Readers/Formats/NumberTable.h"

namespace galaxy
{
std::vector<WidthAtRadius> readWidthTable(const std::string& file)
{
  return parseWidthTable(readText(file), file);
}

std::vector<WidthAtRadius> parseWidthTable(const std::string& text, const std::string& file)
{
  const NumberTable table(text, file,
    { { "radius", Measure::Kpc, { "r", "rad", "radii" } },
      { "fwhm", Measure::Kpc, { "full_width", "width", "w" } } },
    { "radius", "fwhm" });
  std::vector<WidthAtRadius> rows;
  for (std::size_t k = 0; k < table.size(); ++k)
  {
    rows.push_back({ table.number(k, "radius", Range::notNegative()),
      table.number(k, "fwhm", Range::notNegative()) });
    if (k > 0 && !(rows[k].radius > rows[k - 1].radius))
    {
      table.fail(k, "the radius must be greater than in the row before");
    }
  }
  return rows;
}
} // namespace galaxy
