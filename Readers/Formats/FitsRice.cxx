#include "Readers/Formats/FitsRice.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// Bits from the highest of each byte on; what is taken beyond the end is zero.
class Bits
{
public:
  explicit Bits(const std::string& bytes)
    : bytes(bytes)
    , end(static_cast<long long>(bytes.size()) * 8)
  {
  }

  void skip(long long count) { this->at += count; }
  bool next()
  {
    const bool bit = this->isInside() &&
      (this->bytes[static_cast<std::size_t>(this->at / 8)] >> (7 - this->at % 8) & 1);
    ++this->at;
    return bit;
  }
  int take(int count)
  {
    int number = 0;
    for (int i = 0; i < count; ++i)
    {
      number = 2 * number + this->next();
    }
    return number;
  }
  /// Past the next set bit.
  void skipZeros()
  {
    while (this->isInside() && !this->next())
    {
    }
  }
  bool isInside() const { return this->at < this->end; }
  bool isValid() const { return this->at <= this->end; }

private:
  const std::string& bytes;
  const long long end;
  long long at = 0;
};

/// The number of bits that hold a block's split position, and the position that means "as it is".
struct RiceCode
{
  int splitBits;
  int plain;
  int pixelBits;
};
RiceCode codeOf(long long pixelBytes)
{
  return pixelBytes == 1 ? RiceCode{ 3, 6, 8 }
    : pixelBytes == 2    ? RiceCode{ 4, 14, 16 }
                         : RiceCode{ 5, 25, 32 };
}
} // namespace

bool riceStreamHolds(
  const std::string& stream, long long pixels, long long pixelBytes, long long blockSize)
{
  const RiceCode code = codeOf(pixelBytes);
  Bits bits(stream);
  bits.skip(code.pixelBits); // the first pixel
  for (long long start = 0; start < pixels && bits.isInside(); start += blockSize)
  {
    const long long count = std::min(blockSize, pixels - start);
    const int split = bits.take(code.splitBits) - 1;
    if (split > code.plain)
    {
      return false;
    }
    if (split == code.plain)
    {
      bits.skip(count * code.pixelBits);
    }
    for (long long i = 0; i < count && split >= 0 && split < code.plain; ++i)
    {
      if (!bits.isInside())
      {
        return false;
      }
      bits.skipZeros();
      bits.skip(split);
    }
    if (!bits.isValid() || (!bits.isInside() && start + blockSize < pixels))
    {
      return false;
    }
  }
  return pixels == 0 || bits.isValid();
}
} // namespace galaxy
