#include "Filters/Model/Viewpoints.h"

#include "Filters/Model/RingGeometry.h"
#include "Filters/Splatting/Camera.h"
#include "Readers/Formats/SkyFrame.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
namespace
{
/// A galaxy at M83's place and distance with one image of `size` pixels of `pixel` arcsec.
Galaxy galaxyWith(const RingTable& rings, SpinSense spin, int size = 101, double pixel = 4)
{
  Galaxy made;
  made.description.centre = m83Centre;
  made.description.distance = m83Distance;
  made.description.spin = spin;
  made.description.images = { pictureDescription("r", pixel) };
  ComponentDescription stars;
  stars.layers.emplace_back();
  stars.layers[0].image = "r";
  made.description.components = { stars };
  made.rings = rings;
  made.images = { skyPicture(
    size, [](double, double) { return 1.0; }, pixel) };
  return made;
}

/// Where a point is seen in a picture of 2 x 2, whose middle is (0, 0).
Vec3 seen(const Viewpoint& view, const Vec3& p)
{
  const Camera camera =
    Camera::lookAt(view.position, view.focalPoint, view.viewUp, false, 1, view.viewAngle, 2, 2);
  const Vec3 ray = p - camera.eye;
  const double depth = dot(ray, camera.forward);
  return { camera.scale * dot(ray, camera.right) / depth,
    camera.scale * dot(ray, camera.up) / depth, depth };
}

double angle(const Vec3& p, const Vec3& q)
{
  return std::acos(dot(normalized(p), normalized(q))) / degree;
}

const Galaxy m83 = galaxyWith(m83Rings(), SpinSense::Clockwise);
} // namespace

TEST(Viewpoints, FromEarthTheImageFillsTheView)
{
  const Outlook outlook = outlookOf(m83);
  EXPECT_EQ(outlook.distance, 4900);
  ASSERT_EQ(outlook.fields.size(), 1u);
  EXPECT_EQ(outlook.fields[0].image, "r");
  const double halfSize = 0.5 * 101 * 4 * m83Kpc;
  EXPECT_NEAR(outlook.halfSize / halfSize, 1, 1e-6);
  const Viewpoint earth = earthView(outlook.distance, outlook.halfSize);
  EXPECT_NEAR(earth.viewAngle * 3600 / (101 * 4), 1, 1e-6);
  EXPECT_NEAR(earth.position.z, 4900, 1e-9);
  // West is right and North up, at the edge; nearer things are seen larger.
  EXPECT_NEAR(seen(earth, { halfSize, 0, 0 }).x, 1, 1e-6);
  EXPECT_NEAR(seen(earth, { 0, halfSize, 0 }).y, 1, 1e-6);
  EXPECT_NEAR(seen(earth, { halfSize, 0, 490 }).x, 1 / 0.9, 1e-6);
}

TEST(Viewpoints, FromEarthAsAnImageItsPixelsAreTheViews)
{
  constexpr double pixel = 4, angle = 35; // arcsec; of +y, North through East, degrees
  const SkyPosition centre = { m83Centre.ra + 0.05, m83Centre.dec - 0.03 };
  for (const bool mirrored : { false, true })
  {
    Galaxy input = m83;
    input.images[0].width = 120;
    input.images[0].height = 80;
    input.images[0].values.resize(120 * 80);
    SuppliedCoordinates& coordinates = input.description.images[0].coordinates;
    coordinates = { centre, { 0, 0 }, pixel, angle, mirrored };
    const Viewpoint view = outlookOf(input).fields.at(0).view;
    EXPECT_NEAR(view.viewAngle, 2 * std::atan(40 * pixel / 3600 * degree) / degree, 1e-9);
    EXPECT_NEAR(length(view.position - Vec3{ 0, 0, 4900 }), 0, 1e-9);
    // The directions to the image's centre and, a hundredth of a degree from it, to points at the
    // angle of +y and at right angles to it.
    const SkyFrame frame(m83Centre, m83Distance), image(centre, m83Distance);
    const Camera camera = Camera::lookAt(
      view.position, view.focalPoint, view.viewUp, false, 1, view.viewAngle, 120, 80);
    const auto place = [&](double toEast, double toNorth) {
      double x = 0, y = 0;
      const double step = 4900 * std::tan(0.01 * degree);
      EXPECT_TRUE(frame.skyToPlane(image.planeToSky(-step * toEast, step * toNorth), x, y));
      const Vec3 ray = Vec3{ x, y, 0 } - camera.eye;
      const double depth = dot(ray, camera.forward);
      return Vec3{ camera.scale * dot(ray, camera.right) / depth,
        camera.scale * dot(ray, camera.up) / depth, 0 };
    };
    const double pixels = std::tan(0.01 * degree) / (pixel / 3600 * degree);
    const double sine = std::sin(angle * degree), cosine = std::cos(angle * degree);
    EXPECT_NEAR(length(place(0, 0)), 0, 1e-6);
    EXPECT_NEAR(length(place(sine, cosine) - Vec3{ 0, pixels, 0 }), 0, 1e-6);
    EXPECT_NEAR(length(place(-cosine, sine) - Vec3{ pixels, 0, 0 }), 0, 1e-6); // as the sky is
  }
}

