/**
 * @class   pqGalaxyMenu
 * @brief   the actions of the menu Galaxy
 */
#ifndef pqGalaxyMenu_h
#define pqGalaxyMenu_h

#include <QActionGroup>

class pqGalaxyMenu : public QActionGroup
{
  Q_OBJECT
  typedef QActionGroup Superclass;

public:
  explicit pqGalaxyMenu(QObject* parent = nullptr);

private:
  Q_DISABLE_COPY(pqGalaxyMenu)

  void addExamples();
  /// The sources or filters that belong to the plugin.
  void addProxies(const char* title, const char* group);
  void addSeparator();
};

#endif
