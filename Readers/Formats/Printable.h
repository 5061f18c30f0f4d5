#ifndef galaxy_Printable_h
#define galaxy_Printable_h

#include <cstddef>
#include <cstdio>
#include <string>

namespace galaxy
{
/// The bytes of the UTF-8 character at `at`; 0 where there is none that may be printed: a control
/// character, one that turns the direction of writing, or a byte that belongs to no character.
inline std::size_t printableLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  if (first < 0x80)
  {
    return first >= 0x20 && first != 0x7f ? 1 : 0;
  }
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
  if (length == 0 || first > 0xf4 || at + length > text.size())
  {
    return 0;
  }
  unsigned code = first & (0xffu >> (length + 1));
  for (std::size_t i = at + 1; i < at + length; ++i)
  {
    if ((byte(i) & 0xc0u) != 0x80)
    {
      return 0;
    }
    code = code << 6 | (byte(i) & 0x3fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool control = code < 0xa0 || (code >= 0x200b && code <= 0x200f) ||
    (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
  const bool none = (code >= 0xd800 && code <= 0xdfff) || code > 0x10ffff;
  return overlong || control || none ? 0 : length;
}

/// Text from a file for a message: what would reach a terminal or a log as anything but a letter
/// stands there as \x1b.
inline std::string printable(const std::string& text)
{
  std::string out;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = printableLength(text, at);
    if (length > 0)
    {
      out.append(text, at, length);
      at += length;
      continue;
    }
    char escaped[5];
    std::snprintf(escaped, sizeof escaped, "\\x%02x", static_cast<unsigned char>(text[at++]));
    out += escaped;
  }
  return out;
}

/// The text without its middle where it is longer than `most` bytes.
inline std::string shortened(const std::string& text, std::size_t most)
{
  if (text.size() <= most)
  {
    return text;
  }
  const auto continues = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80;
  };
  std::size_t head = most * 2 / 3, tail = text.size() - most / 3;
  for (; head > 0 && continues(head); --head)
  {
  }
  for (; tail < text.size() && continues(tail); ++tail)
  {
  }
  return text.substr(0, head) + " ... " + text.substr(tail);
}

/// A cell, word or name of a file in a message: 'text', printable and short.
inline std::string quoted(const std::string& text)
{
  constexpr std::size_t most = 60;
  return "'" + printable(shortened(text, most)) + "'";
}
} // namespace galaxy

#endif
