#include "Readers/Formats/GalaxyKeys.h"

namespace galaxy
{
namespace
{
/// n = 2 parts pseudobulges from classical ones (Fisher and Drory 2008), R_e is 0.5 to 1 kpc
/// (Gadotti 2009); most are flattened.
SpheroidDescription bulge()
{
  SpheroidDescription s;
  s.profile = SpheroidProfile::Sersic;
  s.sersicIndex = 2;
  s.effectiveRadius = 0.7;
  s.axisRatios = { 1, 0.7 };
  return s;
}

/// The Milky Way's density falls with exponents from 2.5 inside to 3.8 outside 25 kpc, and is
/// flattened by 0.65 to 0.8 (Bland-Hawthorn and Gerhard 2016).
SpheroidDescription stellarHalo()
{
  SpheroidDescription s;
  s.profile = SpheroidProfile::Cored;
  s.slope = 3.5;
  s.scaleRadius = 2;
  s.axisRatios = { 1, 0.7 };
  s.truncation = 100;
  return s;
}

/// A halo of 1e12 solar masses (Navarro, Frenk and White 1997), dark.
SpheroidDescription darkHalo()
{
  SpheroidDescription s;
  s.profile = SpheroidProfile::NFW;
  s.scaleRadius = 20;
  s.concentration = 10;
  s.centralBrightness = 0;
  return s;
}

/// de Vaucouleurs' (1948) law.
SpheroidDescription elliptical()
{
  SpheroidDescription s;
  s.profile = SpheroidProfile::Sersic;
  s.sersicIndex = 4;
  s.effectiveRadius = 5;
  s.axisRatios = { 0.9, 0.7 };
  return s;
}

/// Half-light radius and flattening of the Local Group's (McConnachie 2012).
SpheroidDescription dwarfSpheroidal()
{
  SpheroidDescription s;
  s.profile = SpheroidProfile::Plummer;
  s.scaleRadius = 0.3;
  s.axisRatios = { 1, 0.7 };
  return s;
}

/// n from 1 to 2 (Binggeli and Jerjen 1998).
SpheroidDescription dwarfElliptical()
{
  SpheroidDescription s;
  s.profile = SpheroidProfile::Sersic;
  s.sersicIndex = 1.5;
  s.effectiveRadius = 1;
  s.axisRatios = { 1, 0.7 };
  return s;
}

/// An exponential as thick as half its width (Roychowdhury et al. 2010).
SpheroidDescription dwarfIrregular()
{
  SpheroidDescription s;
  s.profile = SpheroidProfile::Exponential;
  s.scaleRadius = 0.5;
  s.axisRatios = { 1, 0.55 };
  return s;
}
} // namespace

SpheroidDescription spheroidPreset(SpheroidPreset preset)
{
  switch (preset)
  {
    case SpheroidPreset::Bulge:
      return bulge();
    case SpheroidPreset::StellarHalo:
      return stellarHalo();
    case SpheroidPreset::DarkHalo:
      return darkHalo();
    case SpheroidPreset::Elliptical:
      return elliptical();
    case SpheroidPreset::DwarfSpheroidal:
      return dwarfSpheroidal();
    case SpheroidPreset::DwarfElliptical:
      return dwarfElliptical();
    case SpheroidPreset::DwarfIrregular:
      return dwarfIrregular();
    default:
      return {};
  }
}
} // namespace galaxy
