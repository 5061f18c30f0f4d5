#include "Readers/Formats/FitsFile.h"
#include "Testing/Cxx/FitsFixtures.h"

#include <fitsio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

using galaxy::FitsSelection;
using galaxy::Image;
using galaxy::readFitsImage;

namespace
{
using FitsCube = galaxy::testing::FitsFolder;
using galaxy::testing::addImage;
using galaxy::testing::contains;
using galaxy::testing::messageOf;

constexpr double speedOfLight = 299792.458;
constexpr double blank = std::numeric_limits<double>::quiet_NaN();

/// The values 0, 1, 2, ... in the file's order.
std::vector<double> counted(const std::vector<long>& axes)
{
  std::size_t count = 1;
  for (const long n : axes)
  {
    count *= static_cast<std::size_t>(n);
  }
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = static_cast<double>(i);
  }
  return values;
}

using Keywords = std::vector<std::pair<std::string, double>>;

void setTypes(fitsfile* file, const std::vector<std::string>& types, int* status)
{
  for (std::size_t i = 0; i < types.size(); ++i)
  {
    const std::string keyword = "CTYPE" + std::to_string(i + 1);
    fits_update_key_str(file, keyword.c_str(), types[i].c_str(), nullptr, status);
  }
}

/// RA, DEC and a spectral axis, 2 by 1 by the rest of the values.
void addSpectra(fitsfile* file, const std::vector<double>& values, const std::string& type,
  const std::string& unit, const Keywords& keywords, int* status)
{
  addImage(file, DOUBLE_IMG, values, status, { 2, 1, static_cast<long>(values.size() / 2) });
  setTypes(file, { "RA---SIN", "DEC--SIN", type }, status);
  if (!unit.empty())
  {
    fits_update_key_str(file, "CUNIT3", unit.c_str(), nullptr, status);
  }
  for (const auto& [name, value] : keywords)
  {
    fits_update_key_dbl(file, name.c_str(), value, 15, nullptr, status);
  }
  fits_update_key_str(file, "BUNIT", "Jy/beam", nullptr, status);
}

FitsSelection velocities(double from, double to)
{
  FitsSelection selection;
  selection.velocityRange = { from, to };
  return selection;
}
} // namespace

TEST_F(FitsCube, ImagePlaneIsCelestialInAnyOrderOfAxes)
{
  const std::vector<long> axes = { 3, 4, 5, 2 };
  const std::string file = this->write("order.fits", [&](fitsfile* f, int* status) {
    addImage(f, LONG_IMG, counted(axes), status, axes);
    setTypes(f, { "FREQ", "DEC--SIN", "RA---SIN", "STOKES" }, status);
  });
  FitsSelection selection;
  for (int plane = 0; plane < 6; ++plane)
  {
    selection.plane = plane;
    const Image image = readFitsImage(file, selection);
    ASSERT_EQ(image.width, 4);
    ASSERT_EQ(image.height, 5);
    EXPECT_EQ(image.axes, (std::array<int, 2>{ 2, 3 }));
    for (int y = 0; y < 5; ++y)
    {
      for (int x = 0; x < 4; ++x)
      {
        EXPECT_EQ(image.at(x, y), plane % 3 + 3 * x + 12 * y + 60 * (plane / 3));
      }
    }
  }
  selection.plane = 6;
  EXPECT_TRUE(contains(messageOf(file, selection), "6 planes"));
}

TEST_F(FitsCube, ImagePlaneOfCelestialPairsOnly)
{
  const std::vector<long> axes = { 2, 3, 4 };
  const auto axesOf = [&](const std::string& name, const std::vector<std::string>& types) {
    return readFitsImage(this->write(name + ".fits",
                           [&](fitsfile* f, int* status) {
                             addImage(f, SHORT_IMG, counted(axes), status, axes);
                             setTypes(f, types, status);
                           }))
      .axes;
  };
  using Pair = std::array<int, 2>;
  EXPECT_EQ(axesOf("none", {}), (Pair{ 1, 2 }));
  EXPECT_EQ(axesOf("ra", { "VELO-LSR", "STOKES", "RA---SIN" }), (Pair{ 1, 2 }));
  EXPECT_EQ(axesOf("galactic", { "GLON-CAR", "VRAD", "GLAT-CAR" }), (Pair{ 1, 3 }));
  EXPECT_EQ(axesOf("mixed", { "VRAD", "GLAT-CAR", "RA---CAR" }), (Pair{ 1, 2 }));
  EXPECT_EQ(axesOf("planet", { "VRAD", "MELT-TAN", "MELN-TAN" }), (Pair{ 2, 3 }));
}

