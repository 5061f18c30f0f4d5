#include "Readers/Formats/WorldCoordinates.h"

#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/Error.h"

#include <wcslib/wcs.h>
#include <wcslib/wcsfix.h>
#include <wcslib/wcshdr.h>
#include <wcslib/wcsmath.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
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

/// The value field of the first card with this keyword, as text; empty where there is none.
std::string cardValue(const std::string& cards, const std::string& keyword)
{
  const std::string start = (keyword + "        ").substr(0, 8) + "=";
  for (std::size_t at = 0; at + cardLength <= cards.size(); at += cardLength)
  {
    if (cards.compare(at, start.size(), start) == 0)
    {
      return cards.substr(at + start.size(), cardLength - start.size());
    }
  }
  return "";
}

/// CTYPE in capitals, as the FITS standard has it and WCSLIB insists.
std::string withCapitalTypes(std::string cards)
{
  for (std::size_t at = 0; at + cardLength <= cards.size(); at += cardLength)
  {
    if (cards.compare(at, 5, "CTYPE") == 0)
    {
      const auto open = cards.begin() + at;
      std::transform(open, open + cardLength, open,
        [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
  }
  return cards;
}

/// The retired EPOCH keyword was used both for the equinox and for the date of the exposure. Beside
/// EQUINOX or RADESYS it decides nothing; alone it is an equinox where it is one of those that
/// coordinates were published for, a multiple of 25 years (1900, 1950, 1975, 2000), and otherwise a
/// date, on a plate whose coordinates are then J2000.
bool epochIsPlateDate(const std::string& cards)
{
  const std::string epoch = cardValue(cards, "EPOCH");
  if (epoch.empty() || !cardValue(cards, "EQUINOX").empty() ||
    !cardValue(cards, "RADESYS").empty() || !cardValue(cards, "RADECSYS").empty())
  {
    return false;
  }
  const std::size_t digit = epoch.find_first_of("0123456789");
  const double year = digit == std::string::npos ? 0 : std::atof(epoch.c_str() + digit);
  return std::fmod(year, 25.0) != 0;
}

CelestialFrame frameOf(const std::string& file, const wcsprm& wcs, bool plateDate)
{
  const std::string longitude = wcs.lngtyp;
  if (longitude == "GLON")
  {
    return CelestialFrame::galactic();
  }
  if (longitude == "ELON")
  {
    return CelestialFrame::ecliptic();
  }
  if (longitude != "RA")
  {
    throw Error(file, "CTYPE", "the celestial frame of " + longitude + " is not supported");
  }
  const std::string system = wcs.radesys;
  const bool hasEquinox = !undefined(wcs.equinox);
  if (plateDate || system == "ICRS")
  {
    return CelestialFrame::icrs();
  }
  if (system == "FK4" || system == "FK4-NO-E")
  {
    return CelestialFrame::fk4(hasEquinox ? wcs.equinox : 1950);
  }
  return CelestialFrame::fk5(hasEquinox ? wcs.equinox : 2000);
}

/// The image axes of a description with more than two, which must be its celestial ones.
int keepImageAxes(const wcsprm& from, wcsprm& to)
{
  if (from.naxis <= 2)
  {
    return wcssub(1, &from, nullptr, nullptr, &to);
  }
  int count = 2;
  std::array<int, 2> axes = { 1, 2 };
  return wcssub(1, &from, &count, axes.data(), &to);
}
} // namespace

struct WorldCoordinates::State
{
  Description description;
  CelestialFrame frame = CelestialFrame::icrs();
};

WorldCoordinates::WorldCoordinates(
  const std::string& file, const std::string& cards, int width, int height)
  : state(std::make_unique<State>())
{
  const std::lock_guard<std::mutex> lock(wcslibMutex);
  std::string header = withCapitalTypes(cards);
  const HeaderDescriptions found(header);
  wcsprm& wcs = this->state->description.wcs;
  std::string rejection;
  for (int i = 0; i < found.count; ++i)
  {
    wcsfree(&wcs);
    wcs.flag = -1;
    int status = keepImageAxes(found.all[i], wcs);
    if (status == 0)
    {
      const std::array<int, 2> size = { width, height };
      std::array<int, NWCSFIX> fixes;
      constexpr int translateUnits = 7;
      wcsfix(translateUnits, size.data(), &wcs, fixes.data());
      status = wcsset(&wcs);
    }
    if (status == 0 && wcs.lng >= 0 && wcs.lat >= 0)
    {
      this->state->frame = frameOf(file, wcs, epochIsPlateDate(cards));
      return;
    }
    if (status != 0 && rejection.empty())
    {
      rejection = std::string(" (WCSLIB: ") + wcs_errmsg[status] + ")";
    }
  }
  throw Error(file, "CTYPE",
    "the image axes have no usable celestial coordinates" + rejection +
      "; give `ra`, `dec` and `pixel_scale` for this image in the .galaxy file");
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
    throw Error("supplied coordinates", "", wcs_errmsg[status]);
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
