#ifndef galaxy_TextFuzz_h
#define galaxy_TextFuzz_h

#include <random>
#include <string>
#include <vector>

namespace galaxy
{
using Random = std::mt19937_64;

/// A kind of text: small sound ones, words that mean something in it, and what reads it. The reader
/// returns false where what it made of the text makes no sense; Error is right too, anything else
/// is not.
struct TextKind
{
  const char* name;
  std::vector<std::string> samples;
  std::vector<std::string> words;
  bool (*read)(const std::string& text, Random& random);
  int share = 1; ///< of texts, for kinds with many formats
};

std::size_t below(Random& random, std::size_t count);
/// Changes a text at up to five places.
void mutate(Random& random, const std::vector<std::string>& words, std::string& text);

/// The program FuzzThing COUNT SEED [FILES...|none]: makes COUNT broken texts of each kind, from
/// its samples and from FILES, and reads each; ends at the first that is neither read nor refused
/// with an instruction, that takes too long or that a sanitizer complains about, and prints it.
int fuzzTexts(int argc, char* argv[], std::vector<TextKind> kinds);
} // namespace galaxy

#endif
