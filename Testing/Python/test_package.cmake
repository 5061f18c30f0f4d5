# The Debian package: what it holds, what its control file says, and that its scripts add to and take
# from paraview.conf what is theirs alone.
cmake_policy(VERSION 3.18)
find_program(DPKG_DEB dpkg-deb)
if (NOT DPKG_DEB)
  message("SKIPPED: dpkg-deb is not installed")
  return()
endif ()

function (run output)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "${ARGN} failed:\n${text}")
  endif ()
  set(${output} "${text}" PARENT_SCOPE)
endfunction ()

function (must_match text)
  foreach (expression IN LISTS ARGN)
    if (NOT text MATCHES "${expression}")
      message(FATAL_ERROR "nothing is like '${expression}' in\n${text}")
    endif ()
  endforeach ()
endfunction ()

file(REMOVE_RECURSE "${FOLDER}")
run(ignored ${CPACK} --config "${BUILD}/CPackConfig.cmake" -G DEB -B "${FOLDER}")
file(GLOB package "${FOLDER}/paraview-galaxyreconstruction_*.deb")

run(control ${DPKG_DEB} --field "${package}")
must_match("${control}" "Package: paraview-galaxyreconstruction\n" "Section: science\n"
  "Maintainer: Galaxy Reconstruction\n" "Depends: [^\n]*paraview \\(>= 5\\.[0-9]+\\)"
  "Depends: [^\n]*libcfitsio" "Depends: [^\n]*libwcs" "Recommends: [^\n]*python3-paraview"
  "BSD-3-Clause")

run(contents ${DPKG_DEB} --contents "${package}")
must_match("${contents}" "plugins/GalaxyReconstruction/GalaxyReconstruction\\.so\n"
  "plugins/galaxyreconstruction\\.plugins\\.xml\n" "doc/paraview-galaxyreconstruction/copyright\n"
  "rwxr-xr-x[^\n]*galaxyreconstruction/Examples/M83/images\\.sh\n"
  "galaxyreconstruction/Examples/Cookbook/01_one_image\\.py\n")
foreach (stranger IN ITEMS "\\.a\n" "\\.h\n" "\\.cmake\n" "paraview\\.conf" "\\.fits\n" "__pycache__")
  if (contents MATCHES "[^\n]*${stranger}")
    message(FATAL_ERROR "in the package: ${CMAKE_MATCH_0}")
  endif ()
endforeach ()

# The scripts, with the file that they edit in the test's own folder.
run(ignored ${DPKG_DEB} --control "${package}" "${FOLDER}/control")
set(conf "${FOLDER}/paraview.conf")
foreach (script IN ITEMS postinst postrm)
  file(READ "${FOLDER}/control/${script}" text)
  string(REGEX REPLACE "conf=\"[^\"]*\"" "conf=\"${conf}\"" text "${text}")
  file(WRITE "${FOLDER}/${script}" "${text}")
endforeach ()
run(ignored sh "${FOLDER}/postinst" configure)
run(ignored sh "${FOLDER}/postinst" configure 0.1)
file(STRINGS "${conf}" lines)
list(LENGTH lines count)
if (NOT count EQUAL 2)
  message(FATAL_ERROR "paraview.conf must name ParaView's list and this plugin's: ${lines}")
endif ()
file(APPEND "${conf}" "another.plugins.xml\n")
run(ignored sh "${FOLDER}/postrm" remove)
file(STRINGS "${conf}" lines)
if (NOT lines MATCHES "another" OR lines MATCHES "galaxy")
  message(FATAL_ERROR "after removal paraview.conf has: ${lines}")
endif ()
file(REMOVE "${conf}")
run(ignored sh "${FOLDER}/postinst" configure)
run(ignored sh "${FOLDER}/postrm" remove)
if (EXISTS "${conf}")
  message(FATAL_ERROR "removal leaves ${conf}")
endif ()
