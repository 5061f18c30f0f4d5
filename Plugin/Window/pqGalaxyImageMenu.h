/**
 * @class   pqGalaxyImageMenu
 * @brief   the images of the active galaxy: choosing one looks at its field from Earth
 */
#ifndef pqGalaxyImageMenu_h
#define pqGalaxyImageMenu_h

#include <QMenu>
#include <QStringList>

class pqGalaxyImageMenu : public QMenu
{
  Q_OBJECT
  typedef QMenu Superclass;

public:
  explicit pqGalaxyImageMenu(QWidget* parent = nullptr);

private:
  Q_DISABLE_COPY(pqGalaxyImageMenu)

  void follow();
  void fill();

  QStringList Images;
};

#endif
