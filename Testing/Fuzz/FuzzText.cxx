// FuzzText COUNT SEED [FILES...|none]
//
// Makes COUNT broken texts of each kind that the program reads, from small ones written here and
// from FILES (ring models): tilted rings of every format, .galaxy and .galaxygroup descriptions,
// and reads each. A result or a galaxy::Error that says what to do is right; a crash, another
// exception, a sanitizer's report or more memory than a text needs is not, and ends the run. The
// text at fault is printed.

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/RingTable.h"
#include "Testing/Instruction.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

// Not a byte more than any text here could need.
extern "C" const char* __asan_default_options()
{
  return "max_allocation_size_mb=256:allocator_may_return_null=0";
}

namespace
{
using Random = std::mt19937_64;

const std::vector<std::string> ringTexts = {
  "# r vrot Z0 i PA\n0 150 29.9 23.7 227\n172 196 29.9 23.7 227\n343 200 29.9 24.7 226\n",
  "NDISKS= 2\nNUR= 3\n\tRADI= +0.0E+00 1.5D+01 30 # arcsec\nVROT= 0 50 100\nZ0= 3\n"
  "SBR= 1e-3 2e-3\nINCL= 60 61\nPA= 350 5\nAZ1P= 0\nAZ1W= 180\nVROT_2= 0 51 \\\n 99\nINCL_2= 60\n"
  "PA_2= 1\nAZ1P_2= 180\nAZ1W_2= 180\nLTYPE= 2\nLTYPE_2= 3\n# VROT_ERR= 1 2 3\nSDIS= 8\n",
  "! ROTCUR  version 1.4\n!   radius    width systemic  error\n! (arcsec) (arcsec)   (km/s)\n"
  "86 86 513.1 0 68.84 1.15 0 0 224.46 0 48.5 0 -1.58 0 1.37 0 232 9.71\n"
  "172 86 513.1 0 93.85 0.66 0 0 223.72 0 48.5 0 -1.58 0 1.37 0 466 7.83\n",
  "#RAD(Kpc) RAD(arcs) VROT(km/s) DISP(km/s) INC(deg) P.A.(deg) Z0(pc) Z0(arcs) SIG(E20)\n"
  "0.003 4.146 0.067 8.344 84.373 108.176 0.0 0.0 1.0\n"
  "0.010 12.439 2.592 8.097 86.814 105.791 0.0 0.0 1.0\n",
  "# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n# - {name: r, unit: kpc, datatype: float64}\n"
  "# - {name: vrot, unit: 'km / s', datatype: "
  "float64}\nr,vrot,i,pa,\"note\"\n0,1,2,3,a\n1,2,3,4,b\n",
  "r[arcmin], vrot (m/s), z0_pc, inc, pa, e\n0,1,2,3,4,5\n1,2,3,4,5,--\n",
  "Minimization output, vels\nvels.fits   pixscale  1.00 arcsec/pix\n"
  "vels toggles:    Vsys: T    warp: T      rw: T\nInput values\nBest fitting values\n"
  "disk PA, phi_d^prime (deg):   30.00 +/-  2.21\ndisk eps:   0.50 +/-  0.02\n"
  "Vsys (km/s):   100.00 +/-  0.23\nr_w (data units):   10.00 +/-  1.00\n"
  "Warp eps welm:   -0.40 +/-  0.02\nWarp PA wphim:   20.00 +/-  4.00\nMinimization Details\n"
  "Fitted velocity components\n r npts Vt eVt Vr eVr Vm,t eVm,t Vm,r eVm,r\n-------\n"
  "3.00 54.36 62.84 5.39 7.00 0.10 0.00 0.00 0.00 0.00\n"
  "9.00 64.36 117.66 6.15 0.00 0.00 0.00 0.00 0.00 0.00\n",
};

const std::vector<std::string> galaxyTexts = {
  "[galaxy]\nname = \"M 1\"\nra = 204.25\ndec = -29.87\ndistance = 4.9\nrings = \"a.def\"\n"
  "ring_disk = 1\nring_sides = \"Mean\"\nring_law = \"Sech2\"\nring_pixel_scale = 1.5\n"
  "spin = \"Clockwise\"\ninterpolation = \"Slerp\"\nbeyond_last_ring = \"HoldLast\"\nmock = true\n"
  "[image.r]\nfile = \"r.fits\"\nhdu = 1\nplane = 2\nbackground = \"Auto\"\n"
  "[image.b]\nfile = \"b.fits\"\nra = 1\ndec = 2\npixel_scale = 1\nreference_pixel = [1, 2]\n"
  "[[component]]\nname = \"stars\"\ntype = \"Disk\"\nparticles = 1000\n"
  "layers = [{ image = \"r\", color = [1, 0.5, 0.2], clip = [0, 9], stretch = \"Asinh\" }]\n"
  "[component.thickness]\nmodel = \"Rings\"\nchildren = 4\n"
  "[[component]]\nname = \"bulge\"\ntype = \"Spheroid\"\n[component.spheroid]\nsigma = [1, 1, 1]\n",
};

const std::vector<std::string> groupTexts = {
  "[group]\nname = \"G\"\nmagnification = 2\nseparation = 0.5\n"
  "[[member]]\ngalaxy = \"a.galaxy\"\n[[member]]\ngalaxy = \"b.galaxy\"\nmagnification = 3\n",
};

std::size_t below(Random& random, std::size_t count)
{
  return count == 0 ? 0 : random() % count;
}

const char* absurd(Random& random)
{
  static const char* const words[] = { "1e308", "-1e308", "1e-320", "-0", "nan", "inf", "0x10",
    "2147483647", "2147483648", "-2147483648", "9223372036854775808", "1e999", "1D5", "--", "\"",
    "'", "{", "}", "[", "]", "[[", "=", ",", ",,,,", "#", "!", "\\", "\t", "\r", "\n", "\xff", "_2",
    "_", "(", ")", "(pc)", "[pix]", "kpc", "*****", "1979-05-27", "\"\"\"", "NUR= 2147483647\n",
    "NDISKS= 1000\n", "- {name: , unit: ", "pixscale", "warp: T", "-----\n", "true", "1_000" };
  return words[below(random, sizeof words / sizeof *words)];
}

/// Where the cell that holds `at` begins and how long it is.
std::pair<std::size_t, std::size_t> cellAt(const std::string& text, std::size_t at)
{
  constexpr const char* ends = " \t\n,=";
  const std::size_t before = text.find_last_of(ends, at);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return { start, std::min(text.find_first_of(ends, start), text.size()) - start };
}

void change(Random& random, std::string& text)
{
  const std::size_t at = below(random, text.size());
  const auto [start, length] = cellAt(text, at);
  const std::size_t lineEnd = std::min(text.find('\n', at), text.size());
  switch (below(random, 9))
  {
    case 0:
      text[at] = static_cast<char>(random());
      break;
    case 1:
    case 2:
      text.replace(start, length, absurd(random));
      break;
    case 3:
      text.insert(at, absurd(random));
      break;
    case 4:
      text.erase(at, 1 + below(random, 9));
      break;
    case 5:
      text.resize(at);
      break;
    case 6: // a line again, or a part of one
      text.insert(at, text.substr(below(random, text.size()), 1 + below(random, 80)));
      break;
    case 7:
      text.erase(at, lineEnd - at);
      break;
    default: // very many cells
      text.insert(start, std::string(below(random, 2000), random() % 2 ? ',' : '9'));
  }
}

galaxy::RingOptions someOptions(Random& random)
{
  galaxy::RingOptions options;
  options.disk = static_cast<int>(random() % 4) - 1 + (random() % 50 == 0 ? 2000000000 : 1);
  options.sides = static_cast<galaxy::RingSides>(random() % 3);
  options.distance = random() % 2 ? 4.9 : random() % 2 ? 0 : 1e-300;
  options.pixelScale = random() % 2 ? 0 : random() % 2 ? 2 : 1e300;
  return options;
}

/// What every table that is read keeps to.
bool isSound(const galaxy::RingTable& table)
{
  double before = 0;
  for (const galaxy::Ring& ring : table.rings)
  {
    for (const double value :
      { ring.radius, ring.rotationVelocity, ring.scaleHeight, ring.inclination, ring.positionAngle,
        ring.expansionVelocity, ring.systemicVelocity, ring.surfaceBrightness })
    {
      if (!std::isfinite(value))
      {
        return false;
      }
    }
    if (ring.radius < before || ring.scaleHeight < 0)
    {
      return false;
    }
    before = ring.radius;
  }
  return !table.rings.empty() &&
    std::all_of(table.columns.begin(), table.columns.end(),
      [&](const galaxy::RingColumn& c) { return c.values.size() == table.rings.size(); });
}

struct Kind
{
  const char* name;
  std::vector<std::string> samples;
  bool (*read)(const std::string& text, Random& random);
};

/// Reads one text; false where what came back is neither a result nor an Error.
bool tryText(const Kind& kind, const std::string& text, Random& random, int& read)
{
  try
  {
    const bool sound = kind.read(text, random);
    ++read;
    return sound;
  }
  catch (const galaxy::Error& error)
  {
    return galaxy::saysWhatToDo(error);
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "%s\n", exception.what());
    return false;
  }
}

