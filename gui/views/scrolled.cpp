#include "gui/views/scrolled.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <cmath>

namespace vallecula::gui {

Scrolled::Scrolled(QWidget* content, double least_lines, QWidget* parent)
    : QScrollArea(parent), least_lines_(least_lines) {
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);  // keys are the page's
}

QSize Scrolled::sizeHint() const {
  const QWidget& content = *widget();
  const int wide = viewport()->width();
  const int high = content.layout() != nullptr && content.layout()->hasHeightForWidth() ? content.heightForWidth(wide)
                                                                                        : content.sizeHint().height();
  return {content.sizeHint().width(), high};
}

QSize Scrolled::minimumSizeHint() const {
  return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
          static_cast<int>(std::ceil(least_lines_ * fontMetrics().lineSpacing()))};
}

/// Figures that change ask for no new place each time: whoever fits by sizeHint() asks anew.
void Scrolled::tell() {
  if (least_ == minimumSizeHint()) return;
  least_ = minimumSizeHint();
  updateGeometry();
}

void Scrolled::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  tell();
}

bool Scrolled::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) tell();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace vallecula::gui
