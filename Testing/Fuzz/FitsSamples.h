#ifndef galaxy_FitsSamples_h
#define galaxy_FitsSamples_h

#include <string>
#include <vector>

namespace galaxy
{
/// The bytes of small sound FITS files of every kind: all types of pixels, cubes with and without
/// velocities, extensions, tables, tile-compressed by every method, gzipped as a whole. They are
/// written in `folder` and removed.
std::vector<std::string> fitsSamples(const std::string& folder);
} // namespace galaxy

#endif
