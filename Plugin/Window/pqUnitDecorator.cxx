#include "pqUnitDecorator.h"

#include "pqPropertyWidget.h"

#include "vtkPVXMLElement.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

namespace
{
/// What stands before a widget in the panel's rows of label and widget.
QLabel* labelOf(QWidget* widget)
{
  QWidget* panel = widget->parentWidget();
  auto* rows = panel ? qobject_cast<QGridLayout*>(panel->layout()) : nullptr;
  const int at = rows ? rows->indexOf(widget) : -1;
  if (at < 0)
  {
    return nullptr;
  }
  int row = 0, column = 0, rowSpan = 0, columnSpan = 0;
  rows->getItemPosition(at, &row, &column, &rowSpan, &columnSpan);
  QLayoutItem* first = column > 0 ? rows->itemAtPosition(row, 0) : nullptr;
  return first ? qobject_cast<QLabel*>(first->widget()) : nullptr;
}
}

pqUnitDecorator::pqUnitDecorator(vtkPVXMLElement* hint, pqPropertyWidget* parent)
  : Superclass(hint, parent)
{
  parent->installEventFilter(this);
}

bool pqUnitDecorator::eventFilter(QObject* widget, QEvent* event)
{
  // By then it has its place in the panel.
  if (event->type() == QEvent::Show)
  {
    this->nameUnit();
  }
  return this->Superclass::eventFilter(widget, event);
}

void pqUnitDecorator::nameUnit()
{
  const QString unit = QString(" (%1)").arg(this->xml()->GetAttributeOrEmpty("unit"));
  QLabel* label = labelOf(this->parentWidget());
  if (label && !label->text().contains(unit))
  {
    QString text = label->text();
    const int paragraphEnd = text.lastIndexOf("</p>");
    text.insert(paragraphEnd < 0 ? text.size() : paragraphEnd, unit);
    label->setText(text);
  }
}
