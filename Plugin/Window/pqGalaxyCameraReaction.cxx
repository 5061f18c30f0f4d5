#include "pqGalaxyCameraReaction.h"

#include "ActiveGalaxy.h"
#include "Filters/Model/Viewpoints.h"

#include "pqActiveObjects.h"
#include "pqRenderView.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMTrace.h"

#include <QWidget>

#include <cmath>

namespace
{
/// An interaction as the mouse's is, after which the view's own undo takes the camera back.
class ScopedInteraction
{
public:
  explicit ScopedInteraction(vtkSMRenderViewProxy* view)
    : Interactor(view->GetInteractor())
  {
    this->Interactor->InvokeEvent(vtkCommand::StartInteractionEvent);
  }
  ~ScopedInteraction() { this->Interactor->InvokeEvent(vtkCommand::EndInteractionEvent); }
  ScopedInteraction(const ScopedInteraction&) = delete;
  ScopedInteraction& operator=(const ScopedInteraction&) = delete;

private:
  vtkRenderWindowInteractor* Interactor;
};

/// Position, focal point, view up and view angle, as ViewpointData documents them.
void setCamera(vtkSMProxy* view, const double* c, double aspect)
{
  const double angle = galaxy::fittedAngle(c[9], aspect);
  const double distance = std::hypot(std::hypot(c[0] - c[3], c[1] - c[4]), c[2] - c[5]);
  const double halfAngle = 0.5 * angle * std::acos(-1.0) / 180;
  vtkSMPropertyHelper(view, "CameraPosition").Set(c, 3);
  vtkSMPropertyHelper(view, "CameraFocalPoint").Set(c + 3, 3);
  vtkSMPropertyHelper(view, "CameraViewUp").Set(c + 6, 3);
  vtkSMPropertyHelper(view, "CameraViewAngle").Set(angle);
  vtkSMPropertyHelper(view, "CameraParallelProjection").Set(0);
  vtkSMPropertyHelper(view, "CameraParallelScale").Set(distance * std::tan(halfAngle));
  vtkSMPropertyHelper(view, "CenterOfRotation").Set(c + 3, 3);
  view->UpdateVTKObjects();
}
}

pqGalaxyCameraReaction::pqGalaxyCameraReaction(QAction* parent, const QString& camera)
  : Superclass(parent)
  , Camera(camera)
{
  galaxy::followActive(this, [this] { this->updateEnableState(); });
  this->updateEnableState();
}

void pqGalaxyCameraReaction::updateEnableState()
{
  auto* view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  this->parentAction()->setEnabled(view && galaxy::portWithField(view, this->Camera));
}

void pqGalaxyCameraReaction::onTriggered()
{
  if (auto* view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView()))
  {
    look(view, galaxy::portWithField(view, this->Camera), this->Camera);
  }
}

void pqGalaxyCameraReaction::look(pqRenderView* view, pqOutputPort* port, const QString& camera)
{
  const std::vector<double> numbers =
    port ? galaxy::fieldNumbers(port, camera) : std::vector<double>();
  if (numbers.size() != 10)
  {
    return;
  }
  vtkSMRenderViewProxy* proxy = view->getRenderViewProxy();
  const QSize size = view->widget()->size();
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    ScopedInteraction interaction(proxy);
    setCamera(proxy, numbers.data(), double(size.width()) / std::max(1, size.height()));
  }
  view->render();
}
