#include "pqInformationText.h"

#include "pqView.h"

#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QLabel>
#include <QVBoxLayout>

pqInformationText::pqInformationText(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : Superclass(proxy, parent)
  , Told(property)
  , Text(new QLabel(this))
{
  this->setShowLabel(false);
  this->Text->setObjectName("Text"); // as tests address it
  this->Text->setWordWrap(true);
  this->Text->setTextFormat(Qt::PlainText);
  this->Text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->Text->setToolTip(pqPropertyWidget::getTooltip(property));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Text);
}

void pqInformationText::setView(pqView* view)
{
  if (this->view())
  {
    QObject::disconnect(this->view(), nullptr, this, nullptr);
  }
  this->Superclass::setView(view);
  if (view)
  {
    QObject::connect(view, &pqView::endRender, this, &pqInformationText::ask);
  }
}

void pqInformationText::showEvent(QShowEvent* event)
{
  this->Superclass::showEvent(event);
  this->ask();
}

void pqInformationText::ask()
{
  if (this->isVisible())
  {
    this->proxy()->UpdatePropertyInformation(this->Told);
    const QString told = vtkSMPropertyHelper(this->Told).GetAsString();
    this->Text->setText(QString("%1:\n%2").arg(this->Told->GetXMLLabel(), told.trimmed()));
  }
}
