#ifndef galaxy_TextFile_h
#define galaxy_TextFile_h

#include <string>
#include <vector>

namespace galaxy
{
/// The content of a text file, as plainText makes it. Throws Error where it is no regular file,
/// cannot be read, or is larger than mostTextBytes.
std::string readText(const std::string& file);

/// No table, region list or description is larger.
constexpr std::size_t mostTextBytes = std::size_t(32) << 20;

/// The bytes of a text as UTF-8 without a byte-order mark, each line ending with \n alone, be they
/// from Unix, DOS or an old Macintosh. Throws Error, naming `file`, where they are no text of bytes
/// but UTF-16, compressed, or of another format. Of what it returns it makes the same.
std::string plainText(std::string bytes, const std::string& file);

/// One line of a text file, its number counted from 1.
struct TextLine
{
  int number = 0;
  std::string text;
};

/// The lines that are not empty. Signs that word processors and papers set in place of ASCII's
/// (the minus sign, dashes, narrow blanks, primes, curved quotation marks) are ASCII's again.
std::vector<TextLine> splitLines(const std::string& text);

/// "line 12".
std::string lineName(int number);

/// The text without blanks at its ends, in small letters.
std::string trimmed(const std::string& text);
std::string lowered(std::string text);

/// The cells of a line, separated by blanks, tabs or commas.
std::vector<std::string> splitCells(const std::string& text);

/// The whole cell as a finite number (a Fortran D exponent is understood), with a decimal point
/// whatever the locale; false where it is none.
bool parseNumber(std::string cell, double& number);
} // namespace galaxy

#endif
