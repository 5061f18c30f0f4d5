#ifndef galaxy_ParallelFor_h
#define galaxy_ParallelFor_h

#include <atomic>
#include <exception>

namespace galaxy
{
/// The first exception of a parallel region's threads. None may leave the region, which would end
/// the program: what may throw is done in here, and what was thrown is thrown again afterwards.
class ParallelErrors
{
public:
  /// Does the work, unless some has failed already.
  template <typename Work>
  void run(const Work& work) noexcept
  {
    if (this->failed.load(std::memory_order_relaxed))
    {
      return;
    }
    try
    {
      work();
    }
    catch (...)
    {
      if (!this->failed.exchange(true))
      {
        this->first = std::current_exception();
      }
    }
  }

  /// After the region.
  void rethrow() const
  {
    if (this->first)
    {
      std::rethrow_exception(this->first);
    }
  }

private:
  std::atomic<bool> failed{ false };
  std::exception_ptr first;
};

/// Calls body(i) for i from `first` to before `last`, shared out evenly to all threads. Throws the
/// first that a body throws; the bodies that have not begun then are left out.
template <typename Index, typename Body>
void parallelFor(Index first, Index last, const Body& body)
{
  ParallelErrors errors;
#pragma omp parallel for schedule(static)
  for (Index i = first; i < last; ++i)
  {
    errors.run([&] { body(i); });
  }
  errors.rethrow();
}

/// The same, `atOnce` at a time to whichever thread is free.
template <typename Index, typename Body>
void parallelForDynamic(Index first, Index last, int atOnce, const Body& body)
{
  ParallelErrors errors;
#pragma omp parallel for schedule(dynamic, atOnce)
  for (Index i = first; i < last; ++i)
  {
    errors.run([&] { body(i); });
  }
  errors.rethrow();
}
} // namespace galaxy

#endif
