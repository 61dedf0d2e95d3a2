#include "gui/records_pages/trial_chart.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/report/chart_panel.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kRadius = 4.5;  ///< of a mark, pixels
constexpr double kReach = 12.0;  ///< of the mouse
constexpr int kLeft = 46, kTop = 26, kRight = 12, kBottom = 20;

void draw_mark(QPainter& painter, const QPointF& at, TrialChart::Mark mark) {
  using Mark = TrialChart::Mark;
  painter.setBrush(Qt::NoBrush);
  switch (mark) {
    case Mark::good:  // filled disc
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme::within());
      painter.drawEllipse(at, kRadius, kRadius);
      break;
    case Mark::bad:  // cross
      painter.setPen(QPen(theme::bad().lighter(125), 2.2));
      painter.drawLine(at + QPointF(-kRadius, -kRadius), at + QPointF(kRadius, kRadius));
      painter.drawLine(at + QPointF(-kRadius, kRadius), at + QPointF(kRadius, -kRadius));
      break;
    case Mark::neutral:  // small disc
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme::text());
      painter.drawEllipse(at, 0.6 * kRadius, 0.6 * kRadius);
      break;
    case Mark::interrupted:  // open square
      painter.setPen(QPen(theme::faint(), 1.5));
      painter.drawRect(QRectF(at.x() - kRadius, at.y() - kRadius, 2 * kRadius, 2 * kRadius));
      break;
  }
}

}  // namespace

TrialChart::TrialChart(QWidget* parent) : QWidget(parent) {
  setMinimumSize(260, 130);
  setMouseTracking(true);
}

void TrialChart::show_content(Content content) {
  content_ = std::move(content);
  current_ = -1;
  low_ = 0.0;
  high_ = 0.0;
  for (const Point& point : content_.points)
    if (point.value) low_ = std::min(low_, *point.value), high_ = std::max(high_, *point.value);
  for (const Level& level : content_.levels) low_ = std::min(low_, level.value), high_ = std::max(high_, level.value);
  if (high_ - low_ <= 0.0) high_ = low_ + 1.0;
  const double room = 0.1 * (high_ - low_);
  if (low_ < 0.0) low_ -= room;
  high_ += room;
  setAccessibleName(content_.title);
  update();
}

void TrialChart::set_current(int index) {
  current_ = index;
  update();
}

QRectF TrialChart::frame() const { return QRectF(rect()).adjusted(kLeft, kTop, -kRight, -kBottom); }

double TrialChart::y(double value) const {
  return frame().bottom() - frame().height() * (value - low_) / (high_ - low_);
}

QPointF TrialChart::position(int index) const {
  const QRectF in = frame();
  const double step = in.width() / static_cast<double>(std::max<std::size_t>(content_.points.size(), 5));
  const Point& point = content_.points[static_cast<std::size_t>(index)];
  return {in.left() + (index + 0.5) * step, point.value ? y(*point.value) : in.bottom() - kRadius - 1.0};
}

void TrialChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme::text());
  painter.drawText(QRectF(6, 2, width() - 12, kTop - 6), Qt::AlignLeft | Qt::AlignVCenter, content_.title);
  if (content_.points.empty()) {
    painter.setPen(theme::faint());
    painter.drawText(QRectF(rect()).adjusted(20, kTop, -20, -8), Qt::AlignCenter | Qt::TextWordWrap, content_.empty);
    return;
  }
  draw_scales(painter);
  draw_points(painter);
}

void TrialChart::draw_scales(QPainter& painter) const {
  const QRectF in = frame();
  const double step = tick_step(high_ - low_, 4);
  for (double value = std::ceil(low_ / step) * step; value <= high_; value += step) {
    const double at = y(value);
    painter.setPen(QPen(theme::track(), 1.0));
    painter.drawLine(QPointF(in.left(), at), QPointF(in.right(), at));
    painter.setPen(theme::faint());
    painter.drawText(QRectF(0, at - 9, kLeft - 6, 18), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(std::abs(value) < 1e-9 * step ? 0.0 : value));
  }
  const int count = static_cast<int>(content_.points.size());
  const int every = std::max(1, static_cast<int>(std::ceil(tick_step(count, 12))));
  for (int number = every; number <= count; number += every) {
    painter.setPen(theme::faint());
    painter.drawText(QRectF(position(number - 1).x() - 20, in.bottom() + 2, 40, kBottom - 2),
                     Qt::AlignHCenter | Qt::AlignTop, QString::number(number));
  }
  painter.setPen(theme::faint());
  painter.drawText(QRectF(2, in.bottom() + 2, kLeft - 6, kBottom - 2), Qt::AlignLeft | Qt::AlignTop, tr("trial"));
  for (const Level& level : content_.levels) {
    painter.setPen(QPen(level.colour, 1.4, Qt::DashLine));
    painter.drawLine(QPointF(in.left(), y(level.value)), QPointF(in.right(), y(level.value)));
    painter.setPen(level.colour.lighter(115));
    const double top = level.text_below ? y(level.value) + 1 : y(level.value) - 17;
    painter.drawText(QRectF(in.left(), top, in.width() - 4, 16), Qt::AlignRight | Qt::AlignVCenter, level.text);
  }
}

void TrialChart::draw_points(QPainter& painter) const {
  int before = -1;
  painter.setPen(QPen(theme::device(), 1.6));
  for (int i = 0; i < static_cast<int>(content_.points.size()); ++i) {
    const Point& point = content_.points[static_cast<std::size_t>(i)];
    if (!point.value || point.apart) continue;
    if (before >= 0 && !point.begins) painter.drawLine(position(before), position(i));
    before = i;
  }
  for (int i = 0; i < static_cast<int>(content_.points.size()); ++i) {
    if (i == current_) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(theme::text(), 1.5));
      painter.drawEllipse(position(i), 2.0 * kRadius, 2.0 * kRadius);
    }
    draw_mark(painter, position(i), content_.points[static_cast<std::size_t>(i)].mark);
  }
}

int TrialChart::nearest(const QPointF& at) const {
  int found = -1;
  double best = kReach;
  for (int i = 0; i < static_cast<int>(content_.points.size()); ++i) {
    const QPointF away = position(i) - at;
    const double distance = std::hypot(away.x(), away.y());
    if (distance <= best) found = i, best = distance;
  }
  return found;
}

void TrialChart::mousePressEvent(QMouseEvent* event) {
  const int index = nearest(event->localPos());
  if (index >= 0) emit pointed_at(index);
}

void TrialChart::mouseDoubleClickEvent(QMouseEvent* event) {
  const int index = nearest(event->localPos());
  if (index >= 0) emit wanted(index);
}

bool TrialChart::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  const int index = nearest(help->pos());
  if (index >= 0)
    QToolTip::showText(help->globalPos(), content_.points[static_cast<std::size_t>(index)].tip, this);
  else
    QToolTip::hideText();
  return true;
}

}  // namespace vallecula::gui
