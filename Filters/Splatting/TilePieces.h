#ifndef galaxy_TilePieces_h
#define galaxy_TilePieces_h

#include "Filters/Splatting/DepthOrder.h"
#include "Filters/Splatting/TileComposite.h"
#include "Filters/Splatting/TileSummary.h"

#include <cstddef>
#include <vector>

namespace galaxy
{
/// A tile with so many splats that threads share it: each draws those between two depths. However
/// many threads there are, the pieces are the same, and so is the picture.
class TilePieces
{
public:
  /// A tile with fewer splats is drawn by one thread.
  static constexpr std::size_t fewestSplats = std::size_t(1) << 18;

  /// Lists the task's splats but for those left out, by depth if they are ordered, else in pieces
  /// of consecutive ones; by all threads. To be called outside of their team.
  TilePieces(const TileTask& task, const Omission& omission, bool isOrdered);

  int size() const { return static_cast<int>(this->first.size()) - 1; }
  /// The list of piece k, which may be sorted.
  KeyedSlot* begin(int k) { return this->slots.data() + this->first[k]; }
  KeyedSlot* end(int k) { return this->slots.data() + this->first[k + 1]; }
  std::size_t omitted() const { return this->left; }

private:
  std::vector<KeyedSlot> slots;
  std::vector<std::size_t> first; ///< of each piece's, and of those after the last
  std::size_t left = 0;
};
} // namespace galaxy

#endif
