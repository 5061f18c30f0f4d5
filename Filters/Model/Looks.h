#ifndef galaxy_Looks_h
#define galaxy_Looks_h

#include "Filters/Model/Particles.h"

#include <vector>

namespace galaxy
{
/// What of a galaxy is shown, and in which colours.
enum class Look
{
  AsDescribed, ///< all, as the .galaxy file says
  Optical,     ///< stars, ionized gas and dust
  HAlpha,      ///< ionized gas behind its dust, red; young stars where there is none
  AtomicGas,   ///< what a radio telescope sees of it, through any dust
  Ultraviolet, ///< young stars, behind dust that absorbs 2.6 times as much as in the visible
  DustOnly,    ///< its optical depth as if it were light
  FalseColor,  ///< all, a colour for each kind of matter
};

/// Changes a component table, and hides what the look does not show. What the components' names do
/// not tell (kindOf) is taken for stars.
void applyLook(Look look, std::vector<ComponentInfo>& components, std::vector<bool>& visible);
} // namespace galaxy

#endif
