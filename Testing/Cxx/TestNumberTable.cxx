// Lists of clusters, widths and shells in the writings of many programs.
#include "Readers/Formats/SpheroidTables.h"
#include "Readers/Formats/WidthTable.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>

namespace galaxy::testing
{
namespace
{
void expectWidths(const std::string& text)
{
  std::vector<WidthAtRadius> rows;
  ASSERT_EQ(errorOf([&] { rows = parseWidthTable(text, "table"); }), "") << text;
  ASSERT_EQ(rows.size(), 2u) << text;
  EXPECT_NEAR(rows[0].radius, 0, 1e-12) << text;
  EXPECT_NEAR(rows[0].fwhm, 0.3, 1e-12) << text;
  EXPECT_NEAR(rows[1].radius, 5, 1e-12) << text;
  EXPECT_NEAR(rows[1].fwhm, 0.5, 1e-12) << text;
}

void refuseWidths(const std::string& text, const std::string& words)
{
  const std::string message = errorOf([&] { parseWidthTable(text, "table"); });
  EXPECT_NE(message.find(words), std::string::npos) << text << "gave: " << message;
}

void expectClusters(const std::string& text)
{
  std::vector<StarCluster> clusters;
  ASSERT_EQ(errorOf([&] { clusters = parseClusterList(text, "table"); }), "") << text;
  ASSERT_EQ(clusters.size(), 2u) << text;
  EXPECT_NEAR(clusters[1].position.x, -1, 1e-12) << text;
  EXPECT_NEAR(clusters[1].position.y, 0.3, 1e-12) << text;
  EXPECT_NEAR(clusters[0].position.z, 0.5, 1e-12) << text;
  EXPECT_EQ(clusters[1].luminosity, 2) << text;
}
} // namespace

TEST(NumberTables, WidthsInManyWritings)
{
  for (const char* text : { "0 0.3\n5 0.5\n",
         "\xef\xbb\xbf"
         "0 0.3\n5 0.5\n",
         "0,0.3\n5,0.5\n", "0;0,3\n5;0,5\n", "0 0,3\n5 0,5\n", "# r[kpc] fwhm[pc]\n0 300\n5 500\n",
         "r fwhm\nkpc pc\n0 300\n5 500\n", "# radius fwhm\n# pc pc\n0 300\n5000 500\n",
         "FWHM (kpc), R (kpc), err\n0.3,0,0.1\n0.5,5,0.1\n", "% r w\n0 0.3\n5 0.5\n",
         "radius_pc,width_pc\n0,300\n5000,500\n", "0 0.3\r5 0.5\r",
         "# radius in kpc, width in pc\n0 300\n5 500\n" })
  {
    expectWidths(text);
  }
  refuseWidths("# r[arcsec] fwhm[pc]\n0 300\n", "column 'r[arcsec]': must be in pc, kpc or Mpc");
  refuseWidths("# r sigma\n0 0.3\n5 0.5\n",
    "line 1: the heading must name a column fwhm, and names 'r', 'sigma'");
  refuseWidths("0 0.3 0.1\n5 0.5 0.1\n", "line 1: has 3 columns");
  refuseWidths("r fwhm\n0 0.3kpc\n5 0.5\n", "line 2");
}

TEST(NumberTables, ClustersInManyWritings)
{
  for (const char* text : { "x,y,z,luminosity\n1,2,0.5,1\n-1,0.3,0.2,2\n",
         "\xef\xbb\xbfx;y;z;luminosity\n1;2;0.5;1\n-1;0.3;0.2;2\n",
         "x;y;z;luminosity\n1;2;0,5;1\n-1;0,3;0,2;2\n",
         "x\ty\tz\tluminosity\n1\t2\t0.5\t1\n-1\t0.3\t0.2\t2\n",
         "# X[pc] Y[pc] Z[pc] Luminosity\n1000 2000 500 1\n-1000 300 200 2\n",
         "name,x,y,z,lum\n-,kpc,kpc,kpc,Lsun\nM 2,1,2,0.5,1\nM 54,-1,0.3,0.2,2\n" })
  {
    expectClusters(text);
  }
  const auto message = [&](const std::string& text) {
    return errorOf([&] { parseClusterList(text, "table"); });
  };
  EXPECT_NE(message("x,y,z\n1,2,nan\n").find("line 2: z must be a finite number, not 'nan'"),
    std::string::npos);
  EXPECT_NE(
    message("x,x,z\n1,2,3\n").find("line 1: two columns are called 'x'"), std::string::npos);
  EXPECT_NE(message("1,2,3\n").find("the columns must be x, y and z"), std::string::npos);
  EXPECT_NE(message("x[arcsec],y,z\n1,2,3\n").find("must be in pc, kpc or Mpc"), std::string::npos);
}

TEST(NumberTables, PlacesOnTheSkyMayBeSexagesimal)
{
  const SkyPosition centre = { 204.25, -29.865 };
  const std::string nameless = errorOf([&] { parseClusterList("1,2,3\n", "table", centre, 4.9); });
  EXPECT_NE(nameless.find("line 1: has 3 columns without names"), std::string::npos) << nameless;
  for (const char* text : { "ra,dec\n204.25,-29.965\n", "RA;Dec\n13:37:00;-29:57:54\n",
         "RAJ2000\tDEJ2000\n\"h:m:s\"\t\"d:m:s\"\n------\t------\n13 37 00\t-29 57 54\n",
         "_RAJ2000,_DEJ2000,RAJ2000,DEJ2000,dist[kpc]\ndeg,deg,\"h:m:s\",\"d:m:s\",kpc\n"
         "204.25,-29.965,13 37 00,-29 57 54,4900\n",
         "ra(h) dec(deg)\n13.616666666666667 -29.965\n" })
  {
    const StarCluster south = parseClusterList(text, "table", centre, 4.9)[0];
    EXPECT_NEAR(south.position.x, 0, 1e-9) << text;
    EXPECT_NEAR(south.position.y, -4900 * std::sin(0.1 / 57.29577951308232), 2e-2) << text;
  }
}

TEST(NumberTables, ShellsInManyWritings)
{
  for (const char* text :
    { "semi_major,axis_ratio_b,axis_ratio_c,position_angle\n0,1,0.9,10\n2,0.8,0.7,20\n",
      "# sma[pc] b/a c/a PA[deg]\n0 1 0.9 10\n2000 0.8 0.7 20\n",
      "semi_major;axis_ratio_b;axis_ratio_c;position_angle\n0;1;0,9;10\n2;0,8;0,7;20\n" })
  {
    const std::vector<EllipsoidShell> shells = parseEllipsoidShells(text, "table");
    ASSERT_EQ(shells.size(), 2u) << text;
    EXPECT_NEAR(shells[1].semiMajor, 2, 1e-12) << text;
    EXPECT_NEAR(shells[1].axisRatios[0], 0.8, 1e-12) << text;
    EXPECT_NEAR(shells[1].positionAngle, 20, 1e-12) << text;
  }
}
} // namespace galaxy::testing
