#ifndef galaxy_SplatCanvas_h
#define galaxy_SplatCanvas_h

#include <memory>
#include <string>
#include <vector>

class vtkRenderer;

namespace galaxy
{
/// A picture as it is shown, rows from below, and what there is to say of it.
struct ShownPicture
{
  int width = 0, height = 0;        ///< 0: there is none
  std::vector<float> light;         ///< red, green and blue of each pixel, white is 1
  std::vector<float> transmittance; ///< of what lies behind; empty: 1
  std::string activeEffects, renderStatistics;
};

/// Lays pictures over what a renderer has drawn: the destination times the transmittance, plus the
/// light, each per channel. What OpenGL holds of them is released with it.
class SplatCanvas
{
public:
  SplatCanvas();
  ~SplatCanvas();

  /// The renderer's window is to be rendering.
  void lay(const ShownPicture& picture, vtkRenderer* renderer);
  /// The same when the renderer has ended, on its part of the window.
  void layOnWhole(const ShownPicture& picture, vtkRenderer* renderer);

private:
  struct Quad;
  std::unique_ptr<Quad> quad;
};
} // namespace galaxy

#endif
