/**
 * @class   pqUnitDecorator
 * @brief   names a property's unit behind its label
 *
 * For `<PropertyWidgetDecorator type="GalaxyUnit" unit="kpc" />` among a property's hints. A label
 * of the property itself would be its name in scripts.
 */
#ifndef pqUnitDecorator_h
#define pqUnitDecorator_h

#include "pqPropertyWidgetDecorator.h"

class pqUnitDecorator : public pqPropertyWidgetDecorator
{
  Q_OBJECT
  typedef pqPropertyWidgetDecorator Superclass;

public:
  pqUnitDecorator(vtkPVXMLElement* hint, pqPropertyWidget* parent);

  bool eventFilter(QObject* widget, QEvent* event) override;

private:
  Q_DISABLE_COPY(pqUnitDecorator)

  void nameUnit();
};

#endif
