#include "pqComponentTableWidget.h"

#include "ComponentRow.h"

#include "vtkCommand.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QGridLayout>
#include <QLabel>

pqComponentTableWidget::pqComponentTableWidget(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(proxy, group, parent)
  , Grid(new QGridLayout(this))
{
  this->setShowLabel(true);
  this->Grid->setContentsMargins(0, 0, 0, 0);
  this->Grid->setHorizontalSpacing(4);
  this->Grid->setVerticalSpacing(2);
  this->Grid->setColumnStretch(
    5, 1); // nothing there: panels can be wider than what is seen of them
  const QStringList titles = { "Component", "Size", "Light", "Colour" };
  for (int column = 0; column < titles.size(); ++column)
  {
    this->Grid->addWidget(new QLabel(titles[column], this), 0, column);
  }
  this->link("ComponentVisibility", "visibilities");
  this->link("ComponentSize", "sizes");
  this->link("ComponentBrightness", "brightnesses");
  this->link("ComponentColor", "colors");
  this->updateNames();
  this->Observer =
    proxy->AddObserver(vtkCommand::UpdateDataEvent, this, &pqComponentTableWidget::updateNames);
}

pqComponentTableWidget::~pqComponentTableWidget()
{
  this->proxy()->RemoveObserver(this->Observer);
}

void pqComponentTableWidget::link(const char* property, const char* mine)
{
  if (vtkSMProperty* linked = this->propertyGroup()->GetProperty(property))
  {
    this->addPropertyLink(this, mine, SIGNAL(edited()), linked);
  }
}

void pqComponentTableWidget::updateNames()
{
  vtkSMProperty* names = this->proxy()->GetProperty("ComponentNames");
  if (!names)
  {
    return;
  }
  this->proxy()->UpdatePropertyInformation(names);
  const QString all = vtkSMPropertyHelper(names).GetAsString();
  this->makeRows(all.split('\n', Qt::SkipEmptyParts));
}

void pqComponentTableWidget::makeRows(const QStringList& names)
{
  QStringList shown;
  for (const ComponentRow* row : this->Rows)
  {
    shown.append(row->name());
  }
  if (names == shown)
  {
    return;
  }
  for (ComponentRow* row : this->Rows)
  {
    delete row;
  }
  this->Rows.clear();
  for (const QString& name : names)
  {
    auto* row = new ComponentRow(name, this->Grid, this->Rows.size() + 1, this);
    QObject::connect(row, &ComponentRow::changed, this, [=] { this->onEdited(row); });
    this->Rows.append(row);
  }
  this->showAll();
}

void pqComponentTableWidget::take(galaxy::ComponentFactors& factors, const QVariantList& list)
{
  factors.set(list);
  this->showAll();
}

void pqComponentTableWidget::showAll()
{
  for (ComponentRow* row : this->Rows)
  {
    const QString& name = row->name();
    row->setState({ this->Visibilities.value(name, 1) != 0, this->Sizes.value(name, 1),
      this->Brightnesses.value(name, 1), this->Colors.at(name) });
  }
}

void pqComponentTableWidget::onEdited(ComponentRow* row)
{
  const ComponentRow::State state = row->state();
  const QString& name = row->name();
  const bool changes[] = { this->Visibilities.change(name, state.visible ? 1 : 0, 1),
    this->Sizes.change(name, state.size, 1), this->Brightnesses.change(name, state.brightness, 1),
    this->Colors.change(name, state.color) };
  if (changes[0] || changes[1] || changes[2] || changes[3])
  {
    Q_EMIT this->edited();
  }
}
