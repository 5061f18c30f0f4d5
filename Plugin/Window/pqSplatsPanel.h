/**
 * @class   pqSplatsPanel
 * @brief   leaves out of the display's panel what says nothing to Splats
 *
 * ParaView shows colouring, opacity, lighting and the like for every representation of a dataset.
 * While Splats is chosen these groups are hidden, by the means by which ParaView hides some of them
 * for volumes; they come back with any other representation.
 */
#ifndef pqSplatsPanel_h
#define pqSplatsPanel_h

#include <QObject>

class pqSplatsPanel : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqSplatsPanel(QObject* parent = nullptr);

  ///@{
  /// Called by ParaView as the plugin is loaded and as the window closes.
  void startup();
  void shutdown();
  ///@}

private:
  Q_DISABLE_COPY(pqSplatsPanel)
};

#endif
