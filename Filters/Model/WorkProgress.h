#ifndef galaxy_WorkProgress_h
#define galaxy_WorkProgress_h

#include "Readers/Formats/Progress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <omp.h>

namespace galaxy
{
/// How much of a work is done, as all its threads tell, and whether it is still wanted. The work
/// comes in stages, one after the other.
class WorkProgress
{
public:
  /// `report` is asked at once, and then a few hundred times; it must outlive this.
  explicit WorkProgress(const Progress& report)
    : report(report)
  {
    this->tell(0);
  }

  /// A stage begins that is so much of the whole work, in so many pieces.
  void begin(double shareOfWhole, std::size_t count)
  {
    this->begun += this->share;
    this->share = shareOfWhole;
    this->pieces = std::max<std::size_t>(1, count);
    this->done = 0;
  }

  /// So many more pieces are done. False when the work is not wanted any more.
  bool advance(std::size_t count)
  {
    const std::size_t sum = this->done += count;
    // Only the thread that asked for the work may call back.
    if (omp_get_thread_num() == 0)
    {
      const double part = std::min(1.0, double(sum) / double(this->pieces));
      this->tell(std::min(1.0, this->begun + this->share * part));
    }
    return !this->aborted;
  }

  bool isAborted() const { return this->aborted; }

private:
  void tell(double fraction)
  {
    if (this->report && !this->aborted && fraction >= this->next)
    {
      this->next = fraction + 1.0 / 256;
      this->aborted = !this->report(fraction);
    }
  }

  const Progress& report;
  double begun = 0; ///< of the whole, by the stages before
  double share = 0;
  std::size_t pieces = 1;
  std::atomic<std::size_t> done{ 0 };
  double next = 0; ///< the fraction at which to tell again; the calling thread's
  std::atomic<bool> aborted{ false };
};
} // namespace galaxy

#endif
