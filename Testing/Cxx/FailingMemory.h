#ifndef galaxy_FailingMemory_h
#define galaxy_FailingMemory_h

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <string>

namespace galaxy::testing
{
/// Of the requests for memory that the program makes while this is there, by operator new, realloc
/// and aligned_alloc, lets one fail, or that and all that follow it.
class FailingMemory
{
public:
  enum class Which
  {
    None, ///< counts them only
    One,
    Rest,
  };
  FailingMemory(Which which, long request);
  ~FailingMemory() { this->end(); }
  FailingMemory(const FailingMemory&) = delete;
  void operator=(const FailingMemory&) = delete;
  void end();

  /// Of the last or present one.
  static long requests();
  /// Blocks of operator new that are in use.
  static long inUse();
};

/// What memory a work that failed may keep.
enum class Kept
{
  Nothing,
  Some, ///< a state of its own, or what a library loses, which then may say what it likes
};

/// The work's result, none where it throws. That must be std::bad_alloc or speak of memory.
template <typename Work>
auto resultOf(const Work& work, Kept kept, FailingMemory& memory) -> std::optional<decltype(work())>
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    memory.end();
  }
  catch (const std::exception& error)
  {
    memory.end();
    const bool isTold = std::string(error.what()).find("memory") != std::string::npos;
    EXPECT_TRUE(isTold || kept == Kept::Some) << error.what();
  }
  return std::nullopt;
}

/// Does the work again and again while a request for memory fails, the first one or the second and
/// so on, `most` of them at most: it must throw, or have the result that it has else, and keep
/// nothing; afterwards it must do as before.
template <typename Work>
void expectToSurvive(const Work& work, long most, Kept kept = Kept::Nothing)
{
  const auto right = work(); // static tables come into being
  {
    const FailingMemory memory(FailingMemory::Which::None, 0);
    ASSERT_TRUE(work() == right);
  }
  const long requests = FailingMemory::requests();
  const double step = std::max(1.0, double(requests) / double(most));
  for (const auto which : { FailingMemory::Which::One, FailingMemory::Which::Rest })
  {
    int thrown = 0;
    for (double next = 1; next <= double(requests); next += step)
    {
      const auto request = static_cast<long>(next);
      SCOPED_TRACE("request " + std::to_string(request) + " of " + std::to_string(requests));
      const long before = FailingMemory::inUse();
      {
        FailingMemory memory(which, request);
        const auto result = resultOf(work, kept, memory);
        memory.end();
        EXPECT_TRUE(!result || *result == right);
        thrown += !result;
      }
      EXPECT_TRUE(FailingMemory::inUse() == before || kept == Kept::Some);
    }
    EXPECT_GT(thrown, 0);
  }
  EXPECT_TRUE(work() == right);
}
} // namespace galaxy::testing

#endif
