#ifndef galaxy_TableCells_h
#define galaxy_TableCells_h

#include <string>
#include <vector>

namespace galaxy
{
// How the lines of tables are cut into cells.

/// What stands between cells: one of `,` `;` `|` `&`, a tab, or any number of blanks.
constexpr char blankSeparator = ' ';
constexpr char wideSeparator = 'W'; ///< two blanks or more, for names of several words

/// The cells between separators, without blanks at their ends and quotation marks around them;
/// where the separators are blanks, commas among them separate too, unless they are decimal.
std::vector<std::string> cellsOf(const std::string& line, char separator);

/// The same for names of columns: a unit in brackets belongs to the name before it.
std::vector<std::string> namesOf(const std::string& line, char separator);

/// The separator that all rows of numbers have.
char separatorOf(const std::vector<std::string>& rows);

/// True where most words of a line are numbers, whatever separates them.
bool isRowOfNumbers(const std::string& line);

/// A line that only draws: ----, | --- | --- |, ====.
bool isRule(const std::string& line);

/// What tables write where there is no value: nothing, --, nan, null, N/A, INDEF, ...
bool isMissing(const std::string& cell);

/// 10,5 as 10.5 in all cells, unless every such number could be one in thousands (1,200).
void readDecimalCommas(std::vector<std::vector<std::string>*>& rows);
} // namespace galaxy

#endif