TEST(Viewpoints, TheDiscIsThatOfTheInnermostRing)
{
  const Outlook outlook = outlookOf(m83);
  EXPECT_NEAR(angle(outlook.normal, { 0, 0, -1 }), 23.7, 1e-9); // clockwise
  const double pa = 227 * degree;                               // North through East, and X is West
  EXPECT_NEAR(angle(outlook.majorAxis, { -std::sin(pa), std::cos(pa), 0 }), 0, 1e-5);
}

TEST(Viewpoints, FaceOnTheRingIsACircleAndEdgeOnALine)
{
  for (const SpinSense spin : { SpinSense::Clockwise, SpinSense::CounterClockwise })
  {
    const Galaxy input = galaxyWith(flatDisk(2, 60, 130), spin);
    const Outlook outlook = outlookOf(input);
    const TiltedDisk disk(input.rings, m83Distance, spin);
    double radius = 0;
    for (const double theta : { 0.0, 1.0, 2.0, 4.0 })
    {
      const Vec3 p = disk.position(2, theta);
      const Vec3 face = seen(faceOnView(outlook), p);
      radius = radius == 0 ? std::hypot(face.x, face.y) : radius;
      EXPECT_NEAR(std::hypot(face.x, face.y), radius, 1e-9);
      EXPECT_NEAR(seen(edgeOnView(outlook), p).y, 0, 1e-9);
      EXPECT_NEAR(seen(majorAxisView(outlook), p).y, 0, 1e-9);
    }
    EXPECT_NEAR(radius, 2 / outlook.halfSize, 1e-9);
    // Edge-on the major axis is level, and along it the receding end is before the eye.
    EXPECT_NEAR(std::abs(seen(edgeOnView(outlook), disk.position(2, 0)).x), radius, 1e-9);
    const Vec3 receding = seen(majorAxisView(outlook), disk.position(2, 0));
    EXPECT_NEAR(receding.x, 0, 1e-9);
    EXPECT_LT(receding.z, seen(majorAxisView(outlook), disk.position(2, pi)).z);
  }
}

TEST(Viewpoints, TheFaceSeenFromEarthIsTheFaceShown)
{
  for (const double inclination : { 20.0, 70.0, 110.0, 160.0 })
  {
    const Outlook outlook =
      outlookOf(galaxyWith(flatDisk(2, inclination, 40), SpinSense::CounterClockwise));
    const Vec3 face = (outlook.normal.z < 0 ? -1.0 : 1.0) * outlook.normal;
    EXPECT_GT(dot(faceOnView(outlook).position, face), 0);
    EXPECT_GT(edgeOnView(outlook).position.z, 0);
    EXPECT_GT(seen(edgeOnView(outlook), 0.1 * face).y, 0);
    EXPECT_GT(seen(majorAxisView(outlook), 0.1 * face).y, 0);
    // No roll: the major axis has the direction on the sky that it has face-on.
    const Vec3 face2 = seen(faceOnView(outlook), outlook.majorAxis);
    const Vec3 sky = seen(earthView(outlook.distance, outlook.halfSize), outlook.majorAxis);
    EXPECT_NEAR(std::atan2(face2.y, face2.x), std::atan2(sky.y, sky.x), 1e-9);
  }
}

TEST(Viewpoints, AFaceOnDiscIsSeenFaceOnFromEarth)
{
  const Outlook outlook = outlookOf(galaxyWith(flatDisk(2), SpinSense::CounterClockwise));
  const Viewpoint view = faceOnView(outlook);
  EXPECT_NEAR(angle(view.position, { 0, 0, 1 }), 0, 1e-5);
  EXPECT_NEAR(angle(view.viewUp, { 0, 1, 0 }), 0, 1e-5);
}

TEST(Viewpoints, WithoutAnImageTheDiscFillsTheView)
{
  Galaxy input = galaxyWith(m83Rings(), SpinSense::Clockwise);
  input.description.components[0].layers.clear();
  EXPECT_NEAR(outlookOf(input).halfSize, 2230 * m83Kpc, 1e-9);
  input.description.images[0].suppliesCoordinates = false; // and the header has none
  EXPECT_TRUE(outlookOf(input).fields.empty());
}

TEST(Viewpoints, APictureFromEarthHoldsEveryParticle)
{
  Particles particles;
  const std::vector<float> places = { 10, 0, 0, 0, -9, 490, 0, 0, 20 };
  particles.position.resize(places.size());
  std::copy(places.begin(), places.end(), particles.position.begin());
  particles.smoothingLength.resize(3);
  particles.intensity.resize(3);
  EXPECT_NEAR(halfSizeOf(particles, 4900), 10, 1e-6);
  EXPECT_NEAR(halfSizeOf(particles, 980), 18, 1e-6);
}

TEST(Viewpoints, ANarrowViewShowsTheWholeWidth)
{
  EXPECT_EQ(fittedAngle(30, 1.5), 30);
  EXPECT_NEAR(std::tan(fittedAngle(30, 0.5) / 2 * degree), 2 * std::tan(15 * degree), 1e-12);
}
} // namespace galaxy
