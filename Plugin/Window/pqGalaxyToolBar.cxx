#include "pqGalaxyToolBar.h"

#include "GalaxyActions.h"

pqGalaxyToolBar::pqGalaxyToolBar(QWidget* parent)
  : Superclass("Galaxy", parent)
{
  this->setObjectName("GalaxyToolBar");
  this->addAction(galaxy::openAction(this));
  this->addSeparator();
  this->addActions(galaxy::cameraActions(this));
}
