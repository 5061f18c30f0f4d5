#ifndef galaxy_RenderProgress_h
#define galaxy_RenderProgress_h

#include <atomic>
#include <cstddef>
#include <functional>

namespace galaxy
{
/// How much of a picture is done, as all threads tell it, and whether it is still wanted. The work
/// comes in stages, one after the other.
class RenderProgress
{
public:
  /// `report` as in RenderOptions; it is asked at once, and then a few hundred times a picture.
  explicit RenderProgress(const std::function<bool(double)>& report);

  /// A stage begins that is so much of the whole picture, in so many pieces of work.
  void begin(double shareOfPicture, std::size_t pieces);

  /// So many more pieces are done. False when the picture is not wanted any more.
  bool advance(std::size_t pieces);

  bool isAborted() const { return this->aborted; }

private:
  void tell(double fraction);

  const std::function<bool(double)>& report;
  double begun = 0; ///< of the picture, by the stages before
  double share = 0;
  std::size_t pieces = 1;
  std::atomic<std::size_t> done{ 0 };
  double next = 0; ///< the fraction at which to tell again; the calling thread's
  std::atomic<bool> aborted{ false };
};
} // namespace galaxy

#endif
