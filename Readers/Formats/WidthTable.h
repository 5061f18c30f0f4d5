#ifndef galaxy_WidthTable_h
#define galaxy_WidthTable_h

#include "Readers/Formats/GalaxyDescription.h"

#include <string>
#include <vector>

namespace galaxy
{
/// Reads a disc's full width at half maximum by radius, both kpc: two columns, separated by blanks
/// or commas, under one line of heading or none; what follows a # is left out. Throws Error naming
/// the line where a number is missing or negative or a radius does not increase.
std::vector<WidthAtRadius> readWidthTable(const std::string& file);
/// The same from text already in memory; `file` only names it in messages.
std::vector<WidthAtRadius> parseWidthTable(const std::string& text, const std::string& file);
} // namespace galaxy

#endif
