#include "gui/report/chart_panel.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

namespace {

const QColor kGrid(0xE3, 0xE3, 0xE3);
const QColor kPause(0xD0, 0xD0, 0xD0);

}  // namespace

double tick_step(double span, int count) {
  const double raw = span / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * 0.999) return factor * power;
  }
  return 10.0 * power;
}

QString chart::number(double value, int digits) { return decimal(value, digits); }

double Panel::y(double value) const { return frame_.bottom() - frame_.height() * std::clamp(value / top_, 0.0, 1.0); }

void Panel::axes(const QString& title, int value_ticks, bool times) {
  const double value_step = tick_step(top_, value_ticks);
  const double time_step = tick_step(end_s_, 12);
  painter_.setPen(QPen(kGrid, em_ * 0.06));
  for (double v = value_step; v <= top_ * 1.0001; v += value_step) {
    painter_.drawLine(QPointF(frame_.left(), y(v)), QPointF(frame_.right(), y(v)));
  }
  for (double t = time_step; t <= end_s_ * 1.0001; t += time_step) {
    painter_.drawLine(QPointF(x(t), frame_.top()), QPointF(x(t), frame_.bottom()));
  }
  painter_.setPen(QPen(chart::kInk, em_ * 0.09));
  painter_.drawLine(frame_.bottomLeft(), frame_.bottomRight());
  painter_.drawLine(frame_.bottomLeft(), frame_.topLeft());
  for (double v = 0.0; v <= top_ * 1.0001; v += value_step) {
    painter_.drawText(QRectF(frame_.left() - 5.5 * em_, y(v) - em_, 5.0 * em_, 2.0 * em_),
                      Qt::AlignRight | Qt::AlignVCenter, short_decimal(v, 6));
  }
  if (times) {
    for (double t = 0.0; t <= end_s_ * 1.0001; t += time_step) {
      painter_.drawText(QRectF(x(t) - 3.0 * em_, frame_.bottom() + 0.25 * em_, 6.0 * em_, 1.5 * em_),
                        Qt::AlignHCenter | Qt::AlignTop, short_decimal(t, 6));
    }
    painter_.drawText(QRectF(frame_.left(), frame_.bottom() + 1.7 * em_, frame_.width(), 1.6 * em_),
                      Qt::AlignHCenter | Qt::AlignTop,
                      QCoreApplication::translate("Charts", "time since the trial began (s)"));
  }
  painter_.save();
  painter_.translate(frame_.left() - 5.2 * em_, frame_.center().y());
  painter_.rotate(-90.0);
  painter_.drawText(QRectF(-frame_.height(), -em_, 2.0 * frame_.height(), 2.0 * em_), Qt::AlignCenter, title);
  painter_.restore();
}

void Panel::line(const Series& series, const QPen& pen) {
  QPainterPath path;
  std::size_t first = 0;
  while (first < series.time_s.size()) {
    const double column = std::floor(x(series.time_s[first]));
    std::size_t low = first, high = first, last = first;
    while (last + 1 < series.time_s.size() && std::floor(x(series.time_s[last + 1])) == column) {
      ++last;
      if (series.value[last] < series.value[low]) low = last;
      if (series.value[last] > series.value[high]) high = last;
    }
    for (const std::size_t i : {first, std::min(low, high), std::max(low, high), last}) {
      const QPointF point(x(series.time_s[i]), y(series.value[i]));
      path.elementCount() == 0 ? path.moveTo(point) : path.lineTo(point);
    }
    first = last + 1;
  }
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(pen);
  painter_.drawPath(path);
}

void Panel::level(double value, const QColor& colour, Qt::PenStyle style, const QString& text, bool text_above) {
  painter_.setPen(QPen(colour.darker(110), em_ * 0.13, style));
  painter_.drawLine(QPointF(frame_.left(), y(value)), QPointF(frame_.right(), y(value)));
  const double top = text_above ? y(value) - 1.45 * em_ : y(value) + 0.1 * em_;
  label(QRectF(frame_.left(), top, frame_.width() - 0.4 * em_, 1.4 * em_), true, colour.darker(150), text);
}

