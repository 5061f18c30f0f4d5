#include "Filters/Model/ThicknessProfile.h"

#include "Filters/Model/VerticalLaw.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
/// pc (km/s)^2 / Msun
constexpr double G = 4.30091e-3;

/// Whether the children spread alike in all directions.
bool isIsotropic(const ThicknessDescription& thickness)
{
  return thickness.model == ThicknessModel::Gaussian ||
    (thickness.model == ThicknessModel::Tapered && thickness.reading == TaperReading::Literal);
}

LayerLaw lawOf(const ThicknessDescription& thickness, const TiltedDisk& disk)
{
  if (isIsotropic(thickness))
  {
    return LayerLaw::Gaussian;
  }
  return thickness.model == ThicknessModel::Rings ? disk.layerLaw() : thickness.law;
}

/// Linear between the rows, constant beyond the first and the last.
double widthAt(const std::vector<WidthAtRadius>& rows, double r)
{
  const auto after = std::upper_bound(rows.begin(), rows.end(), r,
    [](double radius, const WidthAtRadius& row) { return radius < row.radius; });
  if (after == rows.begin() || after == rows.end())
  {
    return after == rows.end() ? rows.back().fwhm : rows.front().fwhm;
  }
  const auto before = after - 1;
  const double t = (r - before->radius) / (after->radius - before->radius);
  return (1 - t) * before->fwhm + t * after->fwhm;
}
} // namespace

ThicknessProfile::ThicknessProfile(const ThicknessDescription& thickness, const TiltedDisk& disk)
  : thickness(thickness)
  , disk(disk)
  , verticalLaw(lawOf(thickness, disk))
  , widthOfUnit(fwhmHeight(this->verticalLaw))
{
}

double ThicknessProfile::scaleHeight(double r, double rotation) const
{
  if (isIsotropic(this->thickness))
  {
    return this->thickness.sigma;
  }
  switch (this->thickness.model)
  {
    case ThicknessModel::Tapered:
      return this->thickness.taperThickness
        ? this->thickness.scaleHeight * std::exp(-r / this->thickness.scaleLength)
        : this->thickness.scaleHeight;
    case ThicknessModel::Flared:
      return this->flaredWidth(r, rotation) / this->widthOfUnit;
    case ThicknessModel::Hydrostatic:
      return this->hydrostaticDispersion(r, rotation) * fwhmHeight(LayerLaw::Gaussian) /
        this->widthOfUnit;
    default:
      return this->disk.scaleHeight(r);
  }
}

double ThicknessProfile::meanChildren(double r, double intensity) const
{
  switch (this->thickness.model)
  {
    case ThicknessModel::Gaussian:
      return this->thickness.children * std::pow(intensity, 1 - this->thickness.compression);
    case ThicknessModel::Tapered:
      return this->thickness.children * std::exp(-r / this->childrensScaleLength());
    default:
      return this->thickness.children;
  }
}

double ThicknessProfile::childrensScaleLength() const
{
  return this->thickness.reading == TaperReading::Literal ? this->thickness.scaleHeight
                                                          : this->thickness.scaleLength;
}

double ThicknessProfile::flaredWidth(double r, double rotation) const
{
  const ThicknessDescription& t = this->thickness;
  if (!t.profileTable.empty())
  {
    return widthAt(t.profileTable, r);
  }
  const double base = r <= t.edgeRadius
    ? t.fwhmCentre + (t.fwhmEdge - t.fwhmCentre) * r / t.edgeRadius
    : t.fwhmEdge * std::exp((r - t.edgeRadius) / t.flareLength);
  const double ratio = t.referenceVelocity / std::abs(rotation);
  // Most discs have the paper's exponent, which pow need not be asked for.
  const double scale = t.velocityExponent == 1 ? ratio : std::pow(ratio, t.velocityExponent);
  const double width = scale * base;
  // Also where 0 width meets 0 velocity, which is NaN.
  return width < t.fwhmMaximum ? width : t.fwhmMaximum;
}

double ThicknessProfile::hydrostaticDispersion(double r, double rotation) const
{
  const ThicknessDescription& t = this->thickness;
  const double pc = 1000;
  const double softening = 0.1;
  const double most = this->disk.lastRadius();
  const double haloFrequency2 = rotation * rotation / ((r * r + softening * softening) * pc * pc);
  const double starFrequency2 =
    4 * pi * G * t.stellarSurfaceDensity * std::exp(-r / t.scaleLength) / (2 * t.scaleHeight * pc);
  const double B = 4 * pi * G * t.gasSurfaceDensity / std::sqrt(2 * pi);
  const double sigma2 = t.gasDispersion * t.gasDispersion;
  const double dispersion =
    2 * sigma2 / (B + std::sqrt(B * B + 4 * (haloFrequency2 + starFrequency2) * sigma2)) / pc;
  return dispersion < most ? dispersion : most;
}
} // namespace galaxy
