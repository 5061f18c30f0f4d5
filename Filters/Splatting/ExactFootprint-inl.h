// The weights of one very thick absorber on the pixels of a tile.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_ExactFootprint_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_ExactFootprint_inl_h
#undef galaxy_ExactFootprint_inl_h
#else
#define galaxy_ExactFootprint_inl_h
#endif

#include "Filters/Splatting/FootprintShare.h"
#include "Filters/Splatting/Footprints-inl.h"
#include "Filters/Splatting/TileComposite.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Of an absorber through which light comes only where its footprint has almost ended: what there
/// is a millionth of its middle has to be right to a part of itself, as single precision has it
/// neither in the shares of pixels nor in the particle's place. In double precision, by definition.
class ExactFootprint
{
public:
  using D = Tag;
  static constexpr bool isGeneral = true;
  Box box;

  /// False if the splat misses the tile.
  HWY_NOINLINE bool prepare(const Splat& splat, const TileTask& task)
  {
    for (auto& row : this->table)
    {
      std::fill_n(row, tileStride, 0.0F);
    }
    const Projection& projection = *task.projection;
    const std::size_t particle = SlabName::of(splat).particle;
    return splat.kind() == SplatKind::Near ? this->seeNear(projection, particle, task)
                                           : this->see(projection.placeOf(particle), task);
  }
  HWY_INLINE V rowAt(int) const { return hn::Zero(tag); }
  HWY_INLINE V columnsAt(int) const { return hn::Zero(tag); }
  HWY_INLINE V weights(V, int y, int x) const { return hn::LoadU(tag, this->table[y] + x); }

private:
  bool see(const Projection::Place& place, const TileTask& task)
  {
    const double x = place.x - task.left, y = place.y - task.bottom;
    const double h = std::max(place.h, leastRadius(task.kernel));
    const auto inTile = [](double pixel) {
      return static_cast<int>(std::clamp(std::floor(pixel), 0.0, double(tileSide)));
    };
    this->box.x0 = inTile(x - h);
    this->box.y0 = inTile(y - h);
    this->box.columns = inTile(x + h + 1) - this->box.x0;
    this->box.rows = inTile(y + h + 1) - this->box.y0;
    if (this->box.columns <= 0 || this->box.rows <= 0)
    {
      return false;
    }
    FootprintShares shares(task.kernel, x, y, h);
    for (int row = 0; row < this->box.rows; ++row)
    {
      for (int column = 0; column < this->box.columns; ++column)
      {
        this->table[row][column] =
          static_cast<float>(shares.of(this->box.x0 + column, this->box.y0 + row));
      }
    }
    return true;
  }

  bool seeNear(const Projection& projection, std::size_t particle, const TileTask& task)
  {
    const Camera& camera = projection.lens().camera();
    const NearParticle near = projection.near(particle);
    const double pixel = near.sigma / (camera.scale * NearParticle::sigmas(task.kernel));
    this->box = { 0, 0, tileSide, tileSide };
    for (int row = 0; row < tileSide; ++row)
    {
      for (int column = 0; column < tileSide; ++column)
      {
        const double u = (task.left + column + 0.5 - camera.centerX) / camera.scale;
        const double v = (task.bottom + row + 0.5 - camera.centerY) / camera.scale;
        this->table[row][column] = static_cast<float>(near.column(u, v) * pixel * pixel);
      }
    }
    return true;
  }

  HWY_ALIGN float table[tileSide][tileStride];
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
