/**
 * @class   pqGalaxyToolBar
 * @brief   opens galaxies and looks at them: the window's toolbar
 */
#ifndef pqGalaxyToolBar_h
#define pqGalaxyToolBar_h

#include <QToolBar>

class pqGalaxyToolBar : public QToolBar
{
  Q_OBJECT
  typedef QToolBar Superclass;

public:
  explicit pqGalaxyToolBar(QWidget* parent = nullptr);

private:
  Q_DISABLE_COPY(pqGalaxyToolBar)
};

#endif
