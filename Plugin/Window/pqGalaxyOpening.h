/**
 * @class   pqGalaxyOpening
 * @brief   shows a galaxy whose file was opened in the window
 *
 * After Apply the model is built behind a GalaxyReader and drawn. Where nothing else is in the
 * view, the view turns black and looks from Earth. Scripts and state files are left alone: they say
 * themselves what follows a reader.
 */
#ifndef pqGalaxyOpening_h
#define pqGalaxyOpening_h

#include <QObject>

class pqPipelineSource;

class pqGalaxyOpening : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqGalaxyOpening(QObject* parent = nullptr);

  ///@{
  /// Called by ParaView as the plugin is loaded and as the window closes.
  void startup();
  void shutdown();
  ///@}

private Q_SLOTS:
  void onReaderCreated(pqPipelineSource* reader);

private:
  Q_DISABLE_COPY(pqGalaxyOpening)

  /// Until it was applied.
  void watch(pqPipelineSource* reader);
  void show(pqPipelineSource* reader);
};

#endif
