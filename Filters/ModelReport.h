#ifndef galaxy_ModelReport_h
#define galaxy_ModelReport_h

#include <string>

namespace galaxy
{
struct BuildReport;

/// How a model was built, a line a component and one more for each of its images.
std::string inWords(const BuildReport& report);

/// The same as a JSON list, with the seconds of each stage. Bytes of names that are no UTF-8 become
/// U+FFFD, numbers that are none null.
std::string asJSON(const BuildReport& report);

/// The spheroids that could not take all the light that they were to take, and how much they did.
std::string shortOnes(const BuildReport& report);

/// The components without particles that have light or, where `haveSeeds`, whose every seed fell on
/// darkness.
std::string darkOnes(const BuildReport& report, bool haveSeeds);
} // namespace galaxy

#endif
