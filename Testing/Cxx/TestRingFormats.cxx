#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingTable.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace galaxy
{
namespace
{
const std::string folder = GALAXY_SOURCE_DIR "/../shared/data/";

/// The real file, or an empty name where it is not at hand.
std::string real(const std::string& name)
{
  return std::filesystem::exists(folder + name) ? folder + name : "";
}

std::string messageOf(const std::string& text, const RingOptions& options = {})
{
  return errorOf([&] { parseRingTable(text, "some.rings", options); });
}

const RingColumn& column(const RingTable& table, const std::string& name)
{
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
    [&](const RingColumn& column) { return column.name == name; });
  static const RingColumn none{ "", "", std::vector<double>(1000) };
  EXPECT_NE(found, table.columns.end()) << name;
  return found == table.columns.end() ? none : *found;
}

const std::string halves = "NDISKS= 2\nNUR= 2\nRADI= 0 30\nVROT= 100 120\nINCL= 60\nPA= 350 355\n"
                           "AZ1P= 0\nAZ1W= 180\nSDIS= 8\nLTYPE= 1\n# VROT_ERR= 3 4\n"
                           "VROT_2= 110 140\nINCL_2= 64\nPA_2= 10 5\nZ0_2= 4\n"
                           "AZ1P_2= 180\nAZ1W_2= 180\nSDIS_2= 10\nLTYPE_2= 3\n";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

/// A DiskFit output with the lines that count; every parameter fitted unless cut out.
const std::string diskFit =
  "Minimization output, vels\nInput files:\nvels.fits   pixscale  2.00 arcsec/pix\n"
  "vels toggles:    interp0: T  radial: F    Vsys: T    warp: T      rw: T\n"
  "Input values\n------------\ndisk PA, phi_d^prime (deg):   45.00\ndisk eps:   0.45\n"
  "Vsys (km/s):   110.00\nr_w (data units):   90.00\nWarp eps welm:   0.25\n"
  "Warp PA wphim:   0.50\n\n"
  "Best fitting values\n-------------------\ndisk PA, phi_d^prime (deg):   30.00 +/-  2.21\n"
  "disk eps:   0.50 +/-  0.02\nVsys (km/s):   100.00 +/-  0.23\n"
  "r_w (data units):   10.00 +/-  1.00\nWarp eps welm:   -0.40 +/-  0.02\n"
  "Warp PA wphim:   20.00 +/-  4.00\nMinimization Details\n---\n"
  "Fitted velocity components   (radii in data units, velocities in km/s):\n"
  "  r  npts  Vt  eVt  Vr  eVr  Vm,t  eVm,t  Vm,r  eVm,r\n--------------------\n"
  " 10.00 54.36  62.84 5.39 7.00 0.10 0.00 0.00 0.00 0.00\n"
  " 20.00 64.36 117.66 6.15 0.00 0.00 0.00 0.00 0.00 0.00\n"
  " 30.00 74.36 131.72 7.36 0.00 0.00 0.00 0.00 0.00 0.00\n";
} // namespace

TEST(RingFormats, AnglesAreUnwrapped)
{
  const auto table = parseRingTable("0 1 0 170 350\n1 1 0 -175 10\n2 1 0 100 330\n", "x");
  EXPECT_EQ(table.rings[1].positionAngle, 370);
  EXPECT_EQ(table.rings[2].positionAngle, 330);
  EXPECT_EQ(table.rings[1].inclination, 185);
  EXPECT_EQ(table.rings[2].inclination, 100);
}

TEST(RingFormats, DisksOfTirificAreChosenByNumber)
{
  RingOptions options;
  const auto first = parseRingTable(halves, "some.def");
  EXPECT_EQ(first.rings[1].rotationVelocity, 120);
  EXPECT_EQ(first.layerLaw, LayerLaw::Gaussian);
  EXPECT_EQ(column(first, "SDIS").values, std::vector<double>({ 8, 8 }));
  EXPECT_EQ(column(first, "VROT_ERR").values, std::vector<double>({ 3, 4 }));
  options.disk = 2;
  const auto second = parseRingTable(halves, "some.def", options);
  EXPECT_EQ(second.rings[1].rotationVelocity, 140);
  EXPECT_EQ(second.rings[1].scaleHeight, 4);
  EXPECT_EQ(second.layerLaw, LayerLaw::Exponential);
  options.disk = 3;
  EXPECT_EQ(messageOf(halves, options),
    "some.rings: line 1: NDISKS: there is no disk 3; choose ring_disk from 1 to 2");
  options = {};
  options.layerLaw = LayerLaw::Box;
  EXPECT_EQ(parseRingTable(halves, "some.def", options).layerLaw, LayerLaw::Box);
}

