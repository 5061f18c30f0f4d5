#include "ComponentRow.h"

#include "pqColorChooserButton.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QToolButton>

namespace
{
/// As narrow as a panel needs, and without trailing zeros.
class FactorBox : public QDoubleSpinBox
{
public:
  explicit FactorBox(QWidget* parent)
    : QDoubleSpinBox(parent)
  {
    this->setRange(0, 1000);
    this->setDecimals(4);
    this->setSingleStep(0.1);
    this->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    this->setButtonSymbols(QAbstractSpinBox::NoButtons);
    this->setKeyboardTracking(false);
    this->setFixedWidth(this->fontMetrics().horizontalAdvance("0.000") + 10);
  }

  QString textFromValue(double value) const override { return QString::number(value, 'g', 5); }
};
}

ComponentRow::ComponentRow(const QString& name, QGridLayout* grid, int row, QWidget* parent)
  : QObject(parent)
  , Name(name)
  , Visible(new QCheckBox(name, parent))
  , Size(this->makeFactor("Size", "Factor on the smoothing lengths", parent))
  , Brightness(this->makeFactor("Brightness", "Factor on the light, or the opacity", parent))
  , Color(new pqColorChooserButton(parent))
  , OwnColor(new QToolButton(parent))
{
  this->Visible->setObjectName("Visible " + name); // as tests address it
  this->Visible->setToolTip("Whether it is drawn");
  QObject::connect(this->Visible, &QCheckBox::toggled, this, &ComponentRow::changed);
  this->makeColor();
  grid->addWidget(this->Visible, row, 0);
  grid->addWidget(this->Size, row, 1);
  grid->addWidget(this->Brightness, row, 2);
  grid->addWidget(this->Color, row, 3);
  grid->addWidget(this->OwnColor, row, 4);
}

ComponentRow::~ComponentRow()
{
  for (QWidget* widget : std::initializer_list<QWidget*>{
         this->Visible, this->Size, this->Brightness, this->Color, this->OwnColor })
  {
    delete widget;
  }
}

QDoubleSpinBox* ComponentRow::makeFactor(const char* what, const char* tip, QWidget* parent)
{
  auto* box = new FactorBox(parent);
  box->setObjectName(QString("%1 %2").arg(what, this->Name));
  box->setToolTip(tip);
  QObject::connect(
    box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &ComponentRow::changed);
  return box;
}

void ComponentRow::makeColor()
{
  this->Color->setObjectName("Color " + this->Name);
  this->Color->setToolTip("Colour of its light, in place of the particles' own; of dust, how much "
                          "of red, green and blue it takes");
  QObject::connect(this->Color, &pqColorChooserButton::validColorChosen, this, [this] {
    this->Chosen = this->Color->chosenColorRgbF();
    this->showColor();
    Q_EMIT this->changed();
  });
  this->OwnColor->setObjectName("OwnColor " + this->Name);
  this->OwnColor->setText(QString(QChar(0x2715)));
  this->OwnColor->setAutoRaise(true);
  this->OwnColor->setToolTip("Back to the particles' own colours");
  QObject::connect(this->OwnColor, &QToolButton::clicked, this, [this] {
    this->Chosen.clear();
    this->showColor();
    Q_EMIT this->changed();
  });
}

ComponentRow::State ComponentRow::state() const
{
  return { this->Visible->isChecked(), this->Size->value(), this->Brightness->value(),
    this->Chosen };
}

void ComponentRow::setState(const State& state)
{
  const QSignalBlocker blocked(this);
  this->Visible->setChecked(state.visible);
  this->Size->setValue(state.size);
  this->Brightness->setValue(state.brightness);
  this->Chosen = state.color;
  this->showColor();
}

void ComponentRow::showColor()
{
  const QSignalBlocker blocked(this->Color);
  const bool own = this->Chosen.size() != 3;
  this->Color->setChosenColorRgbF(own ? QVariantList{ 1.0, 1.0, 1.0 } : this->Chosen);
  this->Color->setText("own");
  this->Color->setToolButtonStyle(own ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly);
  this->OwnColor->setVisible(!own);
}