// Long enough to be read in many parts, with the summed axis fastest, between and slowest.
TEST_F(FitsCube, MeanDoesNotDependOnTheOrderOfAxes)
{
  const std::vector<std::vector<std::string>> orders = { { "VRAD", "RA---TAN", "DEC--TAN" },
    { "RA---TAN", "VRAD", "DEC--TAN" }, { "RA---TAN", "DEC--TAN", "VRAD" } };
  FitsSelection selection;
  selection.planes = { 10, 249 };
  for (std::size_t summed = 0; summed < 3; ++summed)
  {
    std::vector<long> axes = { 70, 90 };
    axes.insert(axes.begin() + static_cast<long>(summed), 260);
    const std::string name = "mean" + std::to_string(summed) + ".fits";
    const Image image = readFitsImage(this->write(name,
                                        [&](fitsfile* f, int* status) {
                                          addImage(f, DOUBLE_IMG, counted(axes), status, axes);
                                          setTypes(f, orders[summed], status);
                                        }),
      selection);
    const double xStep = summed == 0 ? 260 : 1;
    const double yStep = summed == 2 ? 70 : 70 * 260;
    const double step = summed == 0 ? 1 : summed == 1 ? 70 : 70 * 90;
    ASSERT_EQ(image.width, 70);
    ASSERT_EQ(image.height, 90);
    for (int y = 0; y < 90; ++y)
    {
      for (int x = 0; x < 70; ++x)
      {
        ASSERT_EQ(image.at(x, y), x * xStep + y * yStep + step * 129.5) << x << " " << y;
      }
    }
  }
}

TEST_F(FitsCube, MeanLeavesBlankPixelsOut)
{
  const std::string file = this->write("blank.fits", [](fitsfile* f, int* status) {
    addImage(f, DOUBLE_IMG, { 1, 2, blank, 4, blank, 6, blank, -99, blank }, status, { 3, 1, 3 });
  });
  FitsSelection selection;
  selection.planes = { 0, 2 };
  selection.maskValues = { -99 };
  const Image image = readFitsImage(file, selection);
  EXPECT_EQ(image.at(0, 0), 2.5);
  EXPECT_EQ(image.at(1, 0), 2);
  EXPECT_EQ(image.at(2, 0), 6);
  selection.planes = { 2, 2 };
  EXPECT_TRUE(std::isnan(readFitsImage(file, selection).at(0, 0)));
}

// Planes 1 to 4 of axes 3 and 4 of lengths 3 and 2: two of the first, two of the second.
TEST_F(FitsCube, MeanAcrossTwoFurtherAxes)
{
  const std::vector<long> axes = { 2, 1, 3, 2 };
  const std::string file = this->write("two.fits",
    [&](fitsfile* f, int* status) { addImage(f, DOUBLE_IMG, counted(axes), status, axes); });
  FitsSelection selection;
  selection.planes = { 1, 4 };
  EXPECT_EQ(readFitsImage(file, selection).values, (std::vector<double>{ 5, 6 }));
  selection.planes = { 4, 1 };
  EXPECT_TRUE(contains(messageOf(file, selection), "the first must not be after the last"));
  selection.planes = { 0, 6 };
  EXPECT_TRUE(contains(messageOf(file, selection), "plane 6: out of range"));
}

TEST_F(FitsCube, MomentOverVelocities)
{
  const std::vector<double> values = { 1, 10, 2, blank, 3, blank, 4, 40 };
  const Keywords metres = { { "CRVAL3", 500e3 }, { "CRPIX3", 1 }, { "CDELT3", -5e3 } };
  const Keywords kilometres = { { "CRVAL3", 500 }, { "CRPIX3", 1 }, { "CDELT3", -5 } };
  // The matrix under its old names, of six digits.
  const Keywords oldMatrix = { { "CRVAL3", 500e3 }, { "CRPIX3", 1 }, { "CDELT3", 5e3 },
    { "PC003003", -1 } };
  const Keywords oldSteps = { { "CRVAL3", 500e3 }, { "CRPIX3", 1 }, { "CDELT3", 1 },
    { "CD003003", -5e3 } };
  int number = 0;
  for (const auto& [type, unit, keywords] :
    { std::tuple("VELO-HEL", "m/s", metres), std::tuple("VRAD", "", metres),
      std::tuple("VOPT", "km/s", kilometres), std::tuple("VELO", "KM/S", kilometres),
      std::tuple("VRAD", "km/sec", kilometres), std::tuple("VRAD", "M.S**-1", metres),
      std::tuple("VRAD", "m/s", oldMatrix), std::tuple("VRAD", "m/s", oldSteps) })
  {
    const std::string name = "velocity" + std::to_string(number++) + ".fits";
    const std::string file =
      this->write(name, [&, t = type, u = unit, &k = keywords](fitsfile* f, int* status) {
        addSpectra(f, values, t, u, k, status);
      });
    // Channels at 500, 495, 490 and 485 km/s.
    const Image two = readFitsImage(file, velocities(489, 496));
    EXPECT_EQ(two.at(0, 0), 5 * (2 + 3)) << type;
    EXPECT_TRUE(std::isnan(two.at(1, 0))) << "blank in every channel";
    EXPECT_EQ(two.unit, "Jy/beam km/s");
    EXPECT_EQ(readFitsImage(file, velocities(500, 485)).values, (std::vector<double>{ 50, 250 }));
    EXPECT_TRUE(contains(messageOf(file, velocities(486, 489)), "no channel lies in it"));
  }
}

