#ifndef galaxy_Instruction_h
#define galaxy_Instruction_h

#include "Readers/Formats/Error.h"

#include <cstdio>
#include <string>

namespace galaxy
{
/// Whether an Error tells the user what to do: what something must be or, behind a semicolon, what
/// else to try. One that does not is printed.
inline bool saysWhatToDo(const Error& error)
{
  const std::string message = error.what();
  for (const char* instruction : { "must ", "; add ", "; check ", "; choose ", "; connect ",
         "; correct ", "; cut ", "; did you mean ", "; give ", "; hide ", "; leave ", "; move ",
         "; name ", "; put ", "; raise ", "; repair ", "; save ", "; set ", "; unpack ", "; use " })
  {
    if (message.find(instruction) != std::string::npos)
    {
      return true;
    }
  }
  std::fprintf(stderr, "does not say what to do: %s\n", error.what());
  return false;
}
} // namespace galaxy

#endif
