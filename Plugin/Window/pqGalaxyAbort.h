/**
 * @class   pqGalaxyAbort
 * @brief   makes the status bar's Abort button work for what takes long in this plugin
 *
 * ParaView 5.11 shows progress, but no button: its window sees nothing of what the user does before
 * the work is done. Here the plugin's sources, filters and pictures look up, as often as they tell
 * their progress, whether the button was pressed. An aborted source or filter has no data and asks
 * for Apply; an aborted picture is a preview. A picture that is only being refined also makes way
 * for whatever else the user wants to do.
 *
 * Of a server that is not built in ParaView shows the progress as ever; it cannot be aborted.
 */
#ifndef pqGalaxyAbort_h
#define pqGalaxyAbort_h

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>

#include "vtkObject.h"
#include "vtkWeakPointer.h"

#include <vector>

class pqPipelineSource;
class pqProgressWidget;
class pqView;
class WaitingInput;

class pqGalaxyAbort : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqGalaxyAbort(QObject* parent = nullptr);

  ///@{
  /// Called by ParaView as the plugin is loaded and as the window closes.
  void startup();
  void shutdown();
  ///@}

private Q_SLOTS:
  void onSourceAdded(pqPipelineSource* source);
  void onViewAdded(pqView* view);
  void onAbort() { this->Wanted = true; }
  void onEnd();

private:
  Q_DISABLE_COPY(pqGalaxyAbort)

  void watchPictures(pqView* view);
  void watch(vtkObject* object, unsigned long event,
    void (pqGalaxyAbort::*answer)(vtkObject*, unsigned long, void*));
  void onProgress(vtkObject* algorithm, unsigned long, void*);
  void onAbortCheck(vtkObject* window, unsigned long, void*);

  struct Watch
  {
    vtkWeakPointer<vtkObject> object;
    unsigned long tag;
  };

  WaitingInput* Input;
  QPointer<pqProgressWidget> Bar;
  std::vector<Watch> Watched;
  QElapsedTimer SinceAnswer;
  bool Answering = false;
  bool Wanted = false;
};

#endif
