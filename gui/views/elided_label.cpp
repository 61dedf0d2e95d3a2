#include "gui/views/elided_label.h"

#include <QEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>

namespace vallecula::gui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::say(const QStringList& wordings, const QString& tip, Qt::TextElideMode cut) {
  wordings_ = wordings;
  tip_ = tip;
  cut_ = cut;
  setText(wordings.value(0));
  tell_whole();
  update();
}

QString ElidedLabel::shown() const {
  const int room = contentsRect().width();
  for (const QString& words : wordings_)
    if (fontMetrics().horizontalAdvance(words) <= room) return words;
  return wordings_.isEmpty() ? QString() : fontMetrics().elidedText(wordings_.back(), cut_, room);
}

void ElidedLabel::tell_whole() {
  const QString whole = wordings_.value(0);
  setToolTip(!tip_.isEmpty() ? tip_ : shown() == whole ? QString() : whole);
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QStyleOption option;
  option.initFrom(this);
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), option.palette, isEnabled(), shown(),
                        foregroundRole());
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  tell_whole();
}

void ElidedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) tell_whole();
}

}  // namespace vallecula::gui
