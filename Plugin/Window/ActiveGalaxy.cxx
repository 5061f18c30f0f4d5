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
bool hasField(pqOutputPort* port, const char* name)
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

std::vector<double> fieldNumbers(pqOutputPort* port, const char* name)
{
  // What was never applied has no data, and must not be made to read any.
  if (port->getSource()->modifiedState() == pqProxy::UNINITIALIZED)
  {
    return {};
  }
  vtkPVArrayInformation* array =
    port->getDataInformation()->GetFieldDataInformation()->GetArrayInformation(name);
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

pqOutputPort* portWithField(pqView* view, const char* name)
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

bool showsOthers(pqView* view, const pqOutputPort* port)
{
  const QList<pqOutputPort*> ports = visiblePorts(view);
  return std::any_of(
    ports.begin(), ports.end(), [port](const pqOutputPort* shown) { return shown != port; });
}
}
