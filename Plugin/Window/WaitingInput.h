/**
 * @class   WaitingInput
 * @brief   what the user does while the window is busy
 *
 * Lets one button of the window answer in the midst of long work. All other clicks, moves and keys
 * wait until the work is done and come in their order then: nothing of the window must change under
 * the work, and nothing that the user did be lost.
 */
#ifndef WaitingInput_h
#define WaitingInput_h

#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

class QEvent;
class QWidget;

class WaitingInput : public QObject
{
public:
  explicit WaitingInput(QObject* parent);
  ~WaitingInput() override;

  /// Answers what was done with the button since the last time, and repaints the window.
  void answer(QWidget* button);

  /// Whether a click, the wheel or a key waits.
  bool isWanted() const;

  /// Sends what waits, once the work is done.
  void deliver();

  bool eventFilter(QObject* receiver, QEvent* event) override;

private:
  struct Item
  {
    QPointer<QObject> receiver;
    std::unique_ptr<QEvent> event;
  };

  QPointer<QWidget> Button;
  std::vector<Item> Items;
};

#endif
