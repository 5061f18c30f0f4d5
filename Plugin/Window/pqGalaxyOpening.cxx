#include "pqGalaxyOpening.h"

#include "ActiveGalaxy.h"
#include "pqGalaxyCameraReaction.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqFiltersMenuReaction.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPVApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"

#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMTrace.h"
#include "vtkSmartPointer.h"

#include <QTimer>

namespace
{
bool isA(pqPipelineSource* source, const char* name)
{
  return source && source->getProxy()->GetXMLName() == QString(name);
}

/// Whether the reader found a galaxy; one that did not has said so.
bool hasGalaxy(pqPipelineSource* reader)
{
  vtkPVDataInformation* data = reader->getOutputPort(0)->getDataInformation();
  return data->GetNumberOfDataSets() > 0;
}

/// While it lives, Apply does not show what a reader reads: rings and images would be drawn only to
/// be hidden behind the model, and lend it their colours. ParaView takes the wish from the proxy's
/// hints, which all readers of the kind share.
class NotShown : public QObject
{
public:
  explicit NotShown(pqPipelineSource* reader)
    : QObject(reader)
    , Hints(reader->getProxy()->GetHints())
    , View(vtkSmartPointer<vtkPVXMLElement>::New())
  {
    this->View->SetName("View");
    this->View->AddAttribute("type", "None");
    this->Hints->AddNestedElement(this->View);
  }
  ~NotShown() override { this->Hints->RemoveNestedElement(this->View); }

private:
  vtkSmartPointer<vtkPVXMLElement> Hints;
  vtkSmartPointer<vtkPVXMLElement> View;
};

void darken(pqRenderView* view)
{
  vtkSMProxy* proxy = view->getProxy();
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
  const double black[3] = { 0, 0, 0 };
  vtkSMPropertyHelper(proxy, "UseColorPaletteForBackground").Set(0);
  vtkSMPropertyHelper(proxy, "BackgroundColorMode").Set("Single Color");
  vtkSMPropertyHelper(proxy, "Background").Set(black, 3);
  proxy->UpdateVTKObjects();
}

/// Builds the model behind the reader, as a person does with the menu and Apply.
pqPipelineSource* buildModel(pqPipelineSource* reader)
{
  pqActiveObjects::instance().setActiveSource(reader);
  pqPipelineSource* model = pqFiltersMenuReaction::createFilter("filters", "GalaxyModel");
  pqPVApplicationCore::instance()->applyPipeline();
  return model;
}
}

pqGalaxyOpening::pqGalaxyOpening(QObject* parent)
  : Superclass(parent)
{
}

void pqGalaxyOpening::startup()
{
  QObject::connect(pqApplicationCore::instance()->getObjectBuilder(),
    SIGNAL(readerCreated(pqPipelineSource*, const QStringList&)), this,
    SLOT(onReaderCreated(pqPipelineSource*)));
}

void pqGalaxyOpening::shutdown()
{
  QObject::disconnect(pqApplicationCore::instance()->getObjectBuilder(), nullptr, this, nullptr);
}

void pqGalaxyOpening::onReaderCreated(pqPipelineSource* reader)
{
  if (isA(reader, "GalaxyReader") || isA(reader, "GalaxyGroup"))
  {
    this->watch(reader);
  }
}

void pqGalaxyOpening::watch(pqPipelineSource* reader)
{
  auto* waiting = isA(reader, "GalaxyReader") ? new NotShown(reader) : new QObject(reader);
  QObject::connect(reader, &pqProxy::modifiedStateChanged, waiting, [=] {
    if (reader->modifiedState() == pqProxy::UNMODIFIED)
    {
      // Once ParaView is through with Apply.
      QTimer::singleShot(0, waiting, [=] {
        waiting->deleteLater();
        this->show(reader);
      });
    }
  });
}

void pqGalaxyOpening::show(pqPipelineSource* reader)
{
  auto* view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  const bool isFirst = view && !galaxy::showsOthers(view, reader->getOutputPort(0));
  pqPipelineSource* shown = reader;
  BEGIN_UNDO_SET("Show Galaxy");
  if (isA(reader, "GalaxyReader"))
  {
    shown = hasGalaxy(reader) ? buildModel(reader) : nullptr;
  }
  if (isFirst && shown)
  {
    darken(view);
    pqGalaxyCameraReaction::look(view, shown->getOutputPort(0), "CameraEarth");
  }
  END_UNDO_SET();
}
