#include "PluginProxies.h"

#include "pqActiveObjects.h"

#include "vtkPVPlugin.h"
#include "vtkPVPluginTracker.h"
#include "vtkPVProxyDefinitionIterator.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProxyDefinitionManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"

#include <QFileInfo>

namespace galaxy
{
QStringList pluginProxies(const char* group)
{
  QStringList names;
  vtkSMSessionProxyManager* manager = pqActiveObjects::instance().proxyManager();
  if (!manager)
  {
    return names;
  }
  const auto each = vtkSmartPointer<vtkPVProxyDefinitionIterator>::Take(
    manager->GetProxyDefinitionManager()->NewSingleGroupIterator(group));
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    vtkPVXMLElement* hints = each->GetProxyHints();
    vtkPVXMLElement* place = hints ? hints->FindNestedElementByName("ShowInMenu") : nullptr;
    if (place && QString(place->GetAttribute("category")) == "Galaxy Reconstruction")
    {
      names.append(each->GetProxyName());
    }
  }
  return names;
}

QString pluginFolder()
{
  vtkPVPluginTracker* tracker = vtkPVPluginTracker::GetInstance();
  for (unsigned int k = 0; k < tracker->GetNumberOfPlugins(); ++k)
  {
    if (QString(tracker->GetPluginName(k)) == "GalaxyReconstruction" &&
      tracker->GetPluginFileName(k))
    {
      return QFileInfo(tracker->GetPluginFileName(k)).absolutePath();
    }
  }
  return QString();
}
}
