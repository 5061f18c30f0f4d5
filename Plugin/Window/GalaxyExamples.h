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

/// The examples that are there, with their images: in a folder Examples beside the plugin, or above
/// it, where it lies in its build folder in the source tree.
QList<Example> findExamples();
}

#endif