void Panel::moment(double time_s, const QColor& colour, const QString& text) {
  painter_.setPen(QPen(colour.darker(120), em_ * 0.13, Qt::DashDotLine));
  painter_.drawLine(QPointF(x(time_s), frame_.top()), QPointF(x(time_s), frame_.bottom()));
  if (text.isEmpty()) return;
  const bool left = x(time_s) > frame_.center().x() + frame_.width() * 0.2;
  const double width = 20.0 * em_;
  const QRectF box(left ? x(time_s) - width - 0.4 * em_ : x(time_s) + 0.4 * em_, frame_.top() + 0.1 * em_, width,
                   1.4 * em_);
  label(box, left, colour.darker(170), text);
}

void Panel::pause(double from_s, double to_s, const QString& text) {
  const QRectF box(x(from_s), frame_.top(), x(to_s) - x(from_s), frame_.height());
  painter_.fillRect(box, kPause);
  if (painter_.fontMetrics().horizontalAdvance(text) > box.width()) return;
  painter_.setPen(chart::kInk);
  painter_.drawText(box, Qt::AlignCenter, text);
}

void Panel::peak(double time_s, double value, const QColor& colour, const QString& text) {
  const QPointF at(x(time_s), y(value));
  painter_.setPen(QPen(Qt::white, em_ * 0.15));
  painter_.setBrush(colour);
  painter_.drawEllipse(at, em_ * 0.38, em_ * 0.38);
  const bool left = at.x() > frame_.center().x() + frame_.width() * 0.2;
  const double width = 18.0 * em_;
  label(QRectF(left ? at.x() - width - 0.6 * em_ : at.x() + 0.6 * em_, at.y() - 1.6 * em_, width, 1.4 * em_), left,
        colour.darker(130), text);
}

void Panel::label(const QRectF& box, bool right_aligned, const QColor& colour, const QString& text) {
  const Qt::Alignment alignment = (right_aligned ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
  const QRectF tight = painter_.boundingRect(box, alignment, text);
  painter_.fillRect(tight.adjusted(-0.15 * em_, 0, 0.15 * em_, 0), QColor(255, 255, 255, 215));
  painter_.setPen(colour);
  painter_.drawText(box, alignment, text);
}

void Panel::span(double from_s, double to_s, const QColor& colour) {
  painter_.fillRect(QRectF(x(from_s), frame_.top(), x(to_s) - x(from_s), frame_.height()), colour);
}

void draw_legend(QPainter& painter, const QRectF& row, double em, const std::vector<LegendEntry>& entries) {
  double x = row.left();
  for (const LegendEntry& entry : entries) {
    painter.setPen(entry.pen);
    painter.drawLine(QPointF(x, row.center().y()), QPointF(x + 2.2 * em, row.center().y()));
    painter.setPen(chart::kInk);
    const double width = painter.fontMetrics().horizontalAdvance(entry.text);
    painter.drawText(QRectF(x + 2.7 * em, row.top(), width + em, row.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     entry.text);
    x += 2.7 * em + width + 2.0 * em;
  }
}

TimeAxis chart_time_axis(int width, int height, double last_s) {
  const double em = chart_em(width, height);
  return {7.0 * em, width - 1.5 * em, std::max(1.0, last_s)};
}

double chart_em(int width, int height) { return std::max(10.0, std::min(width / 80.0, height / 45.0)); }

void begin_chart(QPainter& painter, double em, double left, double right, const QString& title) {
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(std::lround(em)));
  QFont bold = font;
  bold.setBold(true);
  bold.setPixelSize(static_cast<int>(std::lround(1.2 * em)));
  painter.setFont(bold);
  painter.setPen(chart::kInk);
  painter.drawText(QRectF(left, 0.6 * em, right - left, 1.8 * em), Qt::AlignLeft | Qt::AlignVCenter, title);
  painter.setFont(font);
}

}  // namespace vallecula::gui
