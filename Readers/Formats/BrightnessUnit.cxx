#include "Readers/Formats/BrightnessUnit.h"

#include "Readers/Formats/UnitProduct.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

namespace galaxy
{
namespace
{
bool isOneOf(const std::string& name, std::initializer_list<const char*> names)
{
  return std::any_of(names.begin(), names.end(), [&](const char* known) { return name == known; });
}

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// How many Jy or K a name with its prefix is; 0 where it is none. In all capitals, MJY is a
/// millijansky but per steradian.
double scaleOf(const std::string& name, const std::string& symbol, bool perSteradian)
{
  std::string prefix = name.substr(0, name.size() - symbol.size());
  const bool capitals = symbol == "Jy" && endsWith(name, "JY");
  if (prefix == "\xc2\xb5" || prefix == "\xb5" || (capitals && prefix == "U"))
  {
    prefix = "u";
  }
  if (capitals && prefix == "M" && !perSteradian)
  {
    prefix = "m";
  }
  if (prefix == "K")
  {
    prefix = "k";
  }
  return unitRatio(prefix + symbol, symbol);
}

/// Takes out a jansky or a kelvin with its prefix; returns its scale, 0 where there is none.
double takeQuantity(
  UnitProduct& product, const std::string& symbol, const char* word, bool perSteradian)
{
  for (auto factor = product.factors.begin(); factor != product.factors.end(); ++factor)
  {
    const std::string name = lowerCase(factor->name);
    const double scale = name.rfind(word, 0) == 0 ? 1
      : endsWith(name, lowerCase(symbol))         ? scaleOf(factor->name, symbol, perSteradian)
                                                  : 0;
    if (factor->power == 1 && scale > 0)
    {
      product.factors.erase(factor);
      return scale;
    }
  }
  return 0;
}

/// Takes out a velocity; `scale` becomes km/s.
bool takeVelocity(UnitProduct& product, double& scale)
{
  if (product.take({ "kms" }, 1))
  {
    return true;
  }
  UnitProduct left = product;
  const bool isMetre = left.take({ "s", "sec" }, -1) && left.take({ "m" }, 1);
  if (!isMetre)
  {
    left = product;
    if (!left.take({ "s", "sec" }, -1) || !left.take({ "km" }, 1))
    {
      return false;
    }
  }
  scale *= isMetre ? 1e-3 : 1;
  product = left;
  return true;
}

/// Takes out what a value is per, on the sky. Returns arcsec^2; 0 where it is per no solid angle.
double takeSolidAngle(UnitProduct& product)
{
  constexpr double perDegree = 3600, perArcmin = 60, perRadian = 206264.80624709636;
  if (product.take({ "sr", "ster", "sterad", "steradian", "steradians" }, -1) ||
    product.take({ "rad" }, -2))
  {
    return perRadian * perRadian;
  }
  if (product.take({ "arcsec", "asec", "arcseconds" }, -2) ||
    product.take({ "sqarcsec", "arcsecsq" }, -1))
  {
    return 1;
  }
  if (product.take({ "arcmin" }, -2) || product.take({ "sqarcmin" }, -1))
  {
    return perArcmin * perArcmin;
  }
  UnitProduct left = product;
  const bool isSquare = left.take({ "sq", "square" }, -1);
  if (isSquare && (left.take({ "arcsec" }, 1) || left.take({ "arcsec" }, -1))) // "/sq.arcsec"
  {
    product = left;
    return 1;
  }
  return product.take({ "deg" }, -2) || product.take({ "sqdeg" }, -1) ? perDegree * perDegree : 0;
}

bool isCount(const std::string& name)
{
  for (const char* known : { "count", "electron", "photon", "nanomagg", "maggies" })
  {
    if (name.rfind(known, 0) == 0)
    {
      return true;
    }
  }
  return isOneOf(name, { "ct", "cts", "adu", "dn", "e", "nmgy" });
}

/// A flux or a flux density: energy by time and area, by wavelength or frequency as well.
bool isFlux(const UnitProduct& product)
{
  const auto is = [](const UnitFactor& factor, std::initializer_list<const char*> names) {
    return isOneOf(lowerCase(factor.standard), names);
  };
  const bool isEnergy = !product.factors.empty() && product.factors.front().power == 1 &&
    is(product.factors.front(), { "erg", "ergs", "j", "w", "watt", "watts" });
  return isEnergy &&
    std::all_of(product.factors.begin() + 1, product.factors.end(), [&](const UnitFactor& factor) {
      return factor.power < 0 &&
        is(factor,
          { "s", "sec", "cm", "m", "a", "aa", "ang", "angstrom", "nm", "um", "micron", "microns",
            "hz", "ghz" });
    });
}
bool isLogarithm(const std::string& quantity)
{
  return lowerCase(quantity).rfind("mag", 0) == 0;
}
} // namespace

BrightnessUnit parseBrightnessUnit(const std::string& text)
{
  UnitProduct product = parseUnitProduct(text);
  BrightnessUnit unit;
  bool perBeam = product.take({ "beam", "beams", "bm" }, -1);
  const bool perSteradian = UnitProduct(product).take({ "sr", "ster", "sterad" }, -1);
  const double solidAngle = takeSolidAngle(product);
  const bool perPixel = product.take({ "pixel", "pix", "pixels", "pxl", "spaxel", "spaxels" }, -1);
  const double jansky = takeQuantity(product, "Jy", "jansky", perSteradian);
  perBeam = perBeam || (jansky > 0 && product.take({ "b" }, -1)); // AIPS
  const double kelvin = jansky > 0 ? 0 : takeQuantity(product, "K", "kelvin", false);
  unit.scale = product.number / (solidAngle > 0 ? solidAngle : 1);
  const bool isVelocity = jansky == 0 && kelvin == 0 && !perBeam;
  unit.isIntegrated = !isVelocity && takeVelocity(product, unit.scale);
  product.take({ "tmb", "ta", "tb" }, 1);
  unit.scale *= jansky > 0 ? jansky : (kelvin > 0 ? kelvin : 1);

  const std::string rest = product.written();
  unit.quantity = (jansky > 0 ? "Jy" : kelvin > 0 ? "K" : "") + rest;
  if (product.hasPowerOfAll || isLogarithm(rest))
  {
    unit.kind = BrightnessKind::NotBrightness;
  }
  else if (perBeam || solidAngle > 0 || perPixel)
  {
    unit.kind = perBeam ? BrightnessKind::PerBeam
      : perPixel        ? BrightnessKind::PerPixel
                        : BrightnessKind::PerSolidAngle;
  }
  else if (kelvin > 0 && rest.empty())
  {
    unit.kind = BrightnessKind::Temperature;
  }
  else
  {
    const bool isAmount =
      rest.empty() || isCount(lowerCase(product.factors.front().name)) || isFlux(product);
    unit.kind = isAmount ? BrightnessKind::PerPixel : BrightnessKind::NotBrightness;
  }
  return unit;
}
} // namespace galaxy
