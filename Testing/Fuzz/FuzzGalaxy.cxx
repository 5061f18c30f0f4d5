// FuzzGalaxy COUNT SEED [FILES...|none]: .galaxy descriptions with the tables that they name,
// .galaxygroup descriptions, and the tables alone, see TextFuzz.h.

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/SpheroidTables.h"
#include "Readers/Formats/WidthTable.h"
#include "Testing/Fuzz/TextFuzz.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
const std::vector<std::string> galaxyTexts = {
  "[galaxy]\nname = \"M 1\"\nra = 204.25\ndec = -29.87\ndistance = 4.9\nrings = \"a.def\"\n"
  "ring_disk = 1\nring_sides = \"Mean\"\nring_law = \"Sech2\"\nring_pixel_scale = 1.5\n"
  "ring_galaxy = \"NGC 1\"\nring_columns = { r = \"Rad\", vrot = \"V\" }\nspin = "
  "\"Clockwise\"\ninterpolation = \"Slerp\"\nbeyond_last_ring = \"HoldLast\"\nmock = true\n"
  "[image.r]\nfile = \"r.fits\"\nhdu = 1\nplane = 2\nbackground = \"Auto\"\n"
  "[image.b]\nfile = \"b.fits\"\nra = 1\ndec = 2\npixel_scale = 1\nreference_pixel = [1, 2]\n"
  "[[component]]\nname = \"stars\"\ntype = \"Disk\"\nparticles = 1000\n"
  "layers = [{ image = \"r\", color = [1, 0.5, 0.2], clip = [0, 9], stretch = \"Asinh\" }]\n"
  "[component.thickness]\nmodel = \"Rings\"\nchildren = 4\n"
  "[[component]]\nname = \"gas\"\nprofile = \"Exponential\"\nscale_length = 1\n"
  "[component.thickness]\nmodel = \"Flared\"\nprofile_table = \"widths\"\n"
  "[[component]]\nname = \"clusters\"\ntype = \"Spheroid\"\n"
  "[component.spheroid]\nprofile = \"Plummer\"\nscale_radius = 1\nluminosity = 1\n"
  "cluster_list = \"clusters\"\n"
  "[[component]]\nname = \"bulge\"\ntype = \"Spheroid\"\n[component.spheroid]\nsigma = [1, 1, 1]\n",
};

const std::vector<std::string> groupTexts = {
  "[group]\nname = \"G\"\nmagnification = 2\nseparation = 0.5\n"
  "[[member]]\ngalaxy = \"a.galaxy\"\n[[member]]\ngalaxy = \"b.galaxy\"\nmagnification = 3\n",
};

const std::vector<std::string> widthTexts = { "# r[kpc] fwhm[pc]\n0 300\n5 500\n", "0 0,3\n5 0,5\n",
  "radius;width\nkpc;kpc\n0;0.3\n5;0.5\n" };

const std::vector<std::string> clusterTexts = {
  "x,y,z,luminosity,radius\n1,2,0.5,1,0.01\n-1,0.3,0.2,2,0.02\n",
  "RAJ2000\tDEJ2000\tdist\n\"h:m:s\"\t\"d:m:s\"\tkpc\n---\t---\t---\n13 37 00\t-29 57 54\t4900\n",
  "Name;ra;dec\nA;204.25;-29,9\nB;13:37:00;-29:57:54\n"
};

const std::vector<std::string> shellTexts = {
  "semi_major,axis_ratio_b,axis_ratio_c,position_angle,inclination\n0,1,0.9,350,-170\n"
  "2,0.8,0.7,190,170\n",
  "# sma[pc] b/a c/a PA\n0 1 0.9 10\n2000 0.8 0.7 20\n"
};

const std::vector<std::string> keys = { "[galaxy]\n", "[[component]]\n", "[component.spheroid]\n",
  "[component.dust]\n", "role = \"Absorbs\"\n", "\"Auto\"", "ring_columns", "rings", "= {", "= [" };
const std::vector<std::string> columns = { "ra", "dec", "x", "[pc]", "(Mpc)", "arcsec", "h", "r",
  "fwhm", "units:", "# ", "1e-300", "kpc" };

bool readWidths(const std::string& text, Random&)
{
  const std::vector<WidthAtRadius> rows = parseWidthTable(text, "some.txt");
  return !rows.empty() && std::all_of(rows.begin(), rows.end(), [](const WidthAtRadius& row) {
    return std::isfinite(row.radius) && std::isfinite(row.fwhm) && row.fwhm >= 0;
  });
}

bool areSound(const std::vector<StarCluster>& clusters)
{
  return !clusters.empty() &&
    std::all_of(clusters.begin(), clusters.end(), [](const StarCluster& cluster) {
      const Vec3& p = cluster.position;
      return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
        std::isfinite(cluster.luminosity) && std::isfinite(cluster.radius);
    });
}

bool readClusters(const std::string& text, Random&)
{
  return areSound(parseClusterList(text, "some.csv", { 204.25, -29.87 }, 4.9));
}

bool readShells(const std::string& text, Random&)
{
  const std::vector<EllipsoidShell> shells = parseEllipsoidShells(text, "some.csv");
  return std::all_of(shells.begin(), shells.end(), [](const EllipsoidShell& shell) {
    return std::isfinite(shell.semiMajor) && std::isfinite(shell.positionAngle) &&
      std::isfinite(shell.inclination);
  });
}

bool readGalaxy(const std::string& text, Random& random)
{
  NamedTexts tables = { { "widths", widthTexts[below(random, widthTexts.size())] },
    { "clusters", clusterTexts[below(random, clusterTexts.size())] } };
  for (auto& [name, table] : tables)
  {
    if (below(random, 4) == 0)
    {
      mutate(random, columns, table);
    }
  }
  const GalaxyDescription galaxy = parseGalaxyDescription(text, "some.galaxy", tables);
  return galaxy.distance > 0 &&
    std::all_of(galaxy.components.begin(), galaxy.components.end(),
      [](const ComponentDescription& component) {
        const std::vector<StarCluster>& listed = component.spheroid.listed;
        return listed.empty() || areSound(listed);
      });
}

bool readGroup(const std::string& text, Random&)
{
  return !parseGroupDescription(text, "some.galaxygroup").members.empty();
}
} // namespace
} // namespace galaxy

int main(int argc, char* argv[])
{
  using namespace galaxy;
  return fuzzTexts(argc, argv,
    { { "galaxy", galaxyTexts, keys, readGalaxy, 2 },
      { "galaxygroup", groupTexts, keys, readGroup }, { "widths", widthTexts, columns, readWidths },
      { "clusters", clusterTexts, columns, readClusters },
      { "shells", shellTexts, columns, readShells } });
}