bool fuzz(const Kind& kind, int count, unsigned long long seed)
{
  int read = 0;
  for (int i = 0; i < count; ++i)
  {
    Random random(seed * 1000003 + static_cast<unsigned long long>(i));
    std::string text = kind.samples[static_cast<std::size_t>(i) % kind.samples.size()];
    for (std::size_t changes = below(random, 6); changes > 0 && !text.empty(); --changes)
    {
      change(random, text);
    }
    if (!tryText(kind, text, random, read))
    {
      std::fprintf(stderr, "%s, text %d of seed %llu:\n%s\n", kind.name, i, seed, text.c_str());
      return false;
    }
  }
  std::printf("%s: %d texts, %d read, the others refused\n", kind.name, count, read);
  return true;
}
} // namespace

int main(int argc, char* argv[])
{
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::vector<std::string> rings = ringTexts;
  for (int i = 3; i < argc; ++i)
  {
    if (std::string(argv[i]) != "none")
    {
      rings.push_back(galaxy::readText(argv[i]));
    }
  }
  const auto readRings = [](const std::string& text, Random& random) {
    return isSound(galaxy::parseRingTable(text, "some.rings", someOptions(random)));
  };
  const auto readGalaxy = [](const std::string& text, Random&) {
    return galaxy::parseGalaxyDescription(text, "some.galaxy").distance > 0;
  };
  const auto readGroup = [](const std::string& text, Random&) {
    return !galaxy::parseGroupDescription(text, "some.galaxygroup").members.empty();
  };
  bool good = true;
  // Rings have the most formats.
  good = good && fuzz({ "rings", rings, readRings }, count * 7, seed);
  good = good && fuzz({ "galaxy", galaxyTexts, readGalaxy }, count, seed);
  good = good && fuzz({ "galaxygroup", groupTexts, readGroup }, count, seed);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
