#ifndef galaxy_ExportProgress_h
#define galaxy_ExportProgress_h

#include <algorithm>
#include <functional>
#include <utility>

namespace galaxy
{
/// Thrown where the user asks a writer to stop; exportParticles catches it.
struct ExportAborted
{
};

/// Counts the work done towards a known total.
class ExportProgress
{
public:
  /// `report` gets the fraction done and returns whether to go on; may be empty.
  ExportProgress(std::function<bool(double)> report, double total)
    : report(std::move(report))
    , total(total)
  {
  }

  void advance(double work)
  {
    this->done += work;
    if (this->report && !this->report(std::min(1.0, this->done / this->total)))
    {
      throw ExportAborted();
    }
  }

private:
  std::function<bool(double)> report;
  double total;
  double done = 0;
};
} // namespace galaxy

#endif
