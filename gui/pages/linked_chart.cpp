#include "gui/pages/linked_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "gui/views/theme.h"

namespace vallecula::gui {

LinkedChart::LinkedChart(const QString& name, double least_em, QWidget* parent)
    : ChartView(name, least_em, false, parent) {
  setToolTip(tr("Click to go there"));
}

void LinkedChart::show_trial(Draw draw, double last_s) {
  last_s_ = last_s;
  now_s_ = 0.0;
  marked_s_ = -1.0;
  show_chart(std::move(draw));
}

void LinkedChart::show_time(double at_s) {
  now_s_ = at_s;
  update();
}

void LinkedChart::mark(double at_s) {
  marked_s_ = at_s;
  update();
}

double LinkedChart::x_of(double at_s) const { return chart_time_axis(form(), last_s_).x(at_s); }

double LinkedChart::time_at(double x) const {
  return std::clamp(chart_time_axis(form(), last_s_).time_s(x), 0.0, last_s_);
}

void LinkedChart::paintEvent(QPaintEvent* event) {
  ChartView::paintEvent(event);
  if (!drawn()) return;
  QPainter painter(this);
  const auto line = [&](double at_s, const QColor& colour, double wide) {
    painter.setPen(QPen(colour, wide));
    painter.drawLine(QPointF(x_of(at_s), 0.0), QPointF(x_of(at_s), height()));
  };
  if (marked_s_ >= 0.0)
    line(marked_s_, QColor(chart::kOrange.red(), chart::kOrange.green(), chart::kOrange.blue(), 150), 7.0);
  line(now_s_, theme::text(), 2.0);
}

void LinkedChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit wanted(time_at(event->pos().x()));
}

void LinkedChart::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) emit wanted(time_at(event->pos().x()));
}

}  // namespace vallecula::gui
