#ifndef galaxy_OpticalDepth_h
#define galaxy_OpticalDepth_h

#include "Readers/Formats/Brightness.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace galaxy
{
/// An image as a calibration sees it.
struct DepthImage
{
  std::string name;      ///< for messages
  std::string unit;      ///< of its values, as in Image
  Brightness brightness; ///< brightnessOf it; unused where the unit is a column density
};

/// Whether a unit is a number of particles per cm^2, however it is written: "cm-2", "atoms/cm**2".
bool isColumnDensity(const std::string& unit);

/// The optical depth in V along the line of sight that an absorber's image stands for:
///   Given      optical_depth times the intensity;
///   FaceOn     the same across the plane, hence longer along the line of sight (pathThrough);
///   PAH8um     tau_ref I/<I> with I = I_8 - 0.232 I_3.6, the light of the hydrocarbons (Helou et
///              al. 2004; the mean within reference_radius from meanWithin). They are not all of
///              the dust: where starlight is harsh they perish;
///   Gas        dust_to_gas N_H/2.40e21 cm^-2 with N_H = N_HI + 2 N_H2, from N_H = 2.21e21 A_V
///              (Guever & Oezel 2009, to 4 %) and tau = A_V/1.086; helium is not counted. From
///              CO, N_H2 = X_CO times K km/s, to 30 % in discs like the Milky Way's (Bolatto et al.
///              2013);
///   Dust250um  v_over_250um I/B(T) of optically thin dust, B being Planck's law at 250 um. The
///              default ratio, 6500, is that of 4.90e-22 cm^2 in V and 7.53e-26 cm^2 at 250 um per
///              hydrogen atom in Draine's (2003) dust of R_V = 3.1 (absorption 4.0 cm^2 per gram of
///              dust at 250 um). Models and measurements differ by a factor of 2, and 20 K in place
///              of 25 K makes the depth 1.9 times as large.
class OpticalDepth
{
public:
  /// The image whose values operator() takes as `companion`; empty where it takes none.
  static const std::string& companionOf(const ComponentDescription& component);

  /// `image` is the component's layer, `companion` the one that companionOf names; Given and FaceOn
  /// need neither. Throws Error (file, component) naming the image whose unit does not fit, and
  /// where an image is missing.
  OpticalDepth(const ComponentDescription& component, const std::string& file,
    const DepthImage* image = nullptr, const DepthImage* companion = nullptr);

  /// What the depth is proportional to; not negative. NaN where the value is, while a companion
  /// that is NaN counts as 0.
  double signal(double value, double companion = 0) const
  {
    const double sum =
      this->perValue * value + (std::isnan(companion) ? 0 : this->perCompanion * companion);
    return sum < 0 ? 0 : sum;
  }

  /// Whether setReference must be called before the depth is known.
  bool needsReference() const { return this->calibration == DepthCalibration::PAH8um; }
  /// Tells the mean signal within reference_radius. Throws Error where it is not positive.
  void setReference(double meanSignal);

  /// `value` is the intensity with Given and FaceOn, the image's value else; `cosInclination`, 0 to
  /// 1, that of the disc at this place, which FaceOn alone looks at.
  double operator()(double value, double companion = 0, double cosInclination = 1) const
  {
    const double depth = this->perSignal * this->signal(value, companion);
    return this->calibration == DepthCalibration::FaceOn ? depth * pathThrough(cosInclination)
                                                         : depth;
  }

  /// The way through a disc along the line of sight over that across it: not 1/cos i, which has no
  /// end, but 1/sqrt(cos^2 i + q^2 sin^2 i), that of flattened ellipsoids whose axis ratio is
  /// q = 0.1 (as in Hubble's formula of the inclination), 10 where the disc is edge-on.
  static double pathThrough(double cosInclination)
  {
    constexpr double q2 = 0.1 * 0.1;
    const double cos2 = cosInclination * cosInclination;
    return 1 / std::sqrt(cos2 + q2 * (1 - cos2));
  }

private:
  void readPah(const DepthImage* image, const DepthImage* companion);
  void readGas(const DepthImage* image, const DepthImage* companion);
  void readDust(const DepthImage* image);
  [[noreturn]] void fail(const std::string& what) const;
  const DepthImage& given(const DepthImage* image) const;
  double surfaceFactor(const DepthImage& image) const;

  std::string file;
  std::string component;
  DepthDescription description;
  DepthCalibration calibration;
  double perValue = 1;
  double perCompanion = 0;
  double perSignal;
};

/// The mean of value(k) over the k below `count` where radius(k) is at most `largest`; NaN values
/// are left out. NaN where nothing is left.
template <class Radius, class Value>
double meanWithin(std::size_t count, double largest, const Radius& radius, const Value& value)
{
  double sum = 0;
  std::size_t n = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    if (radius(k) <= largest)
    {
      const double v = value(k);
      sum += std::isnan(v) ? 0 : v;
      n += std::isnan(v) ? 0 : 1;
    }
  }
  return sum / static_cast<double>(n);
}

/// Planck's law at 250 um: the brightness of a black body of this temperature (K), Jy/sr.
double blackBodyAt250um(double temperature);
} // namespace galaxy

#endif
