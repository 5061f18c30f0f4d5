#include "ActiveGalaxy.h"

#include "pqActiveObjects.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqView.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"

#include <algorithm>

namespace galaxy
{
namespace
{
const char imagePrefix[] = "CameraEarth:";

/// What was never applied has no data, and must not be made to read any: null.
vtkPVDataSetAttributesInformation* fieldsOf(pqOutputPort* port)
{
  return port->getSource()->modifiedState() == pqProxy::UNINITIALIZED
    ? nullptr
    : port->getDataInformation()->GetFieldDataInformation();
}

bool hasField(pqOutputPort* port, const QString& name)
{
  return port && !fieldNumbers(port, name).empty();
}

QList<pqOutputPort*> visiblePorts(pqView* view)
{
  QList<pqOutputPort*> ports;
  const QList<pqRepresentation*> all =
    view ? view->getRepresentations() : QList<pqRepresentation*>();
  for (pqRepresentation* representation : all)
  {
    auto* data = qobject_cast<pqDataRepresentation*>(representation);
    if (data && data->isVisible() && data->getOutputPortFromInput())
    {
      ports.append(data->getOutputPortFromInput());
    }
  }
  return ports;
}
}

std::vector<double> fieldNumbers(pqOutputPort* port, const QString& name)
{
  vtkPVDataSetAttributesInformation* fields = fieldsOf(port);
  vtkPVArrayInformation* array =
    fields ? fields->GetArrayInformation(name.toUtf8().data()) : nullptr;
  std::vector<double> numbers;
  if (array && array->GetNumberOfTuples() > 0)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      numbers.push_back(array->GetComponentRange(k)[0]);
    }
  }
  return numbers;
}

QStringList imagesWithCamera(pqOutputPort* port)
{
  vtkPVDataSetAttributesInformation* fields = fieldsOf(port);
  QStringList images;
  for (int k = 0; fields && k < fields->GetNumberOfArrays(); ++k)
  {
    const QString name = fields->GetArrayInformation(k)->GetName();
    if (name.startsWith(imagePrefix))
    {
      images.append(name.mid(int(qstrlen(imagePrefix))));
    }
  }
  return images;
}

QString imageCamera(const QString& image)
{
  return imagePrefix + image;
}

pqOutputPort* portWithField(pqView* view, const QString& name)
{
  QList<pqOutputPort*> candidates;
  if (pqPipelineSource* source = pqActiveObjects::instance().activeSource())
  {
    candidates.append(pqActiveObjects::instance().activePort());
    const QList<pqPipelineSource*> consumers = source->getAllConsumers();
    for (pqPipelineSource* consumer : consumers)
    {
      candidates.append(consumer->getOutputPort(0));
    }
  }
  candidates.append(visiblePorts(view));
  for (pqOutputPort* port : candidates)
  {
    if (hasField(port, name))
    {
      return port;
    }
  }
  return nullptr;
}

void followActive(QObject* receiver, const std::function<void()>& update)
{
  pqActiveObjects* active = &pqActiveObjects::instance();
  QObject::connect(active, &pqActiveObjects::viewChanged, receiver, update);
  QObject::connect(active, &pqActiveObjects::portChanged, receiver, update);
  QObject::connect(active, &pqActiveObjects::dataUpdated, receiver, update);
  QObject::connect(active, &pqActiveObjects::viewUpdated, receiver, update);
}

bool showsOthers(pqView* view, const pqOutputPort* port)
{
  const QList<pqOutputPort*> ports = visiblePorts(view);
  return std::any_of(
    ports.begin(), ports.end(), [port](const pqOutputPort* shown) { return shown != port; });
}
}
