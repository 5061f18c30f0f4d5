#ifndef galaxy_FitsPixels_h
#define galaxy_FitsPixels_h

#include "Readers/Formats/FitsCube.h"
#include "Readers/Formats/FitsFile.h"
#include "Readers/Formats/FitsHandle.h"

namespace galaxy
{
/// Fills `image.values` by the plan, a chunk of pixels after the other in the file's order.
/// Throws Error where CFITSIO fails, Aborted where `progress` says so.
void readPixels(const FitsHandle& fits, const FitsHdu& hdu, const FitsPlan& plan,
  const std::vector<double>& maskValues, const Progress& progress, Image& image);
} // namespace galaxy

#endif