TEST(RingFormats, HalvesAreOneDisc)
{
  RingOptions options;
  options.sides = RingSides::Second;
  EXPECT_EQ(parseRingTable(halves, "some.def", options).rings[0].rotationVelocity, 110);
  options.sides = RingSides::Mean;
  const auto mean = parseRingTable(halves, "some.def", options);
  EXPECT_EQ(mean.rings[0].rotationVelocity, 105);
  EXPECT_EQ(mean.rings[1].rotationVelocity, 130);
  EXPECT_EQ(mean.rings[0].inclination, 62);
  EXPECT_EQ(mean.rings[0].positionAngle, 360) << "by the shorter way";
  EXPECT_EQ(mean.rings[1].positionAngle, 360);
  EXPECT_EQ(mean.rings[1].scaleHeight, 2);
  EXPECT_EQ(column(mean, "SDIS").values, std::vector<double>({ 9, 9 }));
  const std::string whole = "some.rings: line 8: AZ1W: no disk is the other half of disk 1; use "
                            "ring_sides = \"First\"";
  EXPECT_EQ(messageOf(replaced(halves, "AZ1P_2= 180", "AZ1P_2= 90"), options), whole);
  EXPECT_EQ(messageOf(replaced(halves, "AZ1W_2= 180", "AZ1W_2= 360"), options), whole);
}

TEST(RingFormats, LinesOfTirificMayContinue)
{
  EXPECT_EQ(
    parseRingTable("RADI= 0 \\\n 10 20\nVROT= 1 2 3\nINCL= 1\nPA= 1\n", "x").rings.size(), 3u);
}

TEST(RingFormats, HeadingsHaveUnits)
{
  const auto check = [](const std::string& text, RingOptions options = {}) {
    const auto table = parseRingTable(text, "some.csv", options);
    ASSERT_EQ(table.rings.size(), 2u) << text;
    EXPECT_NEAR(table.rings[1].radius, 120, 1e-9) << text;
    EXPECT_NEAR(table.rings[1].rotationVelocity, 200, 1e-9) << text;
    EXPECT_NEAR(table.rings[1].scaleHeight, 6, 1e-9) << text;
    EXPECT_NEAR(table.rings[1].inclination, 45, 1e-9) << text;
    EXPECT_NEAR(table.rings[1].positionAngle, 30, 1e-9) << text;
  };
  check("# r vrot z0 inc pa\n0 0 6 45 30\n120 200 6 45 30\n");
  check("PA (deg), Radius [arcmin], Rotation velocity (m/s), z0(arcsec), incl\n30,0,0,6,45\n"
        "30,2,200000,6,45\n");
  check("# r [arcmin] vrot [km s-1] z0 [arcsec] inc [rad] pa\n0 0 6 0.7853981633974483 30\n"
        "2 200 6 0.7853981633974483 30\n");
  RingOptions options;
  options.distance = 0.648 / 3.14159265358979323846; // 1 pc is 1 arcsec
  check("r_kpc,vrot_km_s,z0_pc,inc_deg,pa\n0,0,6,45,30\n0.12,200,6,45,30\n", options);
  options.pixelScale = 2;
  check("r_pix vrot z0(pix) i PA\n0 0 3 45 30\n60 200 3 45 30\n", options);
  check("# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n"
        "# - {name: pa, unit: deg, datatype: float64}\n"
        "# - {name: r, unit: kpc, datatype: float64, description: 'a, b'}\n"
        "# - {name: vrot, unit: km / s, datatype: float64}\n"
        "# - {name: z0, unit: pc, datatype: float64}\n"
        "# - {name: inc, unit: deg, datatype: float64}\n"
        "pa,r,vrot,z0,inc\n30,0,0,6,45\n30,0.12,200,6,45\n",
    options);
}