TEST_F(FitsCube, MomentOverFrequenciesByTheRadioConvention)
{
  const double rest = 1.420405752e9;
  const double step = -20e3;
  const std::string file = this->write("frequency.fits", [&](fitsfile* f, int* status) {
    addSpectra(f, { 1, 2, 3, 4, 5, 6 }, "FREQ", "Hz",
      { { "CRVAL3", rest }, { "CRPIX3", 1 }, { "CDELT3", step }, { "RESTFRQ", rest } }, status);
  });
  const double width = speedOfLight * 20e3 / rest; // 4.22 km/s
  const Image image = readFitsImage(file, velocities(width - 0.01, 2 * width + 0.01));
  EXPECT_NEAR(image.at(0, 0), width * (3 + 5), 1e-9);
  const std::string without = this->write("norest.fits", [&](fitsfile* f, int* status) {
    addSpectra(f, { 1, 2, 3, 4 }, "FREQ", "Hz", { { "CRVAL3", rest }, { "CDELT3", step } }, status);
  });
  EXPECT_TRUE(contains(messageOf(without, velocities(0, 100)), "RESTFRQ"));
}

// c (nu_0 / nu - 1) at frequencies equally far apart; the widths grow with velocity.
TEST_F(FitsCube, MomentOverOpticalVelocitiesLinearInFrequency)
{
  const double v = 30000;
  const double u = 1 / (1 + v / speedOfLight);
  const double step = 5e-4;
  const std::string file = this->write("optical.fits", [&](fitsfile* f, int* status) {
    addSpectra(f, { 1, 0, 1, 0, 1, 1 }, "VOPT-F2W", "km/s",
      { { "CRVAL3", v }, { "CRPIX3", 2 }, { "CDELT3", speedOfLight * step / (u * u) } }, status);
  });
  const Image image = readFitsImage(file, velocities(0, 1e5));
  const auto velocity = [&](double k) { return speedOfLight * (1 / (u - step * k) - 1); };
  EXPECT_NEAR(image.at(0, 0), velocity(1.5) - velocity(-1.5), 1e-6);
  EXPECT_NEAR(image.at(1, 0), velocity(1.5) - velocity(0.5), 1e-6);
}

TEST_F(FitsCube, NoMomentWithoutVelocities)
{
  const auto message = [&](const std::string& name, const std::string& type,
                         const std::string& unit, const Keywords& keywords) {
    return messageOf(this->write(name,
                       [&](fitsfile* f, int* status) {
                         addSpectra(f, { 1, 2, 3, 4 }, type, unit, keywords, status);
                       }),
      velocities(0, 1));
  };
  EXPECT_TRUE(contains(message("stokes.fits", "STOKES", "", {}), "no axis of velocities"));
  EXPECT_TRUE(contains(message("step.fits", "VRAD", "", { { "CRVAL3", 1 } }), "no increment"));
  EXPECT_TRUE(contains(message("unit.fits", "VRAD", "Hz", { { "CDELT3", 1 } }), "CUNIT3"));
  EXPECT_TRUE(contains(message("code.fits", "VRAD-W2V", "", { { "CDELT3", 1 } }), "not linear"));
}

// The moment is that of the STOKES plane that `plane` names.
TEST_F(FitsCube, MomentAtAPlaceAlongTheOtherAxes)
{
  const std::vector<long> axes = { 1, 2, 1, 3 };
  const std::string file = this->write("stokes4.fits", [&](fitsfile* f, int* status) {
    addImage(f, DOUBLE_IMG, counted(axes), status, axes);
    setTypes(f, { "RA---SIN", "STOKES", "DEC--SIN", "VRAD" }, status);
    fits_update_key_dbl(f, "CDELT4", 2000, 15, nullptr, status);
  });
  FitsSelection selection = velocities(0, 100);
  EXPECT_EQ(readFitsImage(file, selection).at(0, 0), 2 * (0 + 2 + 4));
  selection.plane = 1;
  EXPECT_EQ(readFitsImage(file, selection).at(0, 0), 2 * (1 + 3 + 5));
}

TEST_F(FitsCube, ProgressGoesUpToOneAndEndsTheReading)
{
  const std::vector<long> axes = { 128, 128, 64 };
  const std::string file = this->write("long.fits", [&](fitsfile* f, int* status) {
    addImage(f, SHORT_IMG, std::vector<double>(1 << 20, 1), status, axes);
  });
  FitsSelection selection;
  selection.planes = { 0, 63 };
  std::vector<double> told;
  readFitsImage(file, selection, [&](double part) {
    told.push_back(part);
    return true;
  });
  ASSERT_GE(told.size(), 4u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
  int calls = 0;
  EXPECT_THROW(
    readFitsImage(file, selection, [&](double) { return ++calls < 2; }), galaxy::Aborted);
  EXPECT_EQ(calls, 2);
}
