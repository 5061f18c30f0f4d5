#include "pqSplatsPanel.h"

#include "pqApplicationCore.h"
#include "pqRepresentation.h"
#include "pqServerManagerModel.h"

#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"

#include <QString>

namespace
{
/// Splats' own groups say by a hint that they belong to it; polar axes stand around any data.
bool appliesToSplats(vtkSMPropertyGroup* group)
{
  vtkPVXMLElement* hints = group->GetHints();
  vtkPVXMLElement* decorator =
    hints ? hints->FindNestedElementByName("PropertyWidgetDecorator") : nullptr;
  return (decorator && decorator->GetAttribute("value") == QString("Splats")) ||
    group->GetXMLLabel() == QString("Annotations");
}

/// Adds to the hints by which the group's rows are shown.
void hideWithSplats(vtkSMPropertyGroup* group)
{
  vtkNew<vtkPVXMLElement> decorator;
  decorator->SetName("PropertyWidgetDecorator");
  decorator->AddAttribute("type", "GenericDecorator");
  decorator->AddAttribute("mode", "visibility");
  decorator->AddAttribute("property", "Representation");
  decorator->AddAttribute("value", "Splats");
  decorator->AddAttribute("inverse", "1");
  // All representations share the old ones.
  vtkNew<vtkPVXMLElement> hints;
  hints->SetName("Hints");
  vtkPVXMLElement* old = group->GetHints();
  for (unsigned int k = 0; old && k < old->GetNumberOfNestedElements(); ++k)
  {
    hints->AddNestedElement(old->GetNestedElement(k), 0);
  }
  hints->AddNestedElement(decorator);
  group->SetHints(hints);
}

void leaveOutOthers(pqRepresentation* representation)
{
  vtkSMProxy* proxy = representation->getProxy();
  if (proxy->GetXMLName() != QString("GeometryRepresentation"))
  {
    return;
  }
  for (size_t k = 0; k < proxy->GetNumberOfPropertyGroups(); ++k)
  {
    vtkSMPropertyGroup* group = proxy->GetPropertyGroup(k);
    if (!appliesToSplats(group))
    {
      hideWithSplats(group);
    }
  }
}
}

pqSplatsPanel::pqSplatsPanel(QObject* parent)
  : Superclass(parent)
{
}

void pqSplatsPanel::startup()
{
  // Before there is a panel for it.
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::preRepresentationAdded, this, &leaveOutOthers);
}

void pqSplatsPanel::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
}
