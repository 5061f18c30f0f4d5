/**
 * @file
 * @brief copies of events, as Qt 5 or Qt 6 makes them
 */
#ifndef CopyEvent_h
#define CopyEvent_h

#include <QEvent>

#include <memory>

namespace galaxy
{
/// A copy of an event of this class.
template <typename Event>
std::unique_ptr<QEvent> copyEvent(const QEvent* event)
{
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  return std::unique_ptr<QEvent>(event->clone());
#else
  return std::make_unique<Event>(*static_cast<const Event*>(event));
#endif
}
} // namespace galaxy

#endif
