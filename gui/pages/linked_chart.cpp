#include "gui/pages/linked_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "gui/pages/background.h"
#include "gui/report/chart_panel.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

LinkedChart::LinkedChart(const QString& name, QWidget* parent) : QWidget(parent) {
  setAccessibleName(name);
  setToolTip(tr("Click to go there"));
  soon_.setSingleShot(true);
  soon_.setInterval(150);  // while a window is being drawn larger, once
  connect(&soon_, &QTimer::timeout, this, &LinkedChart::draw_now);
}

LinkedChart::~LinkedChart() {
  if (drawing_) drawing_->wait();
}

void LinkedChart::show_chart(Draw draw, double last_s) {
  draw_ = std::move(draw);
  last_s_ = last_s;
  now_s_ = 0.0;
  marked_s_ = -1.0;
  picture_ = QImage();
  problem_.clear();
  draw_soon();
  update();
}

void LinkedChart::draw_soon() {
  ++asked_;
  if (draw_ && isVisible()) soon_.start();
}

void LinkedChart::draw_now() {
  if (drawing_) return soon_.start();  // one at a time
  drawing_ = run_in_background<QImage>(
      this, [draw = draw_, wide = std::max(300, width()), high = std::max(120, height())] { return draw(wide, high); },
      [this, of = asked_](const QImage& picture) {
        if (of != asked_) return;
        picture_ = picture;
        shown_ = theme::of_this_ground(picture_);
        update();
      },
      [this](const QString& message) {
        problem_ = message;
        update();
      });
}

void LinkedChart::show_time(double at_s) {
  now_s_ = at_s;
  update();
}

void LinkedChart::mark(double at_s) {
  marked_s_ = at_s;
  update();
}

double LinkedChart::x_of(double at_s) const { return chart_time_axis(width(), height(), last_s_).x(at_s); }

double LinkedChart::time_at(double x) const {
  return std::clamp(chart_time_axis(width(), height(), last_s_).time_s(x), 0.0, last_s_);
}

void LinkedChart::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange && event->type() != QEvent::StyleChange) return;
  if (drawn()) shown_ = theme::of_this_ground(picture_);
  update();
}

void LinkedChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::panel());
  if (picture_.isNull()) {
    painter.setPen(theme::faint());
    painter.drawText(rect(), Qt::AlignCenter, problem_.isEmpty() ? tr("Drawing ...") : problem_);
    return;
  }
  painter.drawImage(rect(), shown_);
  const auto line = [&](double at_s, const QColor& colour, double wide) {
    painter.setPen(QPen(colour, wide));
    painter.drawLine(QPointF(x_of(at_s), 0.0), QPointF(x_of(at_s), height()));
  };
  if (marked_s_ >= 0.0)
    line(marked_s_, QColor(chart::kOrange.red(), chart::kOrange.green(), chart::kOrange.blue(), 150), 7.0);
  line(now_s_, theme::text(), 2.0);
}

void LinkedChart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  draw_soon();
}

void LinkedChart::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  draw_soon();
}

void LinkedChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit wanted(time_at(event->pos().x()));
}

void LinkedChart::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) emit wanted(time_at(event->pos().x()));
}

}  // namespace vallecula::gui
