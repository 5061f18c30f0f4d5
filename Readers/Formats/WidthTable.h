#ifndef galaxy_WidthTable_h
#define galaxy_WidthTable_h

#include "Readers/Formats/GalaxyDescription.h"

#include <string>
#include <vector>

namespace galaxy
{
/// Reads a disc's full width at half maximum by radius, in kpc or the units that the heading tells:
/// two columns without a heading, or those that it calls radius and fwhm. Throws Error naming the
/// line where a number is missing or negative or a radius does not increase.
std::vector<WidthAtRadius> readWidthTable(const std::string& file);
/// The same from text already in memory; `file` only names it in messages.
std::vector<WidthAtRadius> parseWidthTable(const std::string& text, const std::string& file);
} // namespace galaxy

#endif
