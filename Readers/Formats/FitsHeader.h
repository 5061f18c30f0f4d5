#ifndef galaxy_FitsHeader_h
#define galaxy_FitsHeader_h

#include <map>
#include <optional>
#include <set>
#include <string>

namespace galaxy
{
/// The keywords of one header unit and their values; of a keyword that stands twice the first.
/// Indices of coordinate keywords are named as the standard does: PC3_3 is also the old PC003003.
class FitsHeader
{
public:
  static constexpr std::size_t cardLength = 80;

  FitsHeader() = default;
  /// From cards of 80 characters, one after the other (Image::cards).
  explicit FitsHeader(const std::string& cards);

  /// Takes in one card of 80 characters; one without a value is passed over.
  void add(const std::string& card);

  // Each is empty where the keyword is absent or not of that kind.
  std::optional<std::string> text(const std::string& keyword) const;
  std::optional<double> number(const std::string& keyword) const; ///< finite, also in quotes
  std::optional<long long> integer(const std::string& keyword) const;
  bool flag(const std::string& keyword) const;

  /// Whether it is a text that no quote closes.
  bool isUnclosed(const std::string& keyword) const;

  /// What stands behind the value's slash; empty where nothing does.
  std::string comment(const std::string& keyword) const;

  /// A keyword that begins so and stands more than once; empty where there is none.
  std::string repeated(const std::string& beginning) const;

private:
  struct Entry
  {
    std::string value; ///< without quotes and trailing blanks
    std::string comment;
    bool isUnclosed = false;
  };
  std::map<std::string, Entry> entries;
  std::set<std::string> repeatedKeywords;
};

/// "NAXIS" and 3 are "NAXIS3".
std::string fitsKeyword(const std::string& root, std::size_t number);

/// A finite number, also with Fortran's exponent letter of double precision, D; none where the text
/// is anything else. A decimal point is one in every locale.
std::optional<double> fitsNumber(std::string text);

std::string upperCase(std::string text);
} // namespace galaxy

#endif
