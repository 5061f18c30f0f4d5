#include "Filters/Splatting/TileNodes.h"

#include <cmath>

namespace galaxy
{
const TileNodes tileNodes;

TileNodes::TileNodes()
{
  const double half = tileSide / 2.0;
  double at[side];
  for (int i = 0; i < side; ++i)
  {
    at[i] = -std::cos(M_PI * (i + 0.5) / side);
    this->place[i] = static_cast<float>(half * (1 + at[i]));
  }
  for (int i = 0; i < side; ++i)
  {
    for (int pixel = 0; pixel < tileSide; ++pixel)
    {
      const double x = (pixel + 0.5) / half - 1;
      double product = 1;
      for (int j = 0; j < side; ++j)
      {
        product *= j == i ? 1 : (x - at[j]) / (at[i] - at[j]);
      }
      this->share[i][pixel] = static_cast<float>(product);
    }
  }
}
} // namespace galaxy
