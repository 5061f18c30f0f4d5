#include "Readers/Formats/BrightnessUnit.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <vector>

namespace galaxy
{
namespace
{
struct Factor
{
  std::string name;
  int power = 1;
};

struct Product
{
  double number = 1;
  std::vector<Factor> factors;

  /// Takes out the factor of one of these names, small letters, and this power.
  bool take(std::initializer_list<const char*> names, int power);
};

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool Product::take(std::initializer_list<const char*> names, int power)
{
  for (auto factor = this->factors.begin(); factor != this->factors.end(); ++factor)
  {
    for (const char* name : names)
    {
      if (factor->power == power && lowered(factor->name) == name)
      {
        this->factors.erase(factor);
        return true;
      }
    }
  }
  return false;
}

/// The whole power behind a name: "2", "-1", "^2", "**(-2)"; moves `at` behind it. 1 where none is.
int powerAt(const std::string& text, std::size_t& at)
{
  std::size_t end = at;
  while (end < text.size() && (text[end] == '^' || text[end] == '*' || text[end] == '('))
  {
    ++end;
  }
  char* behind = nullptr;
  const long power = std::strtol(text.c_str() + end, &behind, 10);
  const std::size_t digits = static_cast<std::size_t>(behind - text.c_str());
  if (digits == end || (end < text.size() && text[end] == ' ') || std::labs(power) > 99)
  {
    return 1;
  }
  at = digits;
  return static_cast<int>(power);
}

/// Names and numbers with their powers; "/" divides by the next one only, as in FITS.
Product productOf(const std::string& text)
{
  Product product;
  int sign = 1;
  for (std::size_t at = 0; at < text.size();)
  {
    const auto c = static_cast<unsigned char>(text[at]);
    if (std::isdigit(c))
    {
      char* behind = nullptr;
      const double number = std::strtod(text.c_str() + at, &behind);
      at = static_cast<std::size_t>(behind - text.c_str());
      product.number *= std::pow(number, sign * powerAt(text, at));
      sign = 1;
    }
    else if (std::isalpha(c) || c >= 0x80)
    {
      const std::size_t start = at;
      while (at < text.size() &&
        (std::isalpha(static_cast<unsigned char>(text[at])) || (text[at] & 0x80) != 0))
      {
        ++at;
      }
      const std::string name = text.substr(start, at - start);
      const int power = powerAt(text, at);
      product.factors.push_back({ name, sign * power });
      sign = 1;
    }
    else
    {
      sign = c == '/' ? -1 : sign;
      ++at;
    }
  }
  return product;
}

double scaleOfPrefix(const std::string& prefix)
{
  struct Prefix
  {
    const char* name;
    double scale;
  };
  static const Prefix prefixes[] = { { "", 1 }, { "m", 1e-3 }, { "u", 1e-6 }, { "\xc2\xb5", 1e-6 },
    { "n", 1e-9 }, { "k", 1e3 }, { "K", 1e3 }, { "M", 1e6 } };
  for (const Prefix& known : prefixes)
  {
    if (prefix == known.name)
    {
      return known.scale;
    }
  }
  return 0;
}

/// Takes out a jansky or a kelvin with its prefix; returns its scale, 0 where there is none.
/// In all capitals, MJY is a millijansky but per steradian.
double takeQuantity(Product& product, const char* symbol, const char* word, bool perSteradian)
{
  for (auto factor = product.factors.begin(); factor != product.factors.end(); ++factor)
  {
    const std::string name = lowered(factor->name);
    const std::size_t length = std::string(symbol).size();
    double scale = name.rfind(word, 0) == 0 ? 1 : 0;
    if (name.size() >= length && name.compare(name.size() - length, length, symbol) == 0)
    {
      std::string prefix = factor->name.substr(0, name.size() - length);
      const bool capitals = length > 1 && factor->name.substr(prefix.size()) == "JY";
      scale = scaleOfPrefix(capitals && prefix == "M" && !perSteradian ? "m" : prefix);
    }
    if (factor->power == 1 && scale > 0)
    {
      product.factors.erase(factor);
      return scale;
    }
  }
  return 0;
}

bool takeVelocity(Product& product, double& scale)
{
  Product left = product;
  if (!left.take({ "s", "sec" }, -1))
  {
    return false;
  }
  if (left.take({ "m" }, 1))
  {
    scale *= 1e-3;
  }
  else if (!left.take({ "km" }, 1))
  {
    return false;
  }
  product = left;
  return true;
}

bool isCount(const std::string& name)
{
  for (const char* known :
    { "count", "ct", "cts", "adu", "dn", "electron", "photon", "e", "nmgy", "nanomagg" })
  {
    const std::string word = lowered(name);
    if (word == known || (std::string(known).size() > 3 && word.rfind(known, 0) == 0))
    {
      return true;
    }
  }
  return false;
}

std::string written(const Product& product)
{
  std::string text;
  for (const Factor& factor : product.factors)
  {
    text += factor.power < 0 ? "/" : (text.empty() ? "" : " ");
    text += factor.name;
    text += std::abs(factor.power) == 1 ? "" : std::to_string(std::abs(factor.power));
  }
  return text;
}
/// "(mJy/beam)**2"
bool isPowerOfAll(const std::string& text)
{
  return text.find(")**") != std::string::npos || text.find(")^") != std::string::npos;
}

bool isLogarithm(const std::string& quantity)
{
  return lowered(quantity).rfind("mag", 0) == 0;
}
} // namespace

BrightnessUnit parseBrightnessUnit(const std::string& text)
{
  constexpr double squareArcsecPerSteradian = 206264.80624709636 * 206264.80624709636;
  Product product = productOf(text);
  BrightnessUnit unit;
  const bool perBeam = product.take({ "beam", "beams", "bm" }, -1);
  const bool perSteradian = product.take({ "sr", "ster", "steradian" }, -1);
  const bool perArcsec = product.take({ "arcsec" }, -2) || product.take({ "sqarcsec" }, -1);
  const bool perPixel = product.take({ "pixel", "pix", "pixels" }, -1);
  unit.scale = product.number / (perSteradian ? squareArcsecPerSteradian : 1);
  const double jansky = takeQuantity(product, "jy", "jansky", perSteradian);
  const double kelvin = jansky > 0 ? 0 : takeQuantity(product, "k", "kelvin", false);
  const bool isVelocity = jansky == 0 && kelvin == 0 && !perBeam;
  unit.isIntegrated = !isVelocity && takeVelocity(product, unit.scale);
  product.take({ "tmb", "ta", "tb" }, 1);
  unit.scale *= jansky > 0 ? jansky : (kelvin > 0 ? kelvin : 1);

  const std::string rest = written(product);
  unit.quantity = (jansky > 0 ? "Jy" : kelvin > 0 ? "K" : "") + rest;
  if (isPowerOfAll(text) || isLogarithm(rest))
  {
    unit.kind = BrightnessKind::NotBrightness;
  }
  else if (perBeam || perSteradian || perArcsec || perPixel)
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
    const bool counts = rest.empty() || isCount(product.factors.front().name);
    unit.kind = counts ? BrightnessKind::PerPixel : BrightnessKind::NotBrightness;
  }
  return unit;
}
} // namespace galaxy
