#ifndef galaxy_SplatPicture_h
#define galaxy_SplatPicture_h

#include "Filters/Splatting/JointParticles.h"
#include "Filters/Splatting/LightGroups.h"
#include "Filters/Splatting/Preview.h"
#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/Tiles.h"
#include "Filters/Splatting/ToneMap.h"

#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class vtkPolyData;
class vtkSplatSettings;

namespace galaxy
{
struct ParticleInput;

/// Particles that a view shows, and how.
struct SplatPart
{
  vtkPolyData* particles;
  vtkSplatSettings* settings;
  double exposure;
  vtkMTimeType version; ///< when the particles changed last
};

/// How a picture is asked for.
struct SplatRequest
{
  Camera camera;
  std::vector<float> opaqueDepth; ///< see RendererCamera.h
  ToneMap toneMap;                ///< that of the first part
  bool isMoving = false;          ///< a preview of what would take longer than PreviewTime will do
  bool isRefined = false;         ///< refine() will be called when the view rests
  /// Gets the fraction done; false aborts the picture. Not asked while the view moves.
  std::function<bool(double)> progress;
  /// Whether a picture that only betters the last one has to wait, because the view is used.
  std::function<bool()> hasToWait;
};

/// The picture of all particles in a view, in one depth order, kept until something changes that it
/// depends on: light is exposed without it, and other brightnesses and colours of what only emits
/// are sums of pictures that are kept.
class SplatPicture
{
public:
  /// Computes the picture unless it is there; of several parts the first says the kernel, and the
  /// most accurate the accuracy. Where it is aborted, what was shown of this scene stays, or there
  /// is a preview. Throws where particles lack an array.
  void update(const std::vector<SplatPart>& parts, SplatRequest request);

  /// What update() made.
  const RenderedImage& image() const { return *this->last.image; }

  /// Whether somebody aborted the last picture asked for.
  bool isAborted() const { return this->aborted; }

  /// Lets the next picture of a view that rests be a better one, of four times the time and at last
  /// of all particles. False if there is none.
  bool refine();

private:
  /// What a picture shows, but for its light and how exact it is.
  struct Scene
  {
    Camera camera;
    std::vector<float> opaqueDepth;
    std::vector<double> parts; ///< their versions, kernel and component tables

    bool operator==(const Scene& other) const;
  };
  /// All that a picture depends on.
  struct State
  {
    Scene scene;
    LightGains gains; ///< with the exposures relative to the first part's
    Accuracy accuracy = Accuracy::Bounded;
    double slices = 0;  ///< Overlapping
    ErrorBound needed;  ///< no larger an error can be seen
    ErrorBound allowed; ///< that of the picture, less
    double seconds = 0; ///< that it may take; 0: however long
    std::shared_ptr<const RenderedImage> image = std::make_shared<RenderedImage>();

    bool isOfScene(const State& other) const;
    bool servesFor(const State& other) const;
  };

  RenderOptions optionsOf(const std::vector<SplatPart>& parts) const;
  State stateOf(const std::vector<SplatPart>& parts, const RenderOptions& options) const;
  ParticleView view(const std::vector<SplatPart>& parts, std::vector<ParticleInput>& inputs);
  double nextSeconds(const SplatRequest& request, const RenderOptions& options, const State& next);
  bool isDrawn(const State& next) const;
  void draw(const ParticleView& particles, const RenderOptions& options, State& next);
  void giveUp(const ParticleView& particles, const RenderOptions& options, State& next);

  State last;
  State drawn; ///< what the light groups are of
  LightGroups groups;
  RenderMemory memory;
  Preview preview;
  std::unique_ptr<JointParticles> joint; ///< of several parts
  std::vector<double> versions; ///< of the parts drawn, and of colours that joint ones keep
  std::uint64_t version = 0;    ///< another one whenever these are others
  double fullSeconds = 0;       ///< what the last picture of all particles took
  double seconds = 0;           ///< what the picture shown was to take; 0: it is of all particles
  bool isAwaited = false;       ///< a better one will be asked for
  bool aborted = false;         ///< the last one asked for
};
} // namespace galaxy

#endif
