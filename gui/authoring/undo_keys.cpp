#include "gui/authoring/undo_keys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace vallecula::gui {

void UndoKeys::watch(QWidget* page) {
  page_ = page;
  qApp->installEventFilter(this);
}

bool UndoKeys::eventFilter(QObject* receiver, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  auto* widget = qobject_cast<QWidget*>(receiver);
  auto* key = static_cast<QKeyEvent*>(event);
  if (widget == nullptr || !page_->isAncestorOf(widget)) return false;
  if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
  event->ignore();  // the field would take it; so it becomes the page's shortcut
  return true;
}

}  // namespace vallecula::gui
