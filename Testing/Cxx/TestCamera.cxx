#include "Filters/Splatting/Camera.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

void expectOrthonormal(const Camera& camera)
{
  EXPECT_NEAR(dot(camera.right, camera.right), 1, 1e-14);
  EXPECT_NEAR(dot(camera.up, camera.up), 1, 1e-14);
  EXPECT_NEAR(dot(camera.forward, camera.forward), 1, 1e-14);
  EXPECT_NEAR(length(cross(camera.right, camera.up) + camera.forward), 0, 1e-14);
}

TEST(Camera, DefaultViewShowsNorthUpAndWestToTheRight)
{
  const Camera camera = Camera::lookAt({ 0, 0, 10 }, {}, { 0, 1, 0 }, true, 4, 30, 200, 100);
  EXPECT_DOUBLE_EQ(camera.right.x, 1);
  EXPECT_DOUBLE_EQ(camera.up.y, 1);
  EXPECT_DOUBLE_EQ(camera.forward.z, -1);
  EXPECT_DOUBLE_EQ(camera.scale, 100 / 8.0); // parallelScale is half the height
  EXPECT_DOUBLE_EQ(camera.centerX, 100);
  EXPECT_DOUBLE_EQ(camera.centerY, 50);
}

TEST(Camera, ViewAngleSpansTheHeight)
{
  const Camera camera = Camera::lookAt({ 0, 0, 10 }, {}, { 0, 1, 0 }, false, 1, 60, 200, 100);
  const double top = camera.centerY + camera.scale * std::tan(M_PI / 6);
  EXPECT_NEAR(top, 100, 1e-12);
}

TEST(Camera, FrameIsOrthonormalForAnyViewUp)
{
  const Vec3 ups[] = { { 0, 1, 0 }, { 1, 2, 3 }, { 0, 0, 1 }, { 0, 0, 0 }, { 0, 0, -1e-30 } };
  const Vec3 eyes[] = { { 0, 0, 10 }, { 0, 5, 0 }, { 3, -2, 1e4 }, { 0, 0, 0 } };
  for (const Vec3& up : ups)
  {
    for (const Vec3& eye : eyes)
    {
      expectOrthonormal(Camera::lookAt(eye, {}, up, false, 1, 30, 10, 10));
    }
  }
}

TEST(Camera, ViewUpPointsUp)
{
  const Camera camera = Camera::lookAt({ 7, 3, 10 }, { 1, 0, 0 }, { 1, 2, 0.5 }, true, 4, 30, 9, 9);
  EXPECT_GT(dot(camera.up, { 1, 2, 0.5 }), 0);
  EXPECT_NEAR(dot(camera.right, { 1, 2, 0.5 }), 0, 1e-14);
}
} // namespace
