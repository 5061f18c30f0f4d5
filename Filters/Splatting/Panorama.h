#ifndef galaxy_Panorama_h
#define galaxy_Panorama_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/Render.h"

namespace galaxy
{
/// A picture of all the sky around the eye, or of a dome of it.
struct Panorama
{
  enum class Kind
  {
    Equirectangular, ///< 360 degrees wide and 180 high, straight ahead in the middle
    Dome,            ///< fisheye: the angle from the middle grows evenly with the radius
  };

  Kind kind = Kind::Equirectangular;
  Camera ahead;           ///< eye and axes; straight ahead is the dome's zenith
  double domeAngle = 180; ///< degrees across the largest circle that the picture holds (Dome)
  int width = 0;          ///< pixels
  int height = 0;

  /// The direction, of length 1, through a point of the picture, as Camera counts pixels; false
  /// outside of the dome.
  bool direction(double x, double y, Vec3& direction) const;

  /// The most pixels a radian of the sky, but for the poles of Equirectangular, where a pixel's row
  /// is a point.
  double finest() const;

  /// No pixel is larger across, radians.
  double largestPixel() const;
};

/// Draws six perspective pictures, the faces of a cube, and takes every pixel of the panorama as
/// the mean over its area of what they show there: radiance per area across the line of sight, and
/// transmittance. Faces are as fine as the panorama is at its finest, and blended at their edges.
/// Outside of a dome nothing is seen. `options.opaqueDepth` is not looked at; of the statistics,
/// particles are counted on every face.
RenderedImage renderPanorama(
  const ParticleView& particles, const Panorama& panorama, const RenderOptions& options = {});
} // namespace galaxy

#endif
