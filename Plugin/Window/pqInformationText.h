/**
 * @class   pqInformationText
 * @brief   a text that the proxy tells, to be read and copied
 *
 * For an information property that changes as the data or the view are drawn; its name stands
 * before the text.
 */
#ifndef pqInformationText_h
#define pqInformationText_h

#include "pqPropertyWidget.h"

class QLabel;

class pqInformationText : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  pqInformationText(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

  void setView(pqView* view) override;

protected:
  void showEvent(QShowEvent* event) override;

private:
  Q_DISABLE_COPY(pqInformationText)

  void ask();

  vtkSMProperty* Told;
  QLabel* Text;
};

#endif
