# What the plugin adds to ParaView's window: sets window_interfaces, window_sources and
# window_resources for paraview_add_plugin.
paraview_plugin_add_action_group(
  CLASS_NAME pqGalaxyMenu
  GROUP_NAME "MenuBar/Galaxy"
  INTERFACES menu_interface
  SOURCES menu_sources)
paraview_plugin_add_toolbar(
  CLASS_NAME pqGalaxyToolBar
  INTERFACES toolbar_interface
  SOURCES toolbar_sources)
paraview_plugin_add_auto_start(
  CLASS_NAME pqGalaxyOpening
  INTERFACES opening_interface
  SOURCES opening_sources)
paraview_plugin_add_auto_start(
  CLASS_NAME pqGalaxyAbort
  INTERFACES abort_interface
  SOURCES abort_sources)
paraview_plugin_add_auto_start(
  CLASS_NAME pqSplatsPanel
  INTERFACES panel_interface
  SOURCES panel_sources)
paraview_plugin_add_property_widget(
  KIND GROUP_WIDGET
  TYPE "GalaxyComponents"
  CLASS_NAME pqComponentTableWidget
  INTERFACES table_interface
  SOURCES table_sources)
paraview_plugin_add_property_widget(
  KIND WIDGET
  TYPE "GalaxyText"
  CLASS_NAME pqInformationText
  INTERFACES text_interface
  SOURCES text_sources)
paraview_plugin_add_property_widget(
  KIND WIDGET_DECORATOR
  TYPE "GalaxyUnit"
  CLASS_NAME pqUnitDecorator
  INTERFACES unit_interface
  SOURCES unit_sources)

set(window_interfaces
  ${menu_interface} ${toolbar_interface} ${opening_interface} ${abort_interface}
  ${panel_interface} ${table_interface} ${text_interface} ${unit_interface})
set(window_sources
  ${menu_sources} ${toolbar_sources} ${opening_sources} ${abort_sources} ${panel_sources}
  ${table_sources} ${text_sources} ${unit_sources}
  Window/ActiveGalaxy.cxx
  Window/ComponentFactors.cxx
  Window/ComponentRow.cxx
  Window/ComponentRow.h
  Window/CopyEvent.h
  Window/GalaxyActions.cxx
  Window/GalaxyExamples.cxx
  Window/PluginProxies.cxx
  Window/pqComponentTableWidget.cxx
  Window/pqComponentTableWidget.h
  Window/WaitingInput.cxx
  Window/WaitingInput.h
  Window/pqGalaxyAbort.cxx
  Window/pqGalaxyAbort.h
  Window/pqGalaxyCameraReaction.cxx
  Window/pqGalaxyCameraReaction.h
  Window/pqGalaxyImageMenu.cxx
  Window/pqGalaxyImageMenu.h
  Window/pqGalaxyMenu.cxx
  Window/pqGalaxyMenu.h
  Window/pqGalaxyOpening.cxx
  Window/pqGalaxyOpening.h
  Window/pqGalaxyToolBar.cxx
  Window/pqGalaxyToolBar.h
  Window/pqInformationText.cxx
  Window/pqInformationText.h
  Window/pqSplatsPanel.cxx
  Window/pqSplatsPanel.h
  Window/pqUnitDecorator.cxx
  Window/pqUnitDecorator.h)
set(window_resources Icons/GalaxyIcons.qrc)