TEST(RingFormats, MissingScalesAreAskedFor)
{
  EXPECT_EQ(messageOf("r_kpc,vrot,i,pa\n1,2,3,4\n"),
    "some.rings: column 'r_kpc': is in kpc; give the distance in Mpc: Distance of the ring "
    "reader");
  EXPECT_EQ(messageOf("r[pix],vrot,i,pa\n1,2,3,4\n"),
    "some.rings: column 'r[pix]': is in pix; give the size of a pixel in arcsec: "
    "ring_pixel_scale in [galaxy], PixelScale of the ring reader");
  EXPECT_EQ(messageOf("r[furlong],vrot,i,pa\n1,2,3,4\n"),
    "some.rings: column 'r[furlong]': 'furlong' is no unit of length known here; use arcsec, "
    "arcmin, deg, pc, "
    "kpc or pix");
  EXPECT_EQ(messageOf("r,vrot(mph),i,pa\n1,2,3,4\n"),
    "some.rings: column 'vrot(mph)': 'mph' is no unit of velocity known here; use km/s or m/s");
  EXPECT_EQ(messageOf("r,velocity,i,pa\n1,2,3,4\n"),
    "some.rings: line 1: the heading must name a column vrot (vrot, v_rot, rotation_velocity, "
    "rotationvelocity, rotational_velocity, rot_vel, rotvel, v_rotation, vrotation, vc, v_c, "
    "vcirc, "
    "v_circ, circular_velocity, v, vobs, v_obs, vt, v_t, vphi, v_phi); not known here are "
    "'velocity'; use ring_columns = { vrot = \"its name\" } in [galaxy] for one that is it");
  EXPECT_EQ(messageOf("r,vrot,i,pa\n1,,3,4\n"),
    "some.rings: line 2: column 2 (vrot) must be a finite number, not ''");
}

TEST(RingFormats, FurtherColumnsAreKept)
{
  const auto table =
    parseRingTable("r,vrot,vrot_err,i,pa,DISP(km/s),note\n1,2,0.5,3,4,8,a\n2,2,--,3,4,9,b\n", "x");
  ASSERT_EQ(table.columns.size(), 2u) << "a column of words is none";
  EXPECT_EQ(table.columns[0].name, "vrot_err");
  EXPECT_EQ(table.columns[0].values[0], 0.5);
  EXPECT_TRUE(std::isnan(table.columns[0].values[1]));
  EXPECT_EQ(table.columns[1].name, "DISP");
  EXPECT_EQ(table.columns[1].unit, "km/s");
  EXPECT_EQ(table.columns[1].values[1], 9);
}

TEST(RingFormats, RotcurTellsItsUnitAndNeedsNoComments)
{
  const std::string row = " 10 10 500 1 90 2 3 4 220 5 50 6 7 8 9 10 11 12\n";
  const auto table = parseRingTable("radius width systemic error rotation error\n"
                                    "(arcmin) (arcmin) (km/s) (km/s)\n" +
      row,
    "x");
  EXPECT_EQ(table.rings[0].radius, 600);
  EXPECT_EQ(table.code, RingCode::Rotcur);
  EXPECT_EQ(column(table, "E_VROT").values[0], 2);
  EXPECT_EQ(column(table, "XPOS").values[0], 7);
  EXPECT_EQ(column(table, "SIGMA").values[0], 12);
}

