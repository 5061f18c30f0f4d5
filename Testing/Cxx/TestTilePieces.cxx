#include "Filters/Splatting/TilePieces.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <omp.h>

namespace
{
using namespace galaxy;

/// So many particles that their one tile is drawn in pieces; all of them together have an optical
/// depth of about 2.
enum class Crowd
{
  StarsAndDust,
  Stars,
  OneSource,
  EqualDepths,
};

Scene crowd(Crowd kind)
{
  const int n = static_cast<int>(TilePieces::fewestSplats) + 60000;
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(0, 1);
  Scene scene;
  for (int i = 0; i < n; ++i)
  {
    const double z = kind == Crowd::EqualDepths ? i % 3 : 2 * uniform(random) - 1;
    const Vec3 p{ 1.8 * uniform(random) - 0.9, 1.8 * uniform(random) - 0.9, z };
    const float L = uniform(random) / n;
    const bool isDust = kind == Crowd::OneSource || (kind != Crowd::Stars && i % 4 == 0);
    const float K = isDust ? 10 * L : 0;
    const bool emits = !isDust || kind == Crowd::OneSource;
    const std::array<float, 3> light{ L, 0.5F * L, 2 * L };
    scene.add(p, 0.02 + 0.2 * uniform(random), emits ? light : std::array<float, 3>{},
      { K, 1.5F * K, 2 * K });
  }
  return scene;
}

TEST(TilePieces, ACrowdedTileIsAsTheReferenceHasItAndAnyNumberOfThreads)
{
  const int threads = omp_get_max_threads();
  for (const Crowd kind :
    { Crowd::StarsAndDust, Crowd::Stars, Crowd::OneSource, Crowd::EqualDepths })
  {
    SCOPED_TRACE(static_cast<int>(kind));
    const Scene scene = crowd(kind);
    const Camera camera = testCamera(true, 16, 16);
    const auto slow = renderReference(scene.view(), camera);
    const auto fast = renderSorted(scene.view(), camera);
    EXPECT_GE(fast.statistics.drawn, TilePieces::fewestSplats);
    EXPECT_LT(largestDifference(fast.radiance, slow.radiance), 1e-5 * largest(slow.radiance));
    EXPECT_LT(largestDifference(fast.transmittance, slow.transmittance), 1e-5);
    for (const int n : { 1, 3 })
    {
      omp_set_num_threads(n);
      const auto other = renderSorted(scene.view(), camera);
      EXPECT_EQ(other.radiance, fast.radiance);
      EXPECT_EQ(other.transmittance, fast.transmittance);
    }
    omp_set_num_threads(threads);
  }
}

TEST(TilePieces, ACrowdedTileKeepsWhatIsAllowed)
{
  const Scene scene = crowd(Crowd::StarsAndDust);
  const Camera camera = testCamera(true, 16, 16);
  const auto exact = renderReference(scene.view(), camera);
  for (const double share : { 0.3, 0.01 })
  {
    RenderOptions options;
    options.allowed.share = share;
    options.allowed.light = share * largest(exact.radiance);
    const auto image = renderBounded(scene.view(), camera, options);
    EXPECT_GT(image.statistics.faint, 0u);
    for (std::size_t i = 0; i < exact.radiance.size(); ++i)
    {
      EXPECT_LE(std::abs(image.radiance[i] - exact.radiance[i]),
        options.allowed.light + share * exact.radiance[i]);
    }
  }
}

/// Every splat is in one piece, and nothing of a piece is nearer than what is in those before.
TEST(TilePieces, ArePartsOfTheDepth)
{
  std::mt19937 random(3);
  std::vector<Splat> splats(TilePieces::fewestSplats + 12345);
  for (Splat& splat : splats)
  {
    splat = {};
    splat.depth = random() % 1000;
  }
  TileTask task;
  task.splats = splats.data();
  task.count = splats.size();
  TilePieces pieces(task, {}, true);
  EXPECT_GT(pieces.size(), 1);
  std::vector<int> seen(splats.size());
  std::uint32_t farthest = 0;
  for (int k = 0; k < pieces.size(); ++k)
  {
    std::uint32_t next = farthest;
    for (const KeyedSlot* item = pieces.begin(k); item != pieces.end(k); ++item)
    {
      ++seen[slotOf(*item)];
      const std::uint32_t depth = splats[slotOf(*item)].depth;
      EXPECT_GE(depth, farthest);
      next = std::max(next, depth + 1);
    }
    farthest = next;
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(seen.size()));
}
} // namespace
