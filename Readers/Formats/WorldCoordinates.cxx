#include "Readers/Formats/WorldCoordinates.h"

#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/ClassicLocale.h"
#include "Readers/Formats/CoordinateCards.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/HeaderFrame.h"
#include "Readers/Formats/NoCoordinates.h"

#include <wcslib/wcs.h>
#include <wcslib/wcsfix.h>
#include <wcslib/wcshdr.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>

namespace galaxy
{
namespace
{
// WCSLIB's header parser and its fixes keep state between calls.
std::mutex wcslibMutex;

/// A wcsprm that frees what WCSLIB allocated for it. WCSLIB writes into it even when it only
/// converts.
struct Description
{
  mutable wcsprm wcs;

  Description() { this->wcs.flag = -1; }
  ~Description() { wcsfree(&this->wcs); }
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;
};

/// What wcspih found in a header.
struct HeaderDescriptions
{
  int count = 0;
  wcsprm* all = nullptr;
  int status = 0;

  explicit HeaderDescriptions(std::string cards)
  {
    int rejected = 0;
    this->status = wcspih(cards.data(), static_cast<int>(cards.size() / FitsHeader::cardLength),
      WCSHDR_all, 0, &rejected, &this->count, &this->all);
  }
  ~HeaderDescriptions() { wcsvfree(&this->count, &this->all); }
  HeaderDescriptions(const HeaderDescriptions&) = delete;
  HeaderDescriptions& operator=(const HeaderDescriptions&) = delete;
};

/// A position in the header's own frame, and on the projection's own sphere.
struct WorldPosition
{
  SkyPosition sky;
  double phi = 0, theta = 0;
};

} // namespace

struct WorldCoordinates::State
{
  Description description;
  CelestialFrame frame = CelestialFrame::icrs();

  /// Null where WCSLIB rejects the cards, saying why, or finds no celestial axes.
  static std::unique_ptr<State> of(
    const std::string& cards, int width, int height, std::string& rejection);
  /// Null where the header has none.
  static std::unique_ptr<State> ofPlate(
    const std::string& file, const CoordinateCards& cards, int width, int height);
  /// The first of the descriptions that has celestial axes. Throws Error where there is none.
  static std::unique_ptr<State> ofAxes(
    const std::string& file, const CoordinateCards& cards, int width, int height);

