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

LayerLaw lawOf(const ThicknessDescription& thickness, const TiltedDisk& disk)
{
  if (thickness.model == ThicknessModel::Gaussian)
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
  , widthFactor(this->velocityFactor(disk.fastestRotation(0)))
{
}

double ThicknessProfile::scaleHeight(double r, double rotation) const
{
  switch (this->thickness.model)
  {
    case ThicknessModel::Gaussian:
      return this->thickness.sigma;
    case ThicknessModel::Tapered:
      return this->thickness.taperThickness
        ? this->thickness.scaleHeight * std::exp(-r / this->thickness.scaleLength)
        : this->thickness.scaleHeight;
    case ThicknessModel::Flared:
      return this->flaredWidth(r) / this->widthOfUnit;
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

double ThicknessProfile::velocityFactor(double rotation) const
{
  return this->thickness.rotationKnown
    ? std::pow(this->thickness.referenceVelocity / rotation, this->thickness.velocityExponent)
    : 1;
}

double ThicknessProfile::flaredWidth(double r) const
{
  const ThicknessDescription& t = this->thickness;
  if (!t.profileTable.empty())
  {
    return widthAt(t.profileTable, r);
  }
  const double base = r <= t.edgeRadius
    ? t.fwhmCentre + (t.fwhmEdge - t.fwhmCentre) * r / t.edgeRadius
    : t.fwhmEdge * std::exp((r - t.edgeRadius) / t.flareLength);
  const double width = base *
    (t.velocityScaling == VelocityScaling::Maximum
        ? this->widthFactor
        : this->velocityFactor(this->disk.fastestRotation(r)));
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
