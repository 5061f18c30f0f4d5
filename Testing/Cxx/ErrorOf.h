#ifndef galaxy_ErrorOf_h
#define galaxy_ErrorOf_h

#include "Readers/Formats/Error.h"
#include "Testing/Instruction.h"

#include <gtest/gtest.h>

#include <string>

namespace galaxy
{
/// The message of the Error that the work ends with, which must say what to do; empty where it ends
/// well.
template <typename Work>
std::string errorOf(const Work& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    EXPECT_TRUE(saysWhatToDo(error));
    return error.what();
  }
  return "";
}
} // namespace galaxy

#endif
