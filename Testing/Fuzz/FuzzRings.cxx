// FuzzRings COUNT SEED [FILES...|none]: tilted rings of every format, see TextFuzz.h.

#include "Readers/Formats/RingTable.h"
#include "Testing/Fuzz/TextFuzz.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
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
  // Other writings.
  "\xef\xbb\xbfr;vrot;Z0;i;PA\n10,5;80;2;55;350\n20;110;2;56;355\n",
  "| r | vrot | Z0 | i | PA |\n| real | real | real | real | real |\n"
  "| arcsec | km/s | arcsec | deg | deg |\n10  80  2  55  350\n20  110  2  56  355\n",
  "$r$ & $V_{\\rm rot}$ & $i$ & PA \\\\\n(kpc) & (km s$^{-1}$) & (deg) & (deg) \\\\\n"
  "\\hline\n10 & 100 & 45 & 80 \\\\\n",
  "# Column 1: r (kpc)\n# Column 2: V (km/s)\n# Column 3: PA (deg)\n# Column 4: inc\n1 2 3 4\n",
  "# r vrot Z0 i PA\n# kpc km/s kpc deg deg\n# radii in kpc\n1 80 0.1 55 10\n2 90 0.1 55 10\n",
  "Name\tr\tVrot\ti\tPA\n\tkpc\tkm/s\tdeg\tdeg\n---\t---\t---\t---\t---\n"
  "NGC 1\t1\t2\t3\t4\nNGC 1\t2\t2\t3\t4\nNGC 2\t1\t2\t3\t4\n",
  "Byte-by-byte Description of file: t.dat\n-----------\n Bytes Format Units Label Explanations\n"
  "-----------\n 1- 4 F4.1 kpc Rad Radius\n 6- 8 I3 km/s Vrot ?=-9 V\n 10-11 I2 deg Inc i\n"
  " 13-15 I3 deg PA p\n-----------\n 1.0 100 45 180\n 2.0 101 46 181\n",
  "rotcur: VERSION 2.13 [NEMO]\n radius systemic error rotation error position error inclination "
  "error x-position error y-position error\n (arcsec) (km/s)\n"
  " 10 500 0 101 1 80 0 45 0 63 0 63 0 100 5\n 20 500 0 102 1 80 0 45 0 63 0 63 0 100 5\n",
  "# rotcur: in=x\n# RAD VSYS XPOS YPOS VROT PA INC\n10 500 64 64 100 80 45\n",
  "#  Radius  Radius  Vsys  Vrot  Vexp  P.A.  Incl.  Xcenter  Ycenter\n"
  "#  [pix]  [arcs]  [KM/S]  [KM/S]  [KM/S]  [deg]  [deg]  [pix]  [pix]\n"
  " 5.00 20.00 650.00 101.00 2.00 80.00 45.00 64.00 63.00\n",
  "RADI= 0 10\n 20\nVROT= 1 # a # 2 3 # b\nINCL= 1 PA= 1\nXPOS= 06:07:12\nYPOS= -61d48m\n",
};

const std::vector<std::string> ringWords = { "(pc)", "[pix]", "kpc", "arcmin", "r", "vrot", "PA",
  "inc", "Z0", "Name", "NUR= 2147483647\n", "NDISKS= 1000\n",
  "RADI=", "VROT= ", "- {name: r, unit: ", "pixscale", "warp: T",
  "Column 1:", "units:", "radii in kpc\n", "1e-10", "Byte-by-byte", "?=9",
  "99999-99999 F4.1 kpc r x\n", "rotcur: ", "radius systemic width ", "(1) (2) (3)\n" };

RingOptions someOptions(Random& random)
{
  RingOptions options;
  options.disk = static_cast<int>(random() % 4) - 1 + (random() % 50 == 0 ? 2000000000 : 1);
  options.sides = static_cast<RingSides>(random() % 3);
  options.distance = random() % 2 ? 4.9 : random() % 2 ? 0 : 1e-300;
  options.galaxyName = random() % 8 ? "" : random() % 2 ? "NGC 1" : "NGC 3";
  if (random() % 8 == 0)
  {
    options.columns = { { "r", random() % 2 ? "Rad" : "r" }, { "vrot", "V" } };
  }
  options.pixelScale = random() % 2 ? 0 : random() % 2 ? 2 : 1e300;
  return options;
}

/// What every table that is read keeps to.
bool isSound(const RingTable& table)
{
  double before = 0;
  for (const Ring& ring : table.rings)
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
      [&](const RingColumn& c) { return c.values.size() == table.rings.size(); });
}

bool readRings(const std::string& text, Random& random)
{
  return isSound(parseRingTable(text, "some.rings", someOptions(random)));
}
} // namespace
} // namespace galaxy

int main(int argc, char* argv[])
{
  // They have the most formats.
  return galaxy::fuzzTexts(
    argc, argv, { { "rings", galaxy::ringTexts, galaxy::ringWords, galaxy::readRings, 8 } });
}
