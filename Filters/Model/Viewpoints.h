#ifndef galaxy_Viewpoints_h
#define galaxy_Viewpoints_h

#include "Filters/Model/Particles.h"
#include "Readers/Formats/Galaxy.h"
#include "Readers/Formats/Vec3.h"

#include <string>
#include <vector>

namespace galaxy
{
/// Where a perspective camera stands, in a galaxy's frame (Readers/Formats/Vec3.h), kpc.
struct Viewpoint
{
  Vec3 position;
  Vec3 focalPoint;
  Vec3 viewUp;
  double viewAngle = 30; ///< degrees, from the lower to the upper edge
};

/// How an image lies before the observer.
struct ImageField
{
  std::string image;
  double halfSize = 0; ///< kpc from the galaxy's centre to the West, East, North or South
  Viewpoint view;      ///< from Earth: the image's height fills the view's, and its +y is up
};

/// What is known of how a galaxy lies before its observer.
struct Outlook
{
  double distance = 0;            ///< kpc
  Vec3 normal{ 0, 0, 1 };         ///< of the disc at its centre, along its spin
  Vec3 majorAxis{ 0, 1, 0 };      ///< toward the receding half of the line of nodes
  std::vector<ImageField> fields; ///< of the images that have a place on the galaxy's sky
  double halfSize = 0; ///< kpc that a view shows to each side: the first layer's field, or the disc
};

/// Throws Error where the galaxy's rings cannot be used (TiltedDisk).
Outlook outlookOf(const Galaxy& galaxy);

/// kpc from the origin, at its distance, to the edge of a picture from Earth that holds all
/// particles.
double halfSizeOf(const Particles& particles, double distance);

/// From the observer's place, `distance` kpc before the origin, North up and East left. The angle
/// is the one under which `halfSize` kpc to each side are seen.
Viewpoint earthView(double distance, double halfSize);
/// The view angle, degrees, at which a picture of this width over height shows what a square one
/// does, and more to the sides or above and below.
double fittedAngle(double viewAngle, double aspect);
/// Onto the disc's face that is seen from Earth, as if the galaxy had been tilted about its line of
/// nodes.
Viewpoint faceOnView(const Outlook& outlook);
/// Along the disc's minor axis, from the side that is tilted toward the observer; the major axis is
/// horizontal, and the face that is seen from Earth up.
Viewpoint edgeOnView(const Outlook& outlook);
/// From the receding end of the major axis to the centre, the same face up.
Viewpoint majorAxisView(const Outlook& outlook);
} // namespace galaxy

#endif