TEST(RingFormats, DiskFitWarps)
{
  const auto table = parseRingTable(diskFit, "some.out");
  ASSERT_EQ(table.rings.size(), 3u);
  EXPECT_EQ(table.rings[0].radius, 20);
  EXPECT_EQ(table.rings[0].rotationVelocity, 62.84);
  EXPECT_EQ(table.rings[0].systemicVelocity, 100);
  EXPECT_EQ(table.rings[0].positionAngle, 30);
  EXPECT_NEAR(table.rings[0].inclination, 60, 1e-9);
  // Half way from r_w to the last ring a quarter of the warp, there all of it.
  EXPECT_NEAR(table.rings[1].inclination, std::acos(0.6) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(table.rings[1].positionAngle, 35, 1e-9);
  EXPECT_NEAR(table.rings[2].inclination, std::acos(0.9) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(table.rings[2].positionAngle, 50, 1e-9);
  EXPECT_EQ(column(table, "eVt").values[1], 6.15);
  // Beyond face-on the axes change places.
  const auto beyond = parseRingTable(replaced(diskFit, "-0.40", "-1.50"), "some.out");
  EXPECT_NEAR(beyond.rings[2].inclination, std::acos(0.5) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(beyond.rings[2].positionAngle, 140, 1e-9);
  // What was not fitted keeps its input value, of the angle in radians.
  const auto input =
    parseRingTable(replaced(diskFit, "Warp PA wphim:   20.00 +/-  4.00\n", ""), "some.out");
  EXPECT_NEAR(input.rings[2].positionAngle, 30 + 0.5 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(
    parseRingTable(replaced(diskFit, "warp: T", "warp: F"), "x").rings[2].inclination, 60, 1e-9);
}

TEST(RingFormats, DiskFitsInclinationIsTheFilesOwn)
{
  // Of eps = 0.50 it would be 60.
  const std::string text = replaced(diskFit, "disk eps:   0.50 +/-  0.02\n",
    "disk eps:   0.50 +/-  0.02\ndisk incl (deg):   60.17 +/-  1.52\n");
  const auto flat = parseRingTable(replaced(text, "warp: T", "warp: F"), "x");
  for (const Ring& ring : flat.rings)
  {
    EXPECT_NEAR(ring.inclination, 60.17, 1e-9);
  }
  const auto warped = parseRingTable(text, "x");
  const double eps = 1 - std::cos(60.17 * 3.14159265358979323846 / 180);
  EXPECT_NEAR(warped.rings.front().inclination, 60.17, 1e-9);
  EXPECT_NEAR(std::cos(warped.rings.back().inclination * 3.14159265358979323846 / 180),
    1 - (eps - 0.40), 1e-9);
}

TEST(RingFormats, DiskFitNeedsAPixelScale)
{
  const std::string without = replaced(diskFit, "pixscale  2.00 arcsec/pix", "");
  EXPECT_NE(messageOf(without).find("ring_pixel_scale"), std::string::npos);
  RingOptions options;
  options.pixelScale = 3;
  EXPECT_EQ(parseRingTable(without, "x", options).rings[0].radius, 30);
  EXPECT_NE(messageOf("Minimization output, phot\n").find("velocity fit"), std::string::npos);
  EXPECT_EQ(messageOf(replaced(diskFit, "62.84", "*****")),
    "some.rings: line 27: column Vt must be a finite number, not '*****'");
}

TEST(RingFormats, AbsurdNumbersAreRefused)
{
  EXPECT_EQ(messageOf("1e308 1 1 1 1\n"),
    "some.rings: line 1: the ring is larger than the sky; check the units of radius and scale "
    "height");
  EXPECT_EQ(messageOf("0 1e308 1 1 1\n"),
    "some.rings: line 1: a velocity is greater than that of light; check its unit");
  EXPECT_EQ(messageOf("0 1 1 1e308 1\n"),
    "some.rings: line 1: an angle is more than ten turns; check the columns' order");
  EXPECT_EQ(messageOf("NUR= 2147483647\nRADI= 0 1\nVROT= 1\nINCL= 1\nPA= 1\n"),
    "some.rings: line 1: NUR: must be a whole number from 1 to 1000000");
  EXPECT_EQ(messageOf("-0 1 -0 1 -0\n"), "");
}

TEST(RingFormats, RealTirificFiles)
{
  struct Known
  {
    const char* file;
    std::size_t rings;
    double lastRadius, lastVelocity, firstInclination;
    LayerLaw law;
  };
  for (const Known& known : { Known{ "NGC2903/NGC_2903.def", 15, 0, 0, 65.6371, LayerLaw::Sech2 },
         Known{ "NGC2903/NGC_2903_ModelInput.def", 12, 639.95, 176.13, 68.99, LayerLaw::Sech2 },
         Known{ "NGC2903/NGC_2903_Finalmodel_GDL.def", 16, 0, 191.226, 65.6431, LayerLaw::Sech2 },
         Known{ "rings/NGC_3198.def", 27, 780, 175.82, 68.95, LayerLaw::Sech2 },
         Known{ "rings/NGC_5023.def", 20, 0, 0, 88.1009, LayerLaw::Exponential },
         Known{ "rings/NGC_5204.def", 12, 440, 122.462, 56.0674, LayerLaw::Sech2 } })
  {
    const std::string file = real(known.file);
    if (file.empty())
    {
      GTEST_SKIP() << "no data at " << folder;
    }
    RingOptions options;
    for (const RingSides sides : { RingSides::First, RingSides::Second, RingSides::Mean })
    {
      options.sides = sides;
      EXPECT_EQ(readRingTable(file, options).rings.size(), known.rings) << file;
    }
    const RingTable table = readRingTable(file);
    EXPECT_EQ(table.code, RingCode::Tirific);
    EXPECT_EQ(table.rings[0].inclination, known.firstInclination) << file;
    EXPECT_EQ(table.layerLaw, known.law) << file;
    EXPECT_EQ(column(table, "XPOS").values.size(), known.rings);
    if (known.lastRadius > 0)
    {
      EXPECT_EQ(table.rings.back().radius, known.lastRadius) << file;
    }
    if (known.lastVelocity > 0)
    {
      EXPECT_EQ(table.rings.back().rotationVelocity, known.lastVelocity) << file;
    }
  }
}

TEST(RingFormats, RealRotcurBaroloAndDiskFitFiles)
{
  if (real("rings").empty())
  {
    GTEST_SKIP() << "no data at " << folder;
  }
  const auto circinus = readRingTable(real("rings/Circinus.rotcur"));
  ASSERT_EQ(circinus.rings.size(), 16u);
  EXPECT_EQ(circinus.rings[1].rotationVelocity, 145.71);
  EXPECT_EQ(circinus.rings[15].positionAngle, 220);
  EXPECT_EQ(column(circinus, "NPTS").values[2], 365);
  const auto m83 = readRingTable(real("M83/M_83.rotcur"));
  ASSERT_EQ(m83.rings.size(), 18u);
  EXPECT_EQ(m83.rings[1].positionAngle, 223.72);
  EXPECT_EQ(m83.code, RingCode::Rotcur);

  for (const char* name : { "rings_final1.txt", "rings_final2.txt", "rings_initial.txt" })
  {
    const auto table = readRingTable(real("rings/bbarolo_r431/") + name);
    EXPECT_EQ(table.rings.size(), 19u) << name;
    EXPECT_EQ(table.rings[1].radius, 12.439) << "arcsec, not the program's own kpc";
    EXPECT_EQ(table.code, RingCode::Rotcur);
    EXPECT_EQ(table.layerLaw, LayerLaw::Gaussian);
    EXPECT_EQ(column(table, "XPOS").unit, "pix");
    EXPECT_EQ(column(table, "XPOS").values[0], 94.14);
  }
  const auto final1 = readRingTable(real("rings/bbarolo_r431/rings_final1.txt"));
  EXPECT_EQ(final1.rings[2].systemicVelocity, -37.74);
  EXPECT_EQ(column(final1, "E_VROT1").values[1], -4.162);
  EXPECT_EQ(column(final1, "RAD(Kpc)").values[1], 0.01);
  EXPECT_NE(messageOf("r vrot\n"), "");
  EXPECT_THROW(readRingTable(real("rings/bbarolo_r431/densprof.txt")), Error);

  const auto warp = readRingTable(real("rings/diskfit_warp.out"));
  ASSERT_EQ(warp.rings.size(), 25u);
  EXPECT_EQ(warp.rings[1].rotationVelocity, 117.66);
  EXPECT_EQ(warp.rings[0].positionAngle, 32.93);
  EXPECT_NEAR(warp.rings[0].inclination, 61.37, 1e-9) << "eps is rounded to 0.52, of 61.31 degrees";
  // eps - 2.37 < 0 at the last ring: the axes have changed places.
  const double across = 1 / (std::cos(61.37 * M_PI / 180) + 2.37);
  EXPECT_NEAR(warp.rings[24].inclination, std::acos(across) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(warp.rings[24].positionAngle, 32.93 + 10.28 + 90, 1e-9);
}
} // namespace galaxy
