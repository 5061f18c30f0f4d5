#ifndef galaxy_Background_h
#define galaxy_Background_h

#include "Readers/Formats/Image.h"

namespace galaxy
{
/// What an image shows of the empty sky, in its own unit.
struct SkyLevel
{
  double level = 0;
  double scatter = 0; ///< of its pixels, standard deviation
};

/// The sky under a galaxy, whatever else there is in the image: stars, margins and labels, blank or
/// constant borders, a gradient.
///
/// Bad and blank pixels take no part, nor do the borders that were padded with a constant. The rest
/// is cut into boxes (SkyBoxes.h), each with the mode and scatter of its pixels, of which those
/// count whose scatter is grain, without structure. Where boxes along the image's edge lie lowest,
/// a gap below the rest, they are a margin and left out. The sky is then the plane under the boxes:
/// the one that a fifth of them lie below (quantile regression), through those that scatter about
/// it as far as its lower side does, again and again, until they no longer change. Light only adds,
/// so that its level is where a tenth of these boxes would lie below it by chance; of a gradient it
/// is that in the image's middle.
///
/// An image that is constant but for its galaxy has that constant. 0 where all is blank.
SkyLevel skyOf(const Image& image);
} // namespace galaxy

#endif
