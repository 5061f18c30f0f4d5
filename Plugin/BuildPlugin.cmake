# Finds ParaView, builds the plugin beside it and installs it where that ParaView looks.
set(BUILD_SHARED_LIBS ON) # or ParaView makes the plugin a static library
find_package(Python3 QUIET COMPONENTS Interpreter Development.Module)
set(components RemotingViews WrapClientServer)
set(galaxy_has_window OFF)
if (GALAXY_BUILD_WINDOW)
  find_package(Qt${GALAXY_QT_VERSION} QUIET COMPONENTS Widgets Network OpenGL Svg Help)
  if (Qt${GALAXY_QT_VERSION}_FOUND)
    list(APPEND components pqApplicationComponents)
    set(galaxy_has_window ON)
  else ()
    message(STATUS "No development files of Qt ${GALAXY_QT_VERSION} (Widgets, Network, OpenGL, Svg, Help): the plugin is "
      "built without its menu, toolbar and table of components. On Debian they are in qtbase5-dev, "
      "libqt5opengl5-dev, libqt5svg5-dev and qttools5-dev; GALAXY_BUILD_WINDOW=OFF leaves the window's "
      "part out unasked.")
  endif ()
endif ()
find_package(ParaView 5.11 REQUIRED COMPONENTS ${components})
# What ParaView's own libraries are linked to and the plugin has no use for: no need to look for it.
foreach (unused IN ITEMS LibXml2::LibXml2 hdf5::hdf5 hdf5::hdf5_hl NetCDF::NetCDF)
  if (NOT TARGET "${unused}")
    add_library("${unused}" INTERFACE IMPORTED)
  endif ()
endforeach ()
message(STATUS "ParaView ${ParaView_VERSION} in ${ParaView_PREFIX_PATH}")

if (CMAKE_INSTALL_PREFIX_INITIALIZED_TO_DEFAULT)
  set(CMAKE_INSTALL_PREFIX "${ParaView_PREFIX_PATH}" CACHE PATH "Where ParaView is installed" FORCE)
endif ()
include(GNUInstallDirs)

set(plugins_subdirectory "paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")
set(plugins_file "galaxyreconstruction.plugins.xml")

paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  LIBRARY_SUBDIRECTORY "${plugins_subdirectory}"
  PLUGINS ${plugins}
  PLUGINS_FILE_NAME "${plugins_file}"
  PLUGINS_COMPONENT paraview_plugins
  INSTALL_HEADERS OFF)

# ParaView lists the plugins of the files named in paraview.conf beside its executable.
file(RELATIVE_PATH plugins_from_bin "/prefix/${CMAKE_INSTALL_BINDIR}"
  "/prefix/${CMAKE_INSTALL_LIBDIR}/${plugins_subdirectory}")
configure_file(Plugin/RegisterPlugin.cmake.in "${CMAKE_BINARY_DIR}/RegisterPlugin.cmake" @ONLY)
install(SCRIPT "${CMAKE_BINARY_DIR}/RegisterPlugin.cmake") # of no component: not in a package
configure_file(Plugin/RemoveArchives.cmake.in "${CMAKE_BINARY_DIR}/RemoveArchives.cmake" @ONLY)
install(SCRIPT "${CMAKE_BINARY_DIR}/RemoveArchives.cmake" COMPONENT paraview_plugins)

include(Plugin/Package/Package.cmake)
