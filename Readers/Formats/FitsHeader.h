#ifndef galaxy_FitsHeader_h
#define galaxy_FitsHeader_h

#include <map>
#include <optional>
#include <set>
#include <string>

namespace galaxy
{
/// The keywords of one header unit and their values; of a keyword that stands twice the first.
class FitsHeader
{
public:
  static constexpr std::size_t cardLength = 80;

  /// Takes in one card of 80 characters; one without a value is passed over.
  void add(const std::string& card);

  // Each is empty where the keyword is absent or not of that kind.
  std::optional<std::string> text(const std::string& keyword) const;
  std::optional<double> number(const std::string& keyword) const;
  std::optional<long long> integer(const std::string& keyword) const;
  bool flag(const std::string& keyword) const;

  /// A keyword that begins so and stands more than once; empty where there is none.
  std::string repeated(const std::string& beginning) const;

private:
  std::map<std::string, std::string> values; ///< strings without quotes and trailing blanks
  std::set<std::string> repeatedKeywords;
};

/// "NAXIS" and 3 are "NAXIS3".
std::string fitsKeyword(const std::string& root, std::size_t number);

std::string upperCase(std::string text);
} // namespace galaxy

#endif
