#include "gui/pages/linked_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

// Letters of a low chart beside those of one with room; below that it scrolls.
constexpr double kSmallest = 0.6;
constexpr double kCorner = 1.4;  // em: within the chart's margin at the right, where nothing is written

}  // namespace

LinkedChart::LinkedChart(const QString& name, double least_em, QWidget* parent)
    : ChartView(name, least_em, false, parent), least_em_(least_em), corner_(new QToolButton(this)) {
  setToolTip(tr("Click to go there"));
  corner_->setObjectName("larger");
  corner_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the page
  theme::dress(*corner_, "QToolButton { padding: 0; border-radius: 3px; }");
  connect(corner_, &QToolButton::clicked, this, &LinkedChart::room_wanted);
  show_large(false);
}

double LinkedChart::em() const {
  const double wished = ChartView::em();
  return std::clamp(height() / least_em_, kSmallest * wished, wished);
}

QSize LinkedChart::minimumSizeHint() const {
  return {ChartView::minimumSizeHint().width(), static_cast<int>(std::ceil(kSmallest * ChartView::em() * least_em_))};
}

void LinkedChart::show_large(bool large) {
  corner_->setArrowType(large ? Qt::DownArrow : Qt::UpArrow);
  corner_->setAccessibleName(large ? tr("The views again") : tr("Larger chart"));
  corner_->setToolTip(large ? tr("L: the views again") : tr("L: a larger chart, in the place of views and monitor"));
}

void LinkedChart::resizeEvent(QResizeEvent* event) {
  ChartView::resizeEvent(event);
  const int side = static_cast<int>(kCorner * em());
  corner_->setGeometry(width() - side - 1, 1, side, side);
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
