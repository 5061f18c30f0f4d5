#include "Readers/Formats/WorldCoordinates.h"

#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/CoordinateCards.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/HeaderCards.h"

#include <wcslib/wcs.h>
#include <wcslib/wcsfix.h>
#include <wcslib/wcshdr.h>
#include <wcslib/wcsmath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <mutex>

namespace galaxy
{
namespace
{
constexpr std::size_t cardLength = 80;

// WCSLIB's header parser and its fixes keep state between calls.
std::mutex wcslibMutex;

/// A wcsprm that frees what WCSLIB allocated for it.
struct Description
{
  wcsprm wcs;

  Description() { this->wcs.flag = -1; }
  ~Description() { wcsfree(&this->wcs); }
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;
};

/// What wcspih found in a header: the primary and the alternate descriptions.
struct HeaderDescriptions
{
  int count = 0;
  wcsprm* all = nullptr;

  explicit HeaderDescriptions(std::string& cards)
  {
    int rejected = 0;
    wcspih(cards.data(), static_cast<int>(cards.size() / cardLength), WCSHDR_all, 0, &rejected,
      &this->count, &this->all);
  }
  ~HeaderDescriptions() { wcsvfree(&this->count, &this->all); }
  HeaderDescriptions(const HeaderDescriptions&) = delete;
  HeaderDescriptions& operator=(const HeaderDescriptions&) = delete;
};

const std::string cure = "; give `ra`, `dec` and `pixel_scale` for this image in the .galaxy file";

/// After wcsset, which fills in RADESYS and the equinox as the FITS standard has it.
CelestialFrame frameOf(const std::string& file, const wcsprm& wcs)
{
  const std::string longitude = wcs.lngtyp;
  const std::string system = wcs.radesys;
  if (longitude == "GLON")
  {
    return CelestialFrame::galactic();
  }
  if (longitude == "ELON")
  {
    return CelestialFrame::ecliptic(undefined(wcs.equinox) ? 2000 : wcs.equinox);
  }
  if (longitude != "RA")
  {
    throw Error(file, "CTYPE", "the celestial frame of " + longitude + " is not supported" + cure);
  }
  if (system == "ICRS")
  {
    return CelestialFrame::icrs();
  }
  if (system == "FK4")
  {
    return CelestialFrame::fk4(undefined(wcs.equinox) ? 1950 : wcs.equinox);
  }
  if (system == "FK4-NO-E")
  {
    return CelestialFrame::fk4WithoutETerms(undefined(wcs.equinox) ? 1950 : wcs.equinox);
  }
  if (system == "GAPPT")
  {
    throw Error(file, "RADESYS", "apparent places (GAPPT) are not supported" + cure);
  }
  return CelestialFrame::fk5(undefined(wcs.equinox) ? 2000 : wcs.equinox);
}

/// Fixes the axes that are not the image's at their first pixel: what the linear part adds for
/// them goes into the reference pixel, so that the image's two axes stand alone.
void fixOtherAxes(wcsprm& wcs, const std::array<int, 2>& axes)
{
  double* const m = (wcs.altlin & 3) == 2 ? wcs.cd : wcs.pc; // as wcsset prefers them
  const auto at = [&](int row, int column) -> double& { return m[row * wcs.naxis + column]; };
  const int x = axes[0] - 1, y = axes[1] - 1;
  double shiftX = 0, shiftY = 0;
  for (int other = 0; other < wcs.naxis; ++other)
  {
    if (other != x && other != y)
    {
      const double step = 1 - wcs.crpix[other];
      shiftX += at(x, other) * step;
      shiftY += at(y, other) * step;
      at(x, other) = at(y, other) = at(other, x) = at(other, y) = 0;
    }
  }
  const double determinant = at(x, x) * at(y, y) - at(x, y) * at(y, x);
  if (determinant != 0)
  {
    wcs.crpix[x] -= (at(y, y) * shiftX - at(x, y) * shiftY) / determinant;
    wcs.crpix[y] -= (at(x, x) * shiftY - at(y, x) * shiftX) / determinant;
  }
}

/// The description of the image's two axes alone. Returns WCSLIB's status.
int keepImageAxes(wcsprm& from, std::array<int, 2> axes, wcsprm& to)
{
  if (from.naxis <= 2)
  {
    return wcssub(1, &from, nullptr, nullptr, &to);
  }
  if (std::max(axes[0], axes[1]) > from.naxis)
  {
    return 0; // not described: no celestial axes
  }
  fixOtherAxes(from, axes);
  int count = 2;
  return wcssub(1, &from, &count, axes.data(), &to);
}

/// Sets up a description of two axes for use. Returns WCSLIB's status.
int setUp(wcsprm& wcs, bool epochIsNoEquinox, int width, int height)
{
  // An equinox of 0 is what some programs write where they know none.
  if (epochIsNoEquinox || wcs.equinox <= 0)
  {
    wcs.equinox = UNDEFINED;
  }
  const std::array<int, 2> size = { width, height };
  std::array<int, NWCSFIX> fixes;
  constexpr int translateUnits = 7;
  wcsfix(translateUnits, size.data(), &wcs, fixes.data());
  return wcsset(&wcs);
}
} // namespace

struct WorldCoordinates::State
{
  Description description;
  CelestialFrame frame = CelestialFrame::icrs();

