#ifndef galaxy_CardWriter_h
#define galaxy_CardWriter_h

#include <charconv>
#include <string>

namespace galaxy
{
/// Writes a header of 80-character cards.
class CardWriter
{
public:
  void number(const std::string& keyword, double value)
  {
    char digits[32];
    this->card(
      keyword, std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr));
  }

  /// `value` has no quotes and at most 68 characters.
  void text(const std::string& keyword, const std::string& value)
  {
    this->card(keyword, "'" + value + "'");
  }

  const std::string& cards() const { return this->written; }

private:
  void card(std::string keyword, const std::string& value)
  {
    keyword.resize(8, ' ');
    std::string card = keyword + "= " + value;
    card.resize(80, ' ');
    this->written += card;
  }

  std::string written;
};
} // namespace galaxy

#endif
