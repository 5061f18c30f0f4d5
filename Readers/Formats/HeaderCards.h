#ifndef galaxy_HeaderCards_h
#define galaxy_HeaderCards_h

#include <optional>
#include <string>

namespace galaxy
{
/// The value field of the first card with this keyword, as text with its quotes and comment; empty
/// where there is none.
std::string cardValue(const std::string& cards, const std::string& keyword);

/// The number of the first card with this keyword in a header of 80-character cards; none where
/// there is no such card or its value is not a number.
std::optional<double> cardNumber(const std::string& cards, const std::string& keyword);
} // namespace galaxy

#endif
