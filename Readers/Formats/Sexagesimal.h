#ifndef galaxy_Sexagesimal_h
#define galaxy_Sexagesimal_h

#include <optional>
#include <string>

namespace galaxy
{
/// An angle in degrees from 13:29:52.7, 13h29m52.7s, +47d11m43s, 47d11'43" or CASA's 47.11.43.0:
/// hours where it says h, and with colons where `colonsAreHours`. Nothing where the text is none of
/// these, or has minutes or seconds of 60 and more.
std::optional<double> sexagesimalAngle(const std::string& text, bool colonsAreHours);

/// The same, or a decimal number of degrees.
std::optional<double> angleOf(const std::string& text, bool colonsAreHours);
} // namespace galaxy

#endif
