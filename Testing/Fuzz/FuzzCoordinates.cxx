// FuzzCoordinates COUNT SEED [none]
//
// Makes COUNT broken headers, from ones with every kind of coordinates that it writes itself: stray
// keywords, other types of values, open quotes, D exponents, huge indices, alternates. Each becomes
// world coordinates or is refused with a galaxy::Error that says what to do. What a pixel sees must
// be a place on the sky that is seen in that pixel. A crash, another exception, a sanitizer's
// report or more time than a header needs is wrong, and ends the run; the header at fault is
// printed.

#include "Readers/Formats/WorldCoordinates.h"
#include "Testing/Instruction.h"

#include <sanitizer/common_interface_defs.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

// WCSLIB loses the matrix of a distortion that it rejects.
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:linset\n";
}

namespace
{
using Random = std::mt19937_64;
using Cards = std::vector<std::string>;

constexpr int imageSize = 32;

std::size_t below(Random& random, std::size_t count)
{
  return count == 0 ? 0 : random() % count;
}

std::string pick(Random& random, const std::vector<std::string>& choices)
{
  return choices[below(random, choices.size())];
}

std::string card(std::string keyword, const std::string& value)
{
  keyword.resize(8, ' ');
  std::string text = keyword + "= " + value;
  text.resize(80, ' ');
  return text;
}

Cards axes(const std::string& longitude, const std::string& latitude, const std::string& code)
{
  return { card("NAXIS", "2"), card("CTYPE1", "'" + longitude + code + "'"),
    card("CTYPE2", "'" + latitude + code + "'"), card("CRPIX1", "16.5"), card("CRPIX2", "16"),
    card("CRVAL1", "150.0"), card("CRVAL2", "20.0"), card("CDELT1", "-5D-4"),
    card("CDELT2", "5.0E-4") };
}

Cards joined(Cards cards, const Cards& more)
{
  cards.insert(cards.end(), more.begin(), more.end());
  return cards;
}

Cards plate()
{
  Cards cards = { card("PLTDECSN", "'-'"), card("EPOCH", "1977.2") };
  for (const char* keyword : { "PLTRAH", "PLTRAM", "PLTRAS", "PLTDECD", "PLTDECM", "PLTDECS" })
  {
    cards.push_back(card(keyword, "13"));
  }
  for (const char* keyword : { "CNPIX1", "CNPIX2" })
  {
    cards.push_back(card(keyword, "2332"));
  }
  for (const char* keyword : { "XPIXELSZ", "YPIXELSZ" })
  {
    cards.push_back(card(keyword, "25.28445"));
  }
  for (const char* keyword : { "PPO3", "PPO6" })
  {
    cards.push_back(card(keyword, "1.75E+05"));
  }
  for (const char* root : { "AMDX", "AMDY" })
  {
    cards.push_back(card(root + std::string("1"), "67.2"));
    cards.push_back(card(root + std::string("2"), "2.9E-2"));
    cards.push_back(card(root + std::string("3"), "1.9"));
    cards.push_back(card(root + std::string("11"), "8.1E-8"));
  }
  return cards;
}

std::vector<Cards> samples()
{
  std::vector<Cards> all;
  for (const char* code :
    { "TAN", "SIN", "NCP", "PCO", "ZPN", "AIT", "CAR", "GLS", "COE", "HPX", "CSC", "TPV", "BON" })
  {
    all.push_back(joined(axes("RA---", "DEC--", code),
      { card("PV2_1", "1.0"), card("PV2_2", "0.1"), card("EQUINOX", "'B1950.0'") }));
  }
  all.push_back(joined(axes("GLON-", "GLAT-", "TAN"), { card("CROTA2", "33.") }));
  all.push_back(joined(axes("RA---", "DEC--", "TAN-SIP"),
    { card("A_ORDER", "2"), card("B_ORDER", "3"), card("A_2_0", "2E-4"), card("A_1_1", "1.D-5"),
      card("B_0_2", "-1E-4"), card("B_1_2", "3E-6"), card("AP_ORDER", "2"), card("AP_2_0", "1") }));
  all.push_back(joined(axes("RA---", "DEC--", "TAN"),
    { card("PV1_1", "1.01"), card("PV2_1", "0.99"), card("PV1_4", "0.03"), card("PV2_10", "0.1"),
      card("PV1_39", "0.1") }));
  for (const char* code : { "TNX", "ZPX" })
  {
    const std::string type = code[0] == 'T' ? "tnx" : "zpx";
    Cards cards = axes("RA---", "DEC--", code);
    for (const char* start : { "WAT1_00", "WAT2_00" })
    {
      cards.push_back(card(std::string(start) + "1",
        "'wtype=" + type + " axtype=ra projp1=1. lngcor = \"3. 3. 3. 2. -0.1 0.1 -0.1'"));
      cards.push_back(card(std::string(start) + "2", "'0.1 1E-4 0. 1E-4 1E-4 0. 2E-4 \"'"));
    }
    all.push_back(cards);
  }
  all.push_back(joined({ card("NAXIS", "2") }, plate()));
  all.push_back(joined(axes("RA---", "DEC--", "TAN"), plate()));
  all.push_back(joined(axes("RA---", "DEC--", "TAN"),
    { card("CTYPE1A", "'GLON-CAR'"), card("CTYPE2A", "'GLAT-CAR'"), card("CRVAL1A", "12"),
      card("CD1_1A", "-1E-3"), card("CD2_2A", "1E-3"), card("RADESYSA", "'FK4'"),
      card("CTYPE3", "'VELO-LSR'"), card("CRPIX3", "4"), card("PC001003", "0.1"),
      card("CPDIS1", "'LOOKUP'"), card("CPERR1", "0.1") }));
  return all;
}

std::string someKeyword(Random& random)
{
  static const std::vector<std::string> whole = { "NAXIS", "WCSAXES", "LONPOLE", "LATPOLE",
    "RADESYS", "RADECSYS", "EQUINOX", "EPOCH", "SPECSYS", "SSYSOBS", "SSYSSRC", "VELREF", "WCSNAME",
    "DATE-OBS", "DATE-BEG", "DATEREF", "MJDREF", "MJDREFI", "JDREF", "MJD-OBS", "TIMESYS",
    "TREFPOS", "TIMEUNIT", "PLEPHEM", "OBSORBIT", "OBSGEO-X", "RSUN_REF", "HGLN_OBS", "RESTFRQ",
    "RESTFREQ", "RESTWAV", "VSOURCE", "ZSOURCE", "TIMEPIXR", "DVERR", "A_ORDER", "B_ORDER",
    "AP_ORDER", "BP_ORDER", "A_DMAX", "B_DMAX", "PLTRAH", "PLTRAM", "PLTRAS", "PLTDECSN", "PLTDECD",
    "PLTDECM", "PLTDECS", "PLATEID", "PPO3", "PPO6", "XPIXELSZ", "YPIXELSZ", "END", "HISTORY" };
  static const std::vector<std::string> roots = { "CTYPE", "CUNIT", "CRPIX", "CRVAL", "CDELT",
    "CROTA", "CNAME", "CRDER", "CSYER", "CZPHS", "CPERI", "CPDIS", "CQDIS", "CPERR", "D2IMDIS",
    "DP", "DQ", "CNPIX", "AMDX", "AMDY", "PROJP", "LTV" };
  static const std::vector<std::string> pairs = { "PC", "CD", "PV", "PS", "A_", "B_", "AP_", "BP_",
    "WAT", "LTM" };
  static const std::vector<std::string> indices = { "0", "1", "2", "3", "4", "13", "99", "100",
    "001", "002", "01", "-1", "65536", "" };
  std::string keyword;
  switch (below(random, 3))
  {
    case 0:
      keyword = pick(random, whole);
      break;
    case 1:
      keyword = pick(random, roots) + pick(random, indices);
      break;
    default:
      keyword = pick(random, pairs) + pick(random, indices) + "_" + pick(random, indices);
  }
  return keyword + (below(random, 8) == 0 ? pick(random, { "A", "B", "Z", "a" }) : "");
}

std::string someValue(Random& random)
{
  static const std::vector<std::string> values = { "0", "1", "2", "-1", "0.5", "-0.001", "16.5",
    "90", "-90", "180", "1E-5", "1.5D+2", "1d0", "1e30", "-1E300", "1E400", "1E-400", "inf", "nan",
    "65536", "2147483647", "-2147483648", "99999999999", "T", "F", "", "/ not known", "''", "' '",
    "'RA---TAN'", "'DEC--TAN'", "'ra---tan'", "'RA---TPV'", "'RA---TAB'", "'RA'", "'GLON-AIT'",
    "'GLAT-AIT'", "'XLON-TAN'", "'FREQ'", "'VELO-LSR'", "'LINEAR'", "'deg'", "'DEGREES'",
    "'arcsec'", "'10**3 (((m'", "'LOOKUP'", "'TPD'", "'SIP'", "'FK4'", "'FK5'", "'ICRS'", "'GAPPT'",
    "'J2000'", "'B1950.0'", "'2000-01-01'", "'1.5D-3'", "'+'", "'-'", "'NAXES: 2'", "'AXIS.99: 1'",
    "'SIP.FWD.9_9: 1'", "'EXTVER: 1.0'", "'wtype=zpx projp99=1'", "'wtype=tnx lngcor = \"'",
    "'wtype=tnxxxxxxxxxxxxxxxxx lngcor = \"3. 9. 9. 1. 0 0 0 0 1 \"'",
    "'3. 999999999. 99. 1. 1 1 1 1 '", "'no end", "'no end / comment", "'it''s'", "'''",
    "'\xff\x01'", "'A text that is longer than any value of a coordinate keyword may well be'",
    "(1.0, 2.0)" };
  return pick(random, values);
}

void change(Random& random, Cards& cards)
{
  const std::size_t at = below(random, cards.size());
  switch (below(random, 9))
  {
    case 0:
    case 1:
      cards[at] = card(cards[at].substr(0, 8), someValue(random));
      break;
    case 2:
    case 3:
    case 4:
      cards.insert(cards.begin() + static_cast<std::ptrdiff_t>(at),
        card(someKeyword(random), someValue(random)));
      break;
    case 5:
      cards.erase(cards.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 6: {
      std::string keyword = someKeyword(random);
      keyword.resize(8, ' ');
      cards[at].replace(0, 8, keyword);
      break;
    }
    case 7:
      cards[at][below(random, 80)] = static_cast<char>(random());
      break;
    default:
      cards.push_back(cards[at]);
      cards.back()[below(random, 12)] = static_cast<char>('0' + below(random, 43));
  }
}

/// Whether what each pixel sees is a place, and one that is seen in the pixel.
bool isSound(const galaxy::WorldCoordinates& world)
{
  for (double y = 1; y <= imageSize; y += 7.75)
  {
    for (double x = 1; x <= imageSize; x += 7.75)
    {
      galaxy::SkyPosition sky;
      galaxy::PixelPosition pixel;
      if (!world.pixelToSky({ x, y }, sky))
      {
        continue;
      }
      if (!(sky.ra >= 0 && sky.ra < 360 && std::abs(sky.dec) <= 90))
      {
        return false;
      }
      if (world.skyToPixel(sky, pixel) && !(std::isfinite(pixel.x) && std::isfinite(pixel.y)))
      {
        return false;
      }
    }
  }
  for (const galaxy::SkyPosition& sky :
    { galaxy::SkyPosition{ 150, 20 }, { 0, 90 }, { 359, -90 }, { 1e9, 0 } })
  {
    galaxy::PixelPosition pixel;
    if (world.skyToPixel(sky, pixel) && !(std::isfinite(pixel.x) && std::isfinite(pixel.y)))
    {
      return false;
    }
  }
  return true;
}

// Never freed: the sanitizers report leaks behind everything else.
std::string& current = *new std::string;

void printCurrent()
{
  for (std::size_t at = 0; at < current.size(); at += 80)
  {
    std::fprintf(stderr, "%s\n", current.substr(at, 80).c_str());
  }
}

void endOf(int signal)
{
  std::fprintf(stderr, "FuzzCoordinates: signal %d\n", signal);
  printCurrent();
  _exit(1);
}

/// 0 where the header is read, 1 where it is refused with an instruction; 2 for anything else.
int readOne()
{
  const std::array<int, 2> axes = { 1, 2 };
  try
  {
    return isSound(galaxy::WorldCoordinates("some.fits", current, imageSize, imageSize, axes)) ? 0
                                                                                               : 2;
  }
  catch (const galaxy::Error& error)
  {
    return galaxy::saysWhatToDo(error) ? 1 : 2;
  }
}
} // namespace

int main(int argc, char* argv[])
{
  constexpr unsigned mostSeconds = 20;
  const long count = argc > 1 ? std::atol(argv[1]) : 1000;
  const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  const std::vector<Cards> headers = samples();
  __sanitizer_set_death_callback(printCurrent);
  std::signal(SIGALRM, endOf);
  std::signal(SIGABRT, endOf);
  long read = 0;
  for (long i = 0; i < count; ++i)
  {
    Random random(seed * 1000003 + static_cast<unsigned long>(i));
    Cards cards = headers[below(random, headers.size())];
    for (std::size_t changes = below(random, 7); changes > 0 && !cards.empty(); --changes)
    {
      change(random, cards);
    }
    current.clear();
    for (const std::string& text : cards)
    {
      current += text;
    }
    alarm(mostSeconds);
    const int outcome = readOne();
    if (outcome > 1)
    {
      std::fprintf(stderr, "FuzzCoordinates: failed on header %ld of seed %lu:\n", i, seed);
      printCurrent();
      return EXIT_FAILURE;
    }
    read += outcome == 0;
  }
  std::printf("FuzzCoordinates: %ld headers, %ld read, %ld refused\n", count, read, count - read);
  return EXIT_SUCCESS;
}
