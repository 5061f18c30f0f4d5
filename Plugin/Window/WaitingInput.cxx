#include "WaitingInput.h"

#include "CopyEvent.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QResizeEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QWindow>

#include <algorithm>

namespace
{
std::unique_ptr<QEvent> copyOf(const QEvent* event)
{
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
      return galaxy::copyEvent<QMouseEvent>(event);
    case QEvent::Wheel:
      return galaxy::copyEvent<QWheelEvent>(event);
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return galaxy::copyEvent<QKeyEvent>(event);
    case QEvent::Resize:
      return galaxy::copyEvent<QResizeEvent>(event);
    case QEvent::Close:
      return std::make_unique<QEvent>(QEvent::Close);
    default:
      return nullptr;
  }
}

bool isOn(QWidget* button, const QEvent* event)
{
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
      break;
    default:
      return false;
  }
  const QPoint place = static_cast<const QMouseEvent*>(event)->globalPos();
  return button && button->isVisible() && button->rect().contains(button->mapFromGlobal(place));
}
}

WaitingInput::WaitingInput(QObject* parent)
  : QObject(parent)
{
}

WaitingInput::~WaitingInput() = default;

void WaitingInput::answer(QWidget* button)
{
  this->Button = button;
  // Where a view is drawing, it goes on with the context that it left; what is painted meanwhile
  // makes others the current one.
  QOpenGLContext* context = QOpenGLContext::currentContext();
  QSurface* surface = context ? context->surface() : nullptr;
  QApplication::instance()->installEventFilter(this);
  QApplication::processEvents(QEventLoop::ExcludeSocketNotifiers);
  QApplication::instance()->removeEventFilter(this);
  if (context)
  {
    context->makeCurrent(surface);
  }
}

bool WaitingInput::eventFilter(QObject* receiver, QEvent* event)
{
  if (event->type() == QEvent::Timer)
  {
    return true; // it comes again
  }
  // A view that draws keeps what it draws into.
  const bool isView = qobject_cast<QOpenGLWidget*>(receiver) != nullptr;
  if (isView && event->type() == QEvent::Paint)
  {
    return true;
  }
  const bool isResized = isView && event->type() == QEvent::Resize;
  // Windows get what the user does first, and pass it on to their widgets.
  const bool isUsers =
    receiver->isWindowType() && event->spontaneous() && !isOn(this->Button, event);
  std::unique_ptr<QEvent> copy = isUsers || isResized ? copyOf(event) : nullptr;
  const bool waits = copy != nullptr;
  if (waits)
  {
    this->Items.push_back({ receiver, std::move(copy) });
  }
  return waits;
}

bool WaitingInput::isWanted() const
{
  return std::any_of(this->Items.begin(), this->Items.end(), [](const Item& item) {
    const QEvent::Type type = item.event->type();
    return type == QEvent::MouseButtonPress || type == QEvent::Wheel || type == QEvent::KeyPress;
  });
}

void WaitingInput::deliver()
{
  for (Item& item : this->Items)
  {
    if (item.receiver)
    {
      QCoreApplication::postEvent(item.receiver, item.event.release());
    }
  }
  this->Items.clear();
}
