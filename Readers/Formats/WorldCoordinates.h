#ifndef galaxy_WorldCoordinates_h
#define galaxy_WorldCoordinates_h

#include <array>
#include <memory>
#include <string>

namespace galaxy
{
/// ICRS right ascension and declination in degrees.
struct SkyPosition
{
  double ra = 0;
  double dec = 0;
};

/// Pixel coordinates as FITS counts them: the centre of the first pixel is (1, 1).
struct PixelPosition
{
  double x = 0;
  double y = 0;
};

/// A plain tangent projection for images whose header has no celestial coordinates.
struct SuppliedCoordinates
{
  SkyPosition centre;       ///< sky position of the reference pixel, degrees
  PixelPosition pixel;      ///< reference pixel; (0, 0) means the image's middle
  double pixelScale = 0;    ///< arcsec per pixel; 0 means "use the header"
  double positionAngle = 0; ///< of the image's +y axis, North through East, degrees
  bool mirrored = false;    ///< true where East is to the right of North
};

/// The celestial world coordinates of an image: pixel to sky and back through WCSLIB, for any
/// projection it knows with the distortions of CoordinateCards, brought to ICRS from the frames of
/// frameOfHeader. The plate solution of a Digitized Sky Survey image counts where it agrees with
/// the axes that the header may have beside it.
class WorldCoordinates
{
public:
  /// From header cards (Image::cards) and the image's size; `axes` are the FITS axes, from 1, that
  /// its x and y are. The further axes of a cube stand at their first pixel.
  /// Throws Error where the two image axes are not celestial or WCSLIB rejects them, as it must
  /// where they are tabulated (-TAB) in another part of the file.
  WorldCoordinates(const std::string& file, const std::string& cards, int width, int height,
    const std::array<int, 2>& axes = { 1, 2 });
  /// From a supplied tangent projection; throws Error where its pixel scale is not positive.
  WorldCoordinates(const SuppliedCoordinates& supplied, int width, int height);
  ~WorldCoordinates();
  WorldCoordinates(WorldCoordinates&&) noexcept;
  WorldCoordinates& operator=(WorldCoordinates&&) noexcept;

  /// Each returns false where the projection has no such point; a place that is not seen in the
  /// pixel that it was computed from is none. WCSLIB writes into its description
  /// even when it only converts: use one object in one thread at a time.
  bool pixelToSky(const PixelPosition& pixel, SkyPosition& sky) const;
  bool skyToPixel(const SkyPosition& sky, PixelPosition& pixel) const;

private:
  struct State;

  std::unique_ptr<State> state;
};
} // namespace galaxy

#endif
