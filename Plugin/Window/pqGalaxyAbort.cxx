#include "pqGalaxyAbort.h"

#include "PluginProxies.h"
#include "WaitingInput.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPipelineSource.h"
#include "pqProgressManager.h"
#include "pqProgressWidget.h"
#include "pqRenderView.h"
#include "pqRepresentation.h"
#include "pqServerManagerModel.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkCompositeRepresentation.h"
#include "vtkPVDataRepresentation.h"
#include "vtkRenderWindow.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"

#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <memory>

namespace
{
/// Between two looks at the button.
constexpr qint64 shortestMilliseconds = 100;

pqProgressManager* progressManager()
{
  return pqApplicationCore::instance()->getProgressManager();
}

bool isOfPlugin(pqPipelineSource* source)
{
  const QString name = source->getProxy()->GetXMLName();
  return galaxy::pluginProxies("sources").contains(name) ||
    galaxy::pluginProxies("filters").contains(name);
}
}

pqGalaxyAbort::pqGalaxyAbort(QObject* parent)
  : Superclass(parent)
  , Input(new WaitingInput(this))
{
}

void pqGalaxyAbort::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::sourceAdded, this, &pqGalaxyAbort::onSourceAdded);
  QObject::connect(model, &pqServerManagerModel::viewAdded, this, &pqGalaxyAbort::onViewAdded);
  const QList<pqView*> views = model->findItems<pqView*>();
  for (pqView* view : views)
  {
    this->onViewAdded(view);
  }
  QObject::connect(progressManager(), &pqProgressManager::abort, this, &pqGalaxyAbort::onAbort);
  QObject::connect(
    progressManager(), &pqProgressManager::progressEndEvent, this, &pqGalaxyAbort::onEnd);
}

void pqGalaxyAbort::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
  QObject::disconnect(progressManager(), nullptr, this, nullptr);
  for (const Watch& watch : this->Watched)
  {
    if (watch.object)
    {
      watch.object->RemoveObserver(watch.tag);
    }
  }
  this->Watched.clear();
}

void pqGalaxyAbort::onSourceAdded(pqPipelineSource* source)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
  if (!algorithm || !isOfPlugin(source))
  {
    return;
  }
  this->watch(algorithm, vtkCommand::ProgressEvent, &pqGalaxyAbort::onProgress);
  auto waits = std::make_shared<bool>(false); // for Apply
  QObject::connect(
    progressManager(), &pqProgressManager::progressEndEvent, source, [source, algorithm, waits] {
      // Once whatever began the work is through, which may be Apply.
      QTimer::singleShot(0, source, [source, algorithm, waits] {
        if (algorithm->GetAbortExecute())
        {
          *waits = true;
          source->setModifiedState(pqProxy::UNINITIALIZED);
        }
      });
    });
  QObject::connect(source, &pqProxy::modifiedStateChanged, source, [source, algorithm, waits] {
    if (*waits && source->modifiedState() == pqProxy::UNMODIFIED)
    {
      *waits = false;
      algorithm->SetAbortExecute(0); // it runs again, where ParaView asks it to
      source->getProxy()->MarkDirty(source->getProxy());
    }
  });
}

void pqGalaxyAbort::onViewAdded(pqView* view)
{
  auto* renderView = qobject_cast<pqRenderView*>(view);
  if (!renderView)
  {
    return;
  }
  QObject::connect(view, &pqView::beginRender, this, [this, view] { this->watchPictures(view); });
  this->watch(renderView->getRenderViewProxy()->GetRenderWindow(), vtkCommand::AbortCheckEvent,
    &pqGalaxyAbort::onAbortCheck);
}

void pqGalaxyAbort::watchPictures(pqView* view)
{
  const QList<pqRepresentation*> all = view->getRepresentations();
  for (pqRepresentation* representation : all)
  {
    auto* kinds =
      vtkCompositeRepresentation::SafeDownCast(representation->getProxy()->GetClientSideObject());
    vtkAlgorithm* shown = kinds ? kinds->GetActiveRepresentation() : nullptr;
    if (shown && shown->IsA("vtkSplatRepresentation"))
    {
      this->watch(shown, vtkCommand::ProgressEvent, &pqGalaxyAbort::onProgress);
    }
  }
}

void pqGalaxyAbort::watch(vtkObject* object, unsigned long event,
  void (pqGalaxyAbort::*answer)(vtkObject*, unsigned long, void*))
{
  const bool isWatched = std::any_of(this->Watched.begin(), this->Watched.end(),
    [object](const Watch& watch) { return watch.object == object; });
  if (!isWatched)
  {
    this->Watched.push_back({ object, object->AddObserver(event, this, answer) });
  }
}

void pqGalaxyAbort::onProgress(vtkObject* algorithm, unsigned long, void*)
{
  if (this->Answering ||
    (this->SinceAnswer.isValid() && !this->SinceAnswer.hasExpired(shortestMilliseconds)))
  {
    return;
  }
  if (!this->Bar)
  {
    this->Bar = pqCoreUtilities::mainWidget()->findChild<pqProgressWidget*>();
  }
  if (!this->Bar)
  {
    return;
  }
  this->Answering = true;
  progressManager()->setEnableAbort(true);
  const bool blocked = progressManager()->unblockEvents(true);
  this->Input->answer(this->Bar->abortButton());
  progressManager()->unblockEvents(blocked);
  this->Answering = false;
  this->SinceAnswer.start();
  if (this->Wanted)
  {
    this->Wanted = false;
    vtkAlgorithm::SafeDownCast(algorithm)->SetAbortExecute(1);
  }
}

void pqGalaxyAbort::onAbortCheck(vtkObject* window, unsigned long, void*)
{
  if (this->Input->isWanted())
  {
    vtkRenderWindow::SafeDownCast(window)->SetAbortRender(1);
  }
}

void pqGalaxyAbort::onEnd()
{
  progressManager()->setEnableAbort(false);
  this->SinceAnswer.invalidate();
  this->Wanted = false;
  this->Input->deliver();
}
