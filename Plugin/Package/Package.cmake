# cpack -G DEB makes a Debian package of the plugin, its help and the examples. ParaView itself, and
# what stays in the build folder, is not in it.
set(package "paraview-galaxyreconstruction")
set(examples "${CMAKE_INSTALL_DATADIR}/galaxyreconstruction")
set(documents "${CMAKE_INSTALL_DATAROOTDIR}/doc/${package}")

install(DIRECTORY Examples DESTINATION "${examples}" COMPONENT examples USE_SOURCE_PERMISSIONS
  PATTERN "images" EXCLUDE PATTERN "output" EXCLUDE PATTERN "__pycache__" EXCLUDE
  PATTERN "demo.sh" EXCLUDE) # which builds the plugin
install(FILES README.md DESTINATION "${documents}" COMPONENT examples)
install(FILES LICENSE DESTINATION "${documents}" RENAME copyright COMPONENT examples)
set(plugins_folder "${CMAKE_INSTALL_LIBDIR}/${plugins_subdirectory}")
install(FILES "${CMAKE_BINARY_DIR}/${plugins_folder}/${plugins_file}"
  DESTINATION "${plugins_folder}" COMPONENT paraview_plugins) # which ParaView installs with no component

foreach (script IN ITEMS postinst postrm)
  configure_file("Plugin/Package/${script}.in" "${CMAKE_BINARY_DIR}/package/${script}" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
      WORLD_EXECUTE)
  list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_BINARY_DIR}/package/${script}")
endforeach ()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME "${package}")
set(CPACK_PACKAGE_VENDOR "Galaxy Reconstruction")
set(CPACK_PACKAGE_CONTACT "Galaxy Reconstruction")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "observed galaxies in three dimensions, a ParaView plugin")
set(CPACK_PACKAGE_DESCRIPTION "From FITS images and a tilted-ring model the plugin builds a galaxy of
millions of particles (stars, gas, dust, bulge) and draws it from any side, light and dust in true
depth order, in ParaView's window, from pvpython scripts and without a display. License: BSD-3-Clause.")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL paraview_plugins examples)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "paraview (>= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR})")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "python3-paraview, python3-numpy, python3-astropy, python3-pil, fonts-dejavu-core, libqt5svg5")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "xvfb, xauth, python3-matplotlib, python3-yt, splash")
include(CPack)
