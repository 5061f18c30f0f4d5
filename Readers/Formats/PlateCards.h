#ifndef galaxy_PlateCards_h
#define galaxy_PlateCards_h

#include "Readers/Formats/FitsHeader.h"

#include <string>

namespace galaxy
{
/// The plate solution of the Digitized Sky Survey, looked up in a header and written anew; empty
/// where the header has none, or not the whole of it.
std::string plateCards(const FitsHeader& header);
} // namespace galaxy

#endif
