#ifndef galaxy_ComponentRow_h
#define galaxy_ComponentRow_h

#include <QObject>
#include <QVariantList>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QToolButton;
class QWidget;
class pqColorChooserButton;

/// A component's row in the table: whether it is drawn, the factors on its size and its brightness,
/// and its colour, which is its particles' own until one is chosen.
class ComponentRow : public QObject
{
  Q_OBJECT

public:
  struct State
  {
    bool visible = true;
    double size = 1;
    double brightness = 1;
    QVariantList color; ///< red, green, blue from 0 to 1; empty: the particles' own
  };

  /// Lays its widgets into a row of the grid.
  ComponentRow(const QString& name, QGridLayout* grid, int row, QWidget* parent);
  ~ComponentRow() override;

  const QString& name() const { return this->Name; }
  State state() const;
  /// Does not emit changed().
  void setState(const State& state);

Q_SIGNALS:
  /// By a person.
  void changed();

private:
  QDoubleSpinBox* makeFactor(const char* what, const char* tip, QWidget* parent);
  void makeColor();
  void showColor();

  QString Name;
  QCheckBox* Visible;
  QDoubleSpinBox* Size;
  QDoubleSpinBox* Brightness;
  pqColorChooserButton* Color;
  QToolButton* OwnColor;
  QVariantList Chosen;
};

#endif
