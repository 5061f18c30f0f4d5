# Whether what ParaView makes help pages with is there: Qt's help generator and xmlpatterns. Sets
# galaxy_help_tools to ON or OFF. /usr/bin may hold links to tools that are not installed, so that
# each is tried.
find_package(Qt${GALAXY_QT_VERSION} QUIET COMPONENTS Help)
find_program(qt_xmlpatterns_executable # the name that ParaView looks for it under
  NAMES xmlpatterns-qt5 xmlpatterns
  HINTS "${Qt${GALAXY_QT_VERSION}_DIR}/../../../qt5/bin" "${Qt${GALAXY_QT_VERSION}_DIR}/../../../bin"
  DOC "Path to xmlpatterns")
mark_as_advanced(qt_xmlpatterns_executable)

set(galaxy_help_tools OFF)
if (TARGET Qt${GALAXY_QT_VERSION}::qhelpgenerator AND qt_xmlpatterns_executable)
  get_target_property(generator Qt${GALAXY_QT_VERSION}::qhelpgenerator IMPORTED_LOCATION)
  execute_process(COMMAND "${generator}" -v
    RESULT_VARIABLE no_generator OUTPUT_QUIET ERROR_QUIET)
  execute_process(COMMAND "${qt_xmlpatterns_executable}" -version
    RESULT_VARIABLE no_patterns OUTPUT_QUIET ERROR_QUIET)
  if (NOT no_generator AND NOT no_patterns)
    set(galaxy_help_tools ON)
  endif ()
endif ()
if (NOT galaxy_help_tools)
  message(STATUS "No help pages: qttools5-dev, qttools5-dev-tools or qtxmlpatterns5-dev-tools is missing")
endif ()
