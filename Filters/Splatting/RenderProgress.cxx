#include "Filters/Splatting/RenderProgress.h"

#include <algorithm>
#include <omp.h>

namespace galaxy
{
RenderProgress::RenderProgress(const std::function<bool(double)>& report_)
  : report(report_)
{
  this->tell(0);
}

void RenderProgress::begin(double shareOfPicture, std::size_t pieces_)
{
  this->begun += this->share;
  this->share = shareOfPicture;
  this->pieces = std::max<std::size_t>(1, pieces_);
  this->done = 0;
}

bool RenderProgress::advance(std::size_t more)
{
  const std::size_t sum = this->done += more;
  // Only the thread that asked for the picture may call back.
  if (omp_get_thread_num() == 0)
  {
    const double part = std::min(1.0, double(sum) / double(this->pieces));
    this->tell(std::min(1.0, this->begun + this->share * part));
  }
  return !this->aborted;
}

void RenderProgress::tell(double fraction)
{
  if (this->report && !this->aborted && fraction >= this->next)
  {
    this->next = fraction + 1.0 / 256;
    this->aborted = !this->report(fraction);
  }
}
} // namespace galaxy
