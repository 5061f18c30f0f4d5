/**
 * @class   pqComponentTableWidget
 * @brief   the components of Splats, a row each
 *
 * For a property group with ComponentVisibility, ComponentSize, ComponentBrightness and
 * ComponentColor; the names come from the property ComponentNames beside them. Only what differs
 * from its default is written to the properties, so that what is traced and saved stays short.
 */
#ifndef pqComponentTableWidget_h
#define pqComponentTableWidget_h

#include "pqPropertyGroupWidget.h"

#include "ComponentFactors.h"

#include <QList>

class ComponentRow;
class QGridLayout;

class pqComponentTableWidget : public pqPropertyGroupWidget
{
  Q_OBJECT
  typedef pqPropertyGroupWidget Superclass;
  Q_PROPERTY(QVariantList visibilities READ visibilities WRITE setVisibilities NOTIFY edited)
  Q_PROPERTY(QVariantList sizes READ sizes WRITE setSizes NOTIFY edited)
  Q_PROPERTY(QVariantList brightnesses READ brightnesses WRITE setBrightnesses NOTIFY edited)
  Q_PROPERTY(QVariantList colors READ colors WRITE setColors NOTIFY edited)

public:
  pqComponentTableWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqComponentTableWidget() override;

  ///@{
  /// As the four properties hold them.
  QVariantList visibilities() const { return this->Visibilities.list(); }
  QVariantList sizes() const { return this->Sizes.list(); }
  QVariantList brightnesses() const { return this->Brightnesses.list(); }
  QVariantList colors() const { return this->Colors.list(); }
  void setVisibilities(const QVariantList& list) { this->take(this->Visibilities, list); }
  void setSizes(const QVariantList& list) { this->take(this->Sizes, list); }
  void setBrightnesses(const QVariantList& list) { this->take(this->Brightnesses, list); }
  void setColors(const QVariantList& list) { this->take(this->Colors, list); }
  ///@}

Q_SIGNALS:
  void edited();

private Q_SLOTS:
  /// Asks the representation for its components and makes their rows.
  void updateNames();

private:
  Q_DISABLE_COPY(pqComponentTableWidget)

  void link(const char* property, const char* mine);
  void take(galaxy::ComponentFactors& factors, const QVariantList& list);
  void makeRows(const QStringList& names);
  void showAll();
  void onEdited(ComponentRow* row);

  QGridLayout* Grid;
  QList<ComponentRow*> Rows;
  galaxy::ComponentFactors Visibilities, Sizes, Brightnesses;
  galaxy::ComponentFactors Colors{ 3 };
  unsigned long Observer = 0;
};

#endif
