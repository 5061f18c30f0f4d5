// Names and units of the columns of a table of rings: used, or refused by name; never dropped.
#include "Testing/Cxx/RingFixtures.h"

#include "Readers/Formats/GalaxyDescription.h"
#include "Testing/Cxx/TemporaryFolder.h"

#include <fstream>

namespace galaxy::testing
{
namespace
{
/// r vrot PA i Z0
const std::string turned = "10 100 80 45 2\n20 101 81 46 3\n";

const std::string edge =
  "# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n# - {name: Name, datatype: string}\n"
  "# - {name: bbRad, unit: kpc, datatype: float64, description: 'radius, mean'}\n"
  "# - name: bbVrot\n#   unit: km / s\n#   datatype: float64\n"
  "# - {name: bbZ0, unit: kpc, datatype: float64}\n"
  "# - {name: bbInc, unit: deg, datatype: float64}\n# - {name: bbPA, unit: deg, datatype: "
  "float64}\n"
  "Name,bbRad,bbVrot,bbZ0,bbInc,bbPA\nNGC 1,10,100,2,45,80\nNGC 1,20,101,3,46,81\n"
  "UGC 03253,10,200,2,45,80\nIC 7,,,,,\n";

using RingHeadingsInAFolder = TemporaryFolder;
} // namespace

TEST(RingHeadings, ACommentThatNamesTheColumnsCounts)
{
  for (const char* names :
    { "# Radius V PA Inc Z0", "Radius V PA Inc Z0", "# RADI VROT P.A. INCL Z0",
      "# Columns: r, Vobs, PA, incl, z0", "# r v_circ position_angle inclination scale_height",
      "#   Radius   Rotation velocity   Position angle   Inclination   Scale height" })
  {
    expectTwoRings(names + ("\n" + turned));
  }
  // What is not understood and needed is refused, with its name.
  expectRefusal("# r Speed Z0 i PA\n" + twoRows(), "line 1: the heading must name a column vrot");
  expectRefusal("# r Speed Z0 i PA\n" + twoRows(), "not known here are 'Speed'");
  expectRefusal(
    "# Radius Speed Scale Tilt Angle\n" + twoRows(), "'Speed', 'Scale', 'Tilt', 'Angle'");
  for (const char* odd : { "q", "b/a", "cosi", "ellipticity", "log(i)" })
  {
    expectRefusal("# r vrot Z0 " + std::string(odd) + " PA\n" + twoRows(), quoted(odd));
  }
  for (const char* odd : { "r/R25", "log_r", "r(R25)", "Diameter" })
  {
    expectRefusal("# " + std::string(odd) + " vrot Z0 i PA\n" + twoRows(), quoted(odd));
  }
  expectRefusal("# r vrot i PA\n" + twoRows(), "line 1: the heading names 4 columns");
  expectRefusal("# r vrot Z0 i PA sdis\n" + twoRows(), "line 1: the heading names 6 columns");
}

TEST(RingHeadings, ProseIsNoHeading)
{
  for (const char* prose : { "# this is a test table", "# i and PA were kept fixed",
         "# R, PA and inclination come from the kinematic fit", "# r vrot Z0 i PA, all made up",
         "# Distance = 3.16 Mpc", "# counted from North; an inclination of 0 is face-on" })
  {
    expectTwoRings(prose + ("\n" + twoRows()));
  }
}

TEST(RingHeadings, ColumnsMayBeListed)
{
  const RingOptions options = atArcsecDistance();
  for (const std::string& list :
    { std::string("# Column 1: r (kpc)\n# Column 2: V (km/s)\n# Column 3: PA (deg)\n"
                  "# Column 4: inclination (deg)\n# Column 5: z0 (kpc)\n"),
      std::string(
        "#   1 RADIUS  Radius of ring [kpc]\n#   2 VROT  Rotation [km/s]\n#   3 PA  Angle\n"
        "#   4 INC  Angle [deg]\n#   5 Z0  Height [kpc]\n"),
      std::string("# (1) Radius in kpc\n# (2) Rotation velocity\n# (3) Position angle\n"
                  "# (4) Inclination\n# (5) Scale height in kpc\n"),
      std::string("# col1 = r, kpc\n# col2 = vrot, km/s\n# col3 = PA\n# col4 = inc\n"
                  "# col5 = z0, kpc\n") })
  {
    expectTwoRings(list + turned, options);
  }
}

TEST(RingHeadings, NamesInTheOpenAreTheTablesOwn)
{
  expectTwoRings("# r vrot i PA Z0\nr vrot Z0 i PA\n" + twoRows());
  expectTwoRings("# r: radius\n# vrot: rotation velocity\n# PA: position angle\n# i: inclination\n"
                 "# Z0: scale height\n" +
    turned);
}

TEST(RingHeadings, UnitsHaveALineOfTheirOwn)
{
  const std::string names = "# r vrot Z0 i PA\n";
  const RingOptions options = atArcsecDistance();
  for (const std::string& head :
    { names + "# kpc km/s kpc deg deg\n", names + "# (kpc) (km/s) (kpc) (deg) (deg)\n",
      names + "# [kpc] [km s-1] [kpc] [deg] [deg]\n", names + "# kpc km s^-1 kpc deg deg\n",
      names + "# Units: kpc, km/s, kpc, deg, deg\n", names + "# units = kpc km/s kpc deg deg\n",
      "# kpc km/s kpc deg deg\n" + names, std::string("# kpc km/s kpc deg deg\n"),
      names.substr(2) + "kpc km/s kpc deg deg\n", "kpc km/s kpc deg deg\n" + names.substr(2),
      std::string("# r vrot Z0 i PA (kpc, km/s, kpc, deg, deg)\n"),
      "# radii in kpc, Z0 in kpc\n" + names, std::string("# r is in kpc\n# Z0 [kpc]\n"),
      "# All lengths in kpc\n" + names, "# r: radius in kpc\n# Z0 = height (kpc)\n" + names,
      std::string("# r/kpc vrot/(km/s) Z0/kpc i/deg PA/deg\n") })
  {
    expectTwoRings(head + twoRows(), options);
  }
  expectTwoRings(names + "# arcmin km/s arcmin deg deg\n" + twoRows(), {}, 60);
  expectTwoRings("# r['] vrot Z0[arcmin] i PA\n" + twoRows(), {}, 60);
  expectRefusal(names + "# arcsec mph arcsec deg deg\n" + twoRows(),
    "line 2: column 'vrot': 'mph' is no unit of velocity");
  expectRefusal(names + "# Units: kpc, km/s and deg\n" + twoRows(), "line 2: the units must be 5");
  expectRefusal(names + "# kpc km/s kpc deg deg\n" + twoRows(), "give the distance");
}

TEST(RingHeadings, BarolosPlaneFitsHaveTwoRadii)
{
  const RingTable table =
    parseRingTable("#   Radius  Radius   Vsys    Vrot    Vexp   P.A.   Incl.  Xcenter   Ycenter\n"
                   "#   [pix]   [arcs]  [KM/S]  [KM/S]  [KM/S]  [deg]  [deg]   [pix]     [pix] \n"
                   "    2.50    10.00   650.0   100.0    3.0    80.0   45.0    64.0      63.0\n",
      "2dfit.txt");
  ASSERT_EQ(table.rings.size(), 1u);
  EXPECT_EQ(table.rings[0].radius, 10);
  EXPECT_EQ(table.rings[0].rotationVelocity, 100);
  EXPECT_EQ(table.rings[0].systemicVelocity, 650);
  EXPECT_EQ(table.rings[0].positionAngle, 80);
  EXPECT_EQ(table.rings[0].inclination, 45);
  EXPECT_EQ(table.rings[0].expansionVelocity, -3) << "ROTCUR's model has ROTCUR's sign";
  EXPECT_EQ(table.code, RingCode::Rotcur);
}

TEST(RingHeadings, OfTwoColumnsTheBetterOrNone)
{
  for (const char* order : { "# r vrot vcirc i PA Z0\n10 100 120 45 80 2\n20 101 121 46 81 3\n",
         "# r V_circ V_rot i PA Z0\n10 120 100 45 80 2\n20 121 101 46 81 3\n",
         "# r V Vrot inc PA Z0\n10 120 100 45 80 2\n20 121 101 46 81 3\n",
         "# r e_r vrot errV Z0 e_Z0 i e_i PA e_PA\n10 1 100 1 2 1 45 1 80 1\n"
         "20 1 101 1 3 1 46 1 81 1\n",
         "# r I vrot inc PA Z0\n10 7 100 45 80 2\n20 7 101 46 81 3\n",
         "# r(kpc) r(arcsec) vrot i PA Z0\n1 10 100 45 80 2\n2 20 101 46 81 3\n" })
  {
    expectTwoRings(order);
  }
  expectRefusal("# r vc vobs i PA\n10 1 2 3 4\n", "'vc' and 'vobs' both stand for vrot");
  expectRefusal("# r(arcsec) r(arcmin) vrot i PA\n1 1 2 3 4\n", "'r(arcsec)' and 'r(arcmin)' both");
  // A radial velocity is the line of sight's to most.
  const RingTable table = parseRingTable("# r vrot i PA radial_velocity\n1 2 3 4 1185\n", "x");
  EXPECT_EQ(table.rings[0].expansionVelocity, 0);
}

TEST(RingHeadings, AGalaxyIsChosenByName)
{
  RingOptions options = atArcsecDistance();
  expectRefusal(
    edge, "column 'Name': holds 3 galaxies, NGC 1, UGC 03253, IC 7; choose one", options);
  for (const char* name : { "NGC 1", "ngc1", "NGC_1" })
  {
    options.galaxyName = name;
    expectTwoRings(edge, options);
  }
  options.galaxyName = "UGC3253";
  expectRefusal(edge, "there is no galaxy 'UGC3253'; did you mean `UGC 03253`?", options);
  expectRefusal(twoRows(), "has no column with the galaxies' names", options);
  expectRefusal("NUR= 1\nRADI= 1\nVROT= 1\nINCL= 1\nPA= 1\n", "must have a column with", options);
  options.galaxyName = "A";
  expectTwoRings(
    "% Name r vrot Z0 i PA\nA 10 100 2 45 80\nA 20 101 3 46 81\nB 5 1 1 1 1\n", options);
  expectTwoRings("Galaxy,r,vrot,Z0,i,PA\nA,10,100,2,45,80\nA,20,101,3,46,81\n");
}

TEST_F(RingHeadingsInAFolder, ADescriptionNamesColumnsAndGalaxy)
{
  std::ofstream(this->path("many.csv"))
    << "Who,Dist,Speed,Height,Tilt,Angle\nNGC 1,10,100,2,45,80\nNGC 1,20,101,3,46,81\n"
       "NGC 2,1,2,3,4,5\n";
  const auto ringsOf = [&](const std::string& keys) {
    return readRings(parseGalaxyDescription(
      "[galaxy]\nra = 1\ndec = 2\ndistance = 3\nrings = \"many.csv\"\n" + keys,
      this->path("some.galaxy")));
  };
  const std::string columns = "ring_columns = { r = \"Dist\", vrot = \"Speed\", z0 = \"Height\", "
                              "inclination = \"Tilt\", PA = \"Angle\", name = \"Who\" }\n";
  const RingTable table = ringsOf("ring_galaxy = \"NGC 1\"\n" + columns);
  ASSERT_EQ(table.rings.size(), 2u);
  EXPECT_EQ(table.rings[1].rotationVelocity, 101);
  EXPECT_EQ(table.rings[1].scaleHeight, 3);
  EXPECT_EQ(table.rings[1].positionAngle, 81);
  const auto message = [&](const std::string& keys) { return errorOf([&] { ringsOf(keys); }); };
  EXPECT_NE(message(columns).find("holds 2 galaxies, NGC 1, NGC 2"), std::string::npos);
  EXPECT_NE(
    message("ring_columns = { r = \"Dst\" }\n").find("did you mean `Dist`?"), std::string::npos)
    << message("ring_columns = { r = \"Dst\" }\n");
  EXPECT_NE(message("ring_columns = { vrt = \"Speed\" }\n")
              .find("line 6: vrt: unknown key of ring_columns; did you mean `vrot`?"),
    std::string::npos)
    << message("ring_columns = { vrt = \"Speed\" }\n");
  EXPECT_NE(message("ring_columns = 3\n").find("ring_columns"), std::string::npos);
}
} // namespace galaxy::testing