  void read(const std::string& file, const std::string& cards, int width, int height,
    const std::array<int, 2>& axes);
};

void WorldCoordinates::State::read(const std::string& file, const std::string& cards, int width,
  int height, const std::array<int, 2>& axes)
{
  const std::lock_guard<std::mutex> lock(wcslibMutex);
  std::string header = repairedCoordinateCards(cards);
  const HeaderDescriptions found(header);
  wcsprm& wcs = this->description.wcs;
  std::string rejection;
  for (int i = 0; i < found.count; ++i)
  {
    wcsfree(&wcs);
    wcs.flag = -1;
    int status = keepImageAxes(found.all[i], axes, wcs);
    if (status == 0 && wcs.flag != -1)
    {
      status = setUp(wcs, epochIsPlateDate(cards), width, height);
    }
    if (status == 0 && wcs.flag != -1 && wcs.lng >= 0 && wcs.lat >= 0)
    {
      this->frame = frameOf(file, wcs);
      return;
    }
    if (status != 0 && rejection.empty())
    {
      rejection = std::string(" (WCSLIB: ") + wcs_errmsg[status] + ")";
    }
  }
  const std::string axis = "CTYPE" + std::to_string(axes[0]);
  if (cardValue(header, axis).find("-TAB") != std::string::npos)
  {
    throw Error(file, axis, "tabulated coordinates (-TAB) are not supported" + cure);
  }
  throw Error(
    file, "CTYPE", "the image axes have no usable celestial coordinates" + rejection + cure);
}

WorldCoordinates::WorldCoordinates(const std::string& file, const std::string& cards, int width,
  int height, const std::array<int, 2>& axes)
  : state(std::make_unique<State>())
{
  this->state->read(file, cards, width, height, axes);
  if (hasPlateSolutionBesideAxes(cards))
  {
    WorldCoordinates own(file, withoutPlateSolution(cards), width, height, axes);
    if (!this->refines(own, width, height))
    {
      *this = std::move(own);
    }
  }
}

// Axes fitted to a plate solution follow it to half a pixel. Programs that cut, bin or turn the
// image rewrite the axes and leave the plate's keywords as they were.
bool WorldCoordinates::refines(const WorldCoordinates& other, int width, int height) const
{
  constexpr double pixels = 3;
  for (const PixelPosition& corner : { PixelPosition{ 1, 1 }, { double(width), 1 },
         { 1, double(height) }, { double(width), double(height) } })
  {
    SkyPosition sky;
    PixelPosition back;
    if (!other.pixelToSky(corner, sky) || !this->skyToPixel(sky, back) ||
      !(std::hypot(back.x - corner.x, back.y - corner.y) < pixels))
    {
      return false;
    }
  }
  return true;
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

bool WorldCoordinates::pixelToSky(const PixelPosition& pixel, SkyPosition& sky) const
{
  if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y))
  {
    return false;
  }
  wcsprm& wcs = this->state->description.wcs;
  const std::array<double, 2> pixels = { pixel.x, pixel.y };
  std::array<double, 2> intermediate, world;
  double phi, theta;
  int invalid = 0;
  if (wcsp2s(&wcs, 1, 2, pixels.data(), intermediate.data(), &phi, &theta, world.data(),
        &invalid) != 0 ||
    invalid != 0)
  {
    return false;
  }
  sky = this->state->frame.toIcrs({ world[wcs.lng], world[wcs.lat] });
  return true;
}

bool WorldCoordinates::skyToPixel(const SkyPosition& sky, PixelPosition& pixel) const
{
  if (!std::isfinite(sky.ra) || !std::isfinite(sky.dec) || std::fabs(sky.dec) > 90)
  {
    return false;
  }
  wcsprm& wcs = this->state->description.wcs;
  const SkyPosition local = this->state->frame.fromIcrs(sky);
  std::array<double, 2> world, intermediate, pixels;
  world[wcs.lng] = local.ra;
  world[wcs.lat] = local.dec;
  double phi, theta;
  int invalid = 0;
  if (wcss2p(&wcs, 1, 2, world.data(), &phi, &theta, intermediate.data(), pixels.data(),
        &invalid) != 0 ||
    invalid != 0 || !std::isfinite(pixels[0]) || !std::isfinite(pixels[1]))
  {
    return false;
  }
  pixel = { pixels[0], pixels[1] };
  return true;
}
} // namespace galaxy
