#include "pqGalaxyImageMenu.h"

#include "ActiveGalaxy.h"
#include "pqGalaxyCameraReaction.h"

#include "pqActiveObjects.h"

pqGalaxyImageMenu::pqGalaxyImageMenu(QWidget* parent)
  : Superclass("View from Earth as", parent)
{
  this->setObjectName("galaxy-earth-as"); // as tests address it
  galaxy::followActive(this, [this] { this->follow(); });
  this->fill();
}

void pqGalaxyImageMenu::follow()
{
  pqOutputPort* port =
    galaxy::portWithField(pqActiveObjects::instance().activeView(), "CameraEarth");
  const QStringList images = port ? galaxy::imagesWithCamera(port) : QStringList();
  if (images != this->Images)
  {
    this->Images = images;
    this->fill();
  }
}

void pqGalaxyImageMenu::fill()
{
  this->clear();
  for (const QString& image : qAsConst(this->Images))
  {
    // Else the menu takes an ampersand for the mark of a key.
    QAction* action = this->addAction(QString(image).replace("&", "&&"));
    action->setObjectName("galaxy-earth-as-" + image);
    action->setStatusTip("From the observer's place: the field of this image, its +y up");
    new pqGalaxyCameraReaction(action, galaxy::imageCamera(image));
  }
  this->menuAction()->setEnabled(!this->Images.isEmpty());
}
