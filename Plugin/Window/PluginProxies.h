#ifndef galaxy_PluginProxies_h
#define galaxy_PluginProxies_h

#include <QStringList>

namespace galaxy
{
/// The proxies of a group ("sources" or "filters") that ask for a place in ParaView's menu among
/// those of this plugin, by name.
QStringList pluginProxies(const char* group);

/// The folder that holds the plugin's library; empty where it is not a file.
QString pluginFolder();
}

#endif
