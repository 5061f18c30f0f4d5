#include "pqGalaxyToolBar.h"

#include "GalaxyActions.h"
#include "pqGalaxyImageMenu.h"

pqGalaxyToolBar::pqGalaxyToolBar(QWidget* parent)
  : Superclass("Galaxy", parent)
{
  this->setObjectName("GalaxyToolBar");
  this->addAction(galaxy::openAction(this));
  this->addSeparator();
  const QList<QAction*> cameras = galaxy::cameraActions(this);
  cameras.first()->setMenu(new pqGalaxyImageMenu(this));
  this->addActions(cameras);
}
