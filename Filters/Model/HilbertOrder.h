#ifndef galaxy_HilbertOrder_h
#define galaxy_HilbertOrder_h

namespace galaxy
{
/// Visits the cells of a width x height grid along Hilbert's curve (Hilbert 1891): a stretch of it
/// is a compact patch, so that what is spread evenly along the curve is spread evenly over the
/// grid. `visit(column, row)` is called once a cell.
template <typename Visit>
class HilbertOrder
{
public:
  HilbertOrder(int width, int height, Visit visit)
    : width(width)
    , height(height)
    , visit(visit)
  {
    int size = 1;
    while (size < width || size < height)
    {
      size *= 2;
    }
    this->walk(0, 0, size, 0);
  }

private:
  /// The four turns of the curve: the quadrants (x + 2 y) in their order and each one's own turn.
  struct Turn
  {
    int quadrant[4];
    int next[4];
  };
  static constexpr Turn turns[4] = {
    { { 0, 2, 3, 1 }, { 1, 0, 0, 3 } },
    { { 0, 1, 3, 2 }, { 0, 1, 1, 2 } },
    { { 3, 1, 0, 2 }, { 3, 2, 2, 1 } },
    { { 3, 2, 0, 1 }, { 2, 3, 3, 0 } },
  };

  void walk(int column, int row, int size, int turn)
  {
    if (column >= this->width || row >= this->height)
    {
      return;
    }
    if (size == 1)
    {
      this->visit(column, row);
      return;
    }
    const int half = size / 2;
    for (int k = 0; k < 4; ++k)
    {
      const int quadrant = turns[turn].quadrant[k];
      this->walk(
        column + (quadrant & 1) * half, row + (quadrant >> 1) * half, half, turns[turn].next[k]);
    }
  }

  int width;
  int height;
  Visit visit;
};
} // namespace galaxy

#endif
