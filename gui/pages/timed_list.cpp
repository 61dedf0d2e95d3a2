#include "gui/pages/timed_list.h"

#include <QKeyEvent>

#include "gui/pages/timeline.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

namespace {

constexpr int kTime = Qt::UserRole, kId = Qt::UserRole + 1;

}  // namespace

TimedList::TimedList(const QString& name, QWidget* parent) : QListWidget(parent) {
  setAccessibleName(name);
  setWordWrap(true);
  setStyleSheet("QListWidget::item { padding: 4px 6px; }");
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  const auto go = [this](const QListWidgetItem* item) {
    const double at_s = item->data(kTime).toDouble();
    if (at_s >= 0.0) emit wanted(at_s);
  };
  connect(this, &QListWidget::itemClicked, this, go);
  connect(this, &QListWidget::itemActivated, this, go);
}

void TimedList::add(double at_s, const QString& text, const QColor& colour, const QString& tip, long long id) {
  auto* item = new QListWidgetItem(at_s >= 0.0 ? clock_text(at_s) + "   " + text : text, this);
  item->setForeground(colour);
  item->setToolTip(tip);
  item->setData(kTime, at_s);
  item->setData(kId, id);
}

double TimedList::time_of(int row) const { return item(row)->data(kTime).toDouble(); }

long long TimedList::id_of(int row) const { return item(row)->data(kId).toLongLong(); }

void TimedList::follow(double at_s) {
  if (hasFocus()) return;  // it is somebody's own cursor now
  int last = -1;
  for (int row = 0; row < count() && time_of(row) <= at_s + 1e-3; ++row) last = row;
  if (last != currentRow()) setCurrentRow(last);
}

void TimedList::changeEvent(QEvent* event) {
  QListWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange && event->type() != QEvent::StyleChange) return;
  for (int row = 0; row < count(); ++row)
    item(row)->setForeground(theme::of_this_ground(item(row)->foreground().color()));
}

void TimedList::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Space:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
      return event->ignore();  // the page's
    default:
      QListWidget::keyPressEvent(event);
  }
}

}  // namespace vallecula::gui
