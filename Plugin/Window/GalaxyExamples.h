#ifndef galaxy_GalaxyExamples_h
#define galaxy_GalaxyExamples_h

#include <QList>
#include <QString>

namespace galaxy
{
struct Example
{
  QString name;
  QString file;
};

/// The examples that are there with their images: in a folder Examples beside the plugin or above
/// it (in the source tree, whose build folder holds the plugin), or where the package puts them.
QList<Example> findExamples();
}

#endif
