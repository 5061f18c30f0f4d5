/**
 * @class   pqGalaxyCameraReaction
 * @brief   moves the active view's camera to where a galaxy is looked at from
 *
 * The camera is a field array of the active galaxy (Filters/ViewpointData.h). The move is in the
 * Python trace and can be undone as any move of the camera.
 */
#ifndef pqGalaxyCameraReaction_h
#define pqGalaxyCameraReaction_h

#include "pqReaction.h"

#include <QString>

class pqOutputPort;
class pqRenderView;

class pqGalaxyCameraReaction : public pqReaction
{
  Q_OBJECT
  typedef pqReaction Superclass;

public:
  /// `camera` is the name of the field array.
  pqGalaxyCameraReaction(QAction* parent, const QString& camera);

  /// Looks at what `port` holds from its camera of that name; does nothing where it has none.
  static void look(pqRenderView* view, pqOutputPort* port, const QString& camera);

protected Q_SLOTS:
  void onTriggered() override;
  void updateEnableState() override;

private:
  Q_DISABLE_COPY(pqGalaxyCameraReaction)

  QString Camera;
};

#endif
