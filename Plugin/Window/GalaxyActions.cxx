#include "GalaxyActions.h"

#include "pqGalaxyCameraReaction.h"

#include "pqLoadDataReaction.h"

#include <QAction>
#include <QIcon>
#include <QPair>
#include <QSet>

namespace galaxy
{
namespace
{
struct CameraAction
{
  const char* field;
  const char* icon;
  const char* text;
  const char* tip;
};
const CameraAction cameras[] = {
  { "CameraEarth", "earth", "View from Earth", "From the observer's place: North up, East left" },
  { "CameraFaceOn", "face-on", "Face-on", "The disc turned to the eye" },
  { "CameraEdgeOn", "edge-on", "Edge-on", "The disc from its side, the major axis level" },
  { "CameraMajorAxis", "major-axis", "Along the Major Axis", "From the receding end of the disc" },
};

QAction* makeAction(const char* icon, const char* text, const char* tip, QObject* parent)
{
  auto* action = new QAction(QIcon(QString(":/GalaxyIcons/%1.svg").arg(icon)), text, parent);
  action->setObjectName(QString("galaxy-") + icon); // as tests address it
  action->setToolTip(QString("%1: %2").arg(QString(text).remove("..."), tip));
  action->setStatusTip(tip);
  return action;
}
}

QAction* openAction(QObject* parent)
{
  QAction* action = makeAction("open", "Open Galaxy...", "A .galaxy or .galaxygroup file", parent);
  QObject::connect(action, &QAction::triggered, [] {
    const QString group = "sources";
    pqLoadDataReaction::loadData(pqLoadDataReaction::ReaderSet{
      qMakePair(group, QString("GalaxyReader")), qMakePair(group, QString("GalaxyGroup")) });
  });
  return action;
}

QList<QAction*> cameraActions(QObject* parent)
{
  QList<QAction*> actions;
  for (const CameraAction& camera : cameras)
  {
    QAction* action = makeAction(camera.icon, camera.text, camera.tip, parent);
    new pqGalaxyCameraReaction(action, camera.field);
    actions.append(action);
  }
  return actions;
}
}
