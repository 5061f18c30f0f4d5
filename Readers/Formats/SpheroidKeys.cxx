#include "Readers/Formats/GalaxyKeys.h"

namespace galaxy
{
const Keys<SpheroidDescription>& spheroidKeys()
{
  using S = SpheroidDescription;
  static const Keys<S> keys = {
    listKey<S>(
      "sigma", &S::sigma, Range::positive(), "kpc", "Standard deviations along the three axes."),
    flagKey<S>("tilted", &S::tilted,
      "Whether the axes are the innermost ring's rather than the sky's West, North and depth."),
    numberKey<S>("central_brightness", &S::centralBrightness, Range::notNegative(), "",
      "Brightness at the centre, seen along the third axis, where a layer's intensity 1 is 1."),
  };
  return keys;
}
} // namespace galaxy
