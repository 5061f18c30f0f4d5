# Fails where clang-format would change a source file.
execute_process(COMMAND git -C "${SOURCE}" ls-files *.h *.cxx
  OUTPUT_VARIABLE files RESULT_VARIABLE result OUTPUT_STRIP_TRAILING_WHITESPACE)
if (result OR NOT files)
  file(GLOB_RECURSE files RELATIVE "${SOURCE}" "${SOURCE}/Readers/*.h" "${SOURCE}/Readers/*.cxx"
    "${SOURCE}/Filters/*.h" "${SOURCE}/Filters/*.cxx" "${SOURCE}/Representations/*.h"
    "${SOURCE}/Representations/*.cxx" "${SOURCE}/Testing/*.h" "${SOURCE}/Testing/*.cxx")
else ()
  string(REPLACE "\n" ";" files "${files}")
endif ()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files}
  WORKING_DIRECTORY "${SOURCE}" RESULT_VARIABLE result)
if (result)
  message(FATAL_ERROR "clang-format would change these files")
endif ()
