#ifndef galaxy_ActiveGalaxy_h
#define galaxy_ActiveGalaxy_h

#include <QStringList>

#include <functional>
#include <vector>

class QObject;
class pqOutputPort;
class pqView;

/// Which galaxy the window's actions are about, and what the client knows of it.
namespace galaxy
{
/// The numbers of a field array of one tuple, from the data information; empty where there is none.
std::vector<double> fieldNumbers(pqOutputPort* port, const QString& name);

/// The names of the images whose field the output has a camera for.
QStringList imagesWithCamera(pqOutputPort* port);
/// The name of that camera.
QString imageCamera(const QString& image);

/// Of the active source, of what it feeds, or of what is visible in the view, the first whose
/// output has this field array; null where there is none.
pqOutputPort* portWithField(pqView* view, const QString& name);

/// Calls `update` when what portWithField answers may have changed, as long as `receiver` lives.
void followActive(QObject* receiver, const std::function<void()>& update);

/// Whether anything but this output is visible in the view.
bool showsOthers(pqView* view, const pqOutputPort* port);
}

#endif
