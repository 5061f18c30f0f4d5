#ifndef galaxy_SightLines_h
#define galaxy_SightLines_h

#include "Filters/Model/Particles.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <cstddef>

namespace galaxy
{
/// (D - Z)/D: what stands at the depth Z before the galaxy's centre, which is `distance` D away, is
/// so much nearer to the observer. Behind the observer there are no sight lines: 1.
inline double nearness(double distance, double z)
{
  return z < distance ? 1 - z / distance : 1;
}

/// Images are taken apart along parallel lines: what is seen at (X, Y) in the plane of the sky
/// through the galaxy's centre lies at (X, Y, Z). An observer at the distance D (kpc) sees that
/// point elsewhere; on the sight line through (X, Y) lies (X f, Y f, Z), f = (D - Z)/D. This moves
/// the particles from first to last - 1 there. With them go their smoothing lengths, h f, and their
/// luminosities or cross-sections, L f^2: the observer sees every particle where, as large and as
/// bright as the image has it. Velocities stay.
void moveToSightLines(double distance, Particles& particles, std::size_t first, std::size_t last);

/// Whether a galaxy's discs are to be moved: all of them where one has images, lest they part.
/// Without any they are what the description says, in kpc.
bool hasDiskWithImages(const GalaxyDescription& galaxy);
} // namespace galaxy

#endif
