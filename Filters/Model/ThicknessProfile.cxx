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
  switch (thickness.model)
  {
    case ThicknessModel::Gaussian:
      return LayerLaw::Gaussian;
    case ThicknessModel::Rings:
      return disk.layerLaw();
    default:
      return thickness.law;
  }
}
} // namespace

ThicknessProfile::ThicknessProfile(const ThicknessDescription& thickness, const TiltedDisk& disk)
  : thickness(thickness)
  , disk(disk)
  , verticalLaw(lawOf(thickness, disk))
  , widthOfUnit(fwhmHeight(this->verticalLaw))
{
}

double ThicknessProfile::scaleHeight(double r) const
{
  switch (this->thickness.model)
  {
    case ThicknessModel::Tapered:
      return this->thickness.taperThickness
        ? this->thickness.scaleHeight * std::exp(-r / this->thickness.scaleLength)
        : this->thickness.scaleHeight;
    case ThicknessModel::Flared:
      return this->flaredWidth(r) / this->widthOfUnit;
    case ThicknessModel::Hydrostatic:
      return this->hydrostaticDispersion(r) * fwhmHeight(LayerLaw::Gaussian) / this->widthOfUnit;
    case ThicknessModel::Rings:
      return this->disk.scaleHeight(r);
    case ThicknessModel::Gaussian:
      break;
  }
  return this->thickness.sigma;
}

double ThicknessProfile::meanChildren(double r, double intensity) const
{
  switch (this->thickness.model)
  {
    case ThicknessModel::Gaussian:
      return this->thickness.children * std::pow(intensity, 1 - this->thickness.compression);
    case ThicknessModel::Tapered:
      return this->thickness.children * std::exp(-r / this->thickness.scaleLength);
    default:
      return this->thickness.children;
  }
}

double ThicknessProfile::flaredWidth(double r) const
{
  const ThicknessDescription& t = this->thickness;
  const double base = r <= t.edgeRadius
    ? t.fwhmCentre + (t.fwhmEdge - t.fwhmCentre) * r / t.edgeRadius
    : t.fwhmEdge * std::exp((r - t.edgeRadius) / t.flareLength);
  const double ratio = t.referenceVelocity / std::abs(this->disk.rotationVelocity(r));
  const double width = std::pow(ratio, t.velocityExponent) * base;
  // Also where 0 width meets 0 velocity, which is NaN.
  return width < t.fwhmMaximum ? width : t.fwhmMaximum;
}

double ThicknessProfile::hydrostaticDispersion(double r) const
{
  const ThicknessDescription& t = this->thickness;
  const double pc = 1000;
  const double softening = 0.1;
  const double most = this->disk.lastRadius();
  const double velocity = this->disk.rotationVelocity(r);
  const double haloFrequency2 = velocity * velocity / ((r * r + softening * softening) * pc * pc);
  const double starFrequency2 =
    4 * pi * G * t.stellarSurfaceDensity * std::exp(-r / t.scaleLength) / (2 * t.scaleHeight * pc);
  const double B = 4 * pi * G * t.gasSurfaceDensity / std::sqrt(2 * pi);
  const double sigma2 = t.gasDispersion * t.gasDispersion;
  const double dispersion =
    2 * sigma2 / (B + std::sqrt(B * B + 4 * (haloFrequency2 + starFrequency2) * sigma2)) / pc;
  return dispersion < most ? dispersion : most;
}
} // namespace galaxy