  bool toWorld(const PixelPosition& pixel, WorldPosition& world) const;
  bool toPixel(const SkyPosition& world, PixelPosition& pixel) const;
  bool comesBack(const PixelPosition& pixel, const WorldPosition& world) const;
  bool refines(const State& other, int width, int height) const;
};

std::unique_ptr<WorldCoordinates::State> WorldCoordinates::State::of(
  const std::string& cards, int width, int height, std::string& rejection)
{
  const std::lock_guard<std::mutex> lock(wcslibMutex);
  const ClassicLocale classic;
  const HeaderDescriptions found(cards);
  if (found.status != 0 || found.count == 0)
  {
    rejection = found.status == 0 ? "no axes" : wcshdr_errmsg[found.status];
    return nullptr;
  }
  auto state = std::make_unique<State>();
  wcsprm& wcs = state->description.wcs;
  int status = wcssub(1, found.all, nullptr, nullptr, &wcs);
  if (status == 0)
  {
    const std::array<int, 2> size = { width, height };
    std::array<int, NWCSFIX> fixes;
    constexpr int translateUnits = 7;
    wcsfix(translateUnits, size.data(), &wcs, fixes.data());
    status = wcsset(&wcs);
  }
  if (status != 0)
  {
    rejection = wcs_errmsg[status];
  }
  return status == 0 && wcs.lng >= 0 && wcs.lat >= 0 ? std::move(state) : nullptr;
}

std::unique_ptr<WorldCoordinates::State> WorldCoordinates::State::ofPlate(
  const std::string& file, const CoordinateCards& cards, int width, int height)
{
  const std::string plate = cards.plate();
  std::string rejection;
  std::unique_ptr<State> state = plate.empty() ? nullptr : of(plate, width, height, rejection);
  if (state)
  {
    state->frame = frameOfHeader(file, cards.header(), "", state->description.wcs.lngtyp);
  }
  return state;
}

std::unique_ptr<WorldCoordinates::State> WorldCoordinates::State::ofAxes(
  const std::string& file, const CoordinateCards& cards, int width, int height)
{
  std::string rejection;
  std::optional<Error> refusal;
  for (const std::string& version : cards.versions())
  {
    try
    {
      if (auto state = of(cards.axesOf(version), width, height, rejection))
      {
        state->frame = frameOfHeader(file, cards.header(), version, state->description.wcs.lngtyp);
        return state;
      }
    }
    catch (const Error& error)
    {
      refusal = refusal ? refusal : error;
    }
  }
  if (refusal)
  {
    throw Error(*refusal);
  }
  throw NoCoordinates(file, "CTYPE",
    "the image axes" + cards.types() + " have no usable celestial coordinates" +
      (rejection.empty() ? "" : " (WCSLIB: " + rejection + ")"));
}

// Axes fitted to a plate solution follow it to half a pixel. Programs that cut, bin or turn the
// image rewrite the axes and leave the plate's keywords as they were.
bool WorldCoordinates::State::refines(const State& other, int width, int height) const
{
  constexpr double pixels = 3;
  for (const PixelPosition& corner : { PixelPosition{ 1, 1 }, { double(width), 1 },
         { 1, double(height) }, { double(width), double(height) } })
  {
    WorldPosition world;
    PixelPosition back;
    if (!other.toWorld(corner, world) ||
      !this->toPixel(this->frame.fromIcrs(other.frame.toIcrs(world.sky)), back) ||
      !(std::hypot(back.x - corner.x, back.y - corner.y) < pixels))
    {
      return false;
    }
  }
  return true;
}

WorldCoordinates::WorldCoordinates(const std::string& file, const std::string& cards, int width,
  int height, const std::array<int, 2>& axes)
{
  const CoordinateCards found(file, cards, axes);
  std::unique_ptr<State> plate = State::ofPlate(file, found, width, height);
  try
  {
    this->state = State::ofAxes(file, found, width, height);
  }
  catch (const Error&)
  {
    if (!plate)
    {
      throw;
    }
  }
  if (plate && (!this->state || plate->refines(*this->state, width, height)))
  {
    this->state = std::move(plate);
  }
}

WorldCoordinates::WorldCoordinates(const SuppliedCoordinates& supplied, int width, int height)
  : state(std::make_unique<State>())
{
  if (!(supplied.pixelScale > 0))
  {
    throw Error("supplied coordinates", "pixel_scale", "must be greater than 0");
  }
  const std::lock_guard<std::mutex> lock(wcslibMutex);
  wcsprm& wcs = this->state->description.wcs;
  wcsini(1, 2, &wcs);
  std::snprintf(wcs.ctype[0], sizeof wcs.ctype[0], "RA---TAN");
  std::snprintf(wcs.ctype[1], sizeof wcs.ctype[1], "DEC--TAN");
  const bool middle = supplied.pixel.x == 0 && supplied.pixel.y == 0;
  wcs.crpix[0] = middle ? 0.5 * (width + 1) : supplied.pixel.x;
  wcs.crpix[1] = middle ? 0.5 * (height + 1) : supplied.pixel.y;
  wcs.crval[0] = supplied.centre.ra;
  wcs.crval[1] = supplied.centre.dec;
  wcs.cdelt[0] = wcs.cdelt[1] = supplied.pixelScale / 3600;
  // Columns of the PC matrix: the directions (East, North) of the image's +x and +y.
  const double pa = supplied.positionAngle * std::acos(-1.0) / 180;
  const double right = supplied.mirrored ? 1 : -1;
  wcs.pc[0] = right * std::cos(pa);
  wcs.pc[1] = std::sin(pa);
  wcs.pc[2] = -right * std::sin(pa);
  wcs.pc[3] = std::cos(pa);
  const int status = wcsset(&wcs);
  if (status != 0)
  {
    throw Error("supplied coordinates", "ra, dec, pixel_scale",
      std::string(wcs_errmsg[status]) + "; correct them");
  }
}

WorldCoordinates::~WorldCoordinates() = default;
WorldCoordinates::WorldCoordinates(WorldCoordinates&&) noexcept = default;
WorldCoordinates& WorldCoordinates::operator=(WorldCoordinates&&) noexcept = default;

bool WorldCoordinates::State::toWorld(const PixelPosition& pixel, WorldPosition& world) const
{
  wcsprm* const wcs = &this->description.wcs;
  std::array<double, 2> pixels = { pixel.x, pixel.y };
  std::array<double, 2> intermediate{}, worlds{};
  const auto isFound = [&] {
    int invalid = 0;
    return wcsp2s(wcs, 1, 2, pixels.data(), intermediate.data(), &world.phi, &world.theta,
             worlds.data(), &invalid) == 0 &&
      invalid == 0;
  };
  bool found = isFound();
  if (found && std::isnan(world.theta))
  {
    // WCSLIB 7.12 divides 0 by 0 on the straight meridian of PCO.
    constexpr double beside = 1e-7; // pixel
    pixels = { pixel.x + beside, pixel.y + 2 * beside };
    found = isFound();
  }
  world.sky = { worlds[wcs->lng], worlds[wcs->lat] };
  return found && std::isfinite(world.sky.ra) && std::fabs(world.sky.dec) <= 90;
}

bool WorldCoordinates::State::toPixel(const SkyPosition& world, PixelPosition& pixel) const
{
  wcsprm* const wcs = &this->description.wcs;
  std::array<double, 2> worlds, intermediate, pixels;
  worlds[wcs->lng] = world.ra;
  worlds[wcs->lat] = world.dec;
  double phi, theta;
  int invalid = 0;
  if (wcss2p(wcs, 1, 2, worlds.data(), &phi, &theta, intermediate.data(), pixels.data(),
        &invalid) != 0 ||
    invalid != 0)
  {
    return false;
  }
  pixel = { pixels[0], pixels[1] };
  return std::isfinite(pixel.x) && std::isfinite(pixel.y);
}

// A distortion that folds the image, or a projection beyond its own edge, puts a pixel somewhere
// that is seen elsewhere. At a projection's seam and poles several pixels see one place rightly.
bool WorldCoordinates::State::comesBack(
  const PixelPosition& pixel, const WorldPosition& world) const
{
  constexpr double tiny = 1e-9; // degree
  if (std::fabs(world.phi) > 180 - tiny || std::fabs(world.theta) > 90 - tiny)
  {
    return true;
  }
  constexpr double near = 0.1; // pixel; the cube's inverse is that good
  PixelPosition back;
  return this->toPixel(world.sky, back) && std::hypot(back.x - pixel.x, back.y - pixel.y) < near;
}

bool WorldCoordinates::pixelToSky(const PixelPosition& pixel, SkyPosition& sky) const
{
  WorldPosition world;
  if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y) || !this->state->toWorld(pixel, world) ||
    !this->state->comesBack(pixel, world))
  {
    return false;
  }
  sky = this->state->frame.toIcrs(world.sky);
  return std::isfinite(sky.ra) && std::isfinite(sky.dec);
}

bool WorldCoordinates::skyToPixel(const SkyPosition& sky, PixelPosition& pixel) const
{
  return std::isfinite(sky.ra) && std::fabs(sky.dec) <= 90 &&
    this->state->toPixel(this->state->frame.fromIcrs(sky), pixel);
}
} // namespace galaxy
