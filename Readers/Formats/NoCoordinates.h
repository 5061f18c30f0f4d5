#ifndef galaxy_NoCoordinates_h
#define galaxy_NoCoordinates_h

#include "Readers/Formats/Error.h"

namespace galaxy
{
/// A header whose coordinates cannot be used; those that the user gives can.
class NoCoordinates : public Error
{
public:
  NoCoordinates(const std::string& file, const std::string& where, const std::string& what)
    : Error(file, where,
        what + "; give `ra`, `dec` and `pixel_scale` for this image in the .galaxy file")
  {
  }
};
} // namespace galaxy

#endif
