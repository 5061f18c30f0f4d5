#include "pqGalaxyMenu.h"

#include "GalaxyActions.h"
#include "GalaxyExamples.h"
#include "PluginProxies.h"
#include "pqGalaxyImageMenu.h"

#include "pqCoreUtilities.h"
#include "pqFiltersMenuReaction.h"
#include "pqLoadDataReaction.h"
#include "pqPVApplicationCore.h"
#include "pqProxyGroupMenuManager.h"
#include "pqSourcesMenuReaction.h"

#include <QMenu>

pqGalaxyMenu::pqGalaxyMenu(QObject* parent)
  : Superclass(parent)
{
  this->addAction(galaxy::openAction(this));
  this->addExamples();
  this->addSeparator();
  this->addProxies("Sources", "sources");
  this->addProxies("Filters", "filters");
  this->addSeparator();
  QWidget* window = pqCoreUtilities::mainWidget(); // the group would take its own children at once
  QList<QAction*> cameras = galaxy::cameraActions(window);
  cameras.insert(1, (new pqGalaxyImageMenu(window))->menuAction());
  for (QAction* camera : qAsConst(cameras))
  {
    this->addAction(camera);
  }
}

void pqGalaxyMenu::addExamples()
{
  const QList<galaxy::Example> examples = galaxy::findExamples();
  if (examples.isEmpty())
  {
    return;
  }
  auto* menu = new QMenu("Examples", pqCoreUtilities::mainWidget());
  menu->setObjectName("galaxy-examples"); // as tests address it
  for (const galaxy::Example& example : examples)
  {
    const QString file = example.file;
    QObject::connect(menu->addAction(example.name), &QAction::triggered, [file] {
      pqLoadDataReaction::loadData(QStringList(file));
      pqPVApplicationCore::instance()->applyPipeline();
    });
  }
  this->addAction(menu->menuAction());
}

void pqGalaxyMenu::addProxies(const char* title, const char* group)
{
  auto* menu = new QMenu(title, pqCoreUtilities::mainWidget());
  auto* manager = new pqProxyGroupMenuManager(menu, "GalaxyReconstruction", false);
  const bool isFilters = QString(group) == "filters";
  auto* filters = isFilters ? new pqFiltersMenuReaction(manager) : nullptr;
  auto* sources = isFilters ? nullptr : new pqSourcesMenuReaction(manager);
  // Not before: there may be no server yet that knows the proxies.
  QObject::connect(menu, &QMenu::aboutToShow, [=] {
    if (manager->actions().isEmpty())
    {
      for (const QString& name : galaxy::pluginProxies(group))
      {
        manager->addProxy(group, name);
      }
      manager->populateMenu();
    }
    isFilters ? filters->updateEnableState() : sources->updateEnableState();
  });
  this->addAction(menu->menuAction());
}

void pqGalaxyMenu::addSeparator()
{
  this->addAction(QString())->setSeparator(true);
}
