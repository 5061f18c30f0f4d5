#include "GalaxyExamples.h"

#include "PluginProxies.h"

#include <QDir>

namespace galaxy
{
namespace
{
const Example examples[] = {
  { "M83", "M83/m83.galaxy" },
  { "M83 Group", "M83Group/m83group.galaxygroup" },
};

/// What all examples need, made by M83/images.sh.
bool hasImages(const QDir& folder)
{
  return folder.exists("M83/m83.galaxy") && folder.exists("M83/images/m83_r.fits");
}

/// The examples' folder in `folder` or the nearest folder above it that has one; null if none has.
QDir examplesAbove(QDir folder)
{
  do
  {
    for (const char* name : { "Examples", "share/galaxyreconstruction/Examples" })
    {
      const QDir inside(folder.filePath(name));
      if (hasImages(inside))
      {
        return inside;
      }
    }
  } while (folder.cdUp());
  return QDir(QString());
}
}

QList<Example> findExamples()
{
  QList<Example> found;
  const QString plugin = pluginFolder();
  const QDir folder = plugin.isEmpty() ? QDir(QString()) : examplesAbove(QDir(plugin));
  for (const Example& example : examples)
  {
    if (hasImages(folder) && folder.exists(example.file))
    {
      found.append({ example.name, folder.absoluteFilePath(example.file) });
    }
  }
  return found;
}
}
