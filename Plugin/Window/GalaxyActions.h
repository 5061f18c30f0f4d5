#ifndef galaxy_GalaxyActions_h
#define galaxy_GalaxyActions_h

#include <QList>

class QAction;
class QObject;

/// What the menu and the toolbar have in common.
namespace galaxy
{
/// Opens a .galaxy or .galaxygroup file through ParaView's file dialog.
QAction* openAction(QObject* parent);
/// The four cameras, that from Earth first.
QList<QAction*> cameraActions(QObject* parent);
}

#endif
