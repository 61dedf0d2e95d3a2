#include "gui/report/chart_panel.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

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

void Panel::axes(const QStringList& titles, int value_ticks, bool times) {
  // As many figures as stand clear of one another.
  const int values = std::clamp(static_cast<int>(frame_.height() / (1.4 * em_)), 1, value_ticks);
  const int seconds = std::clamp(static_cast<int>(frame_.width() / (5.0 * em_)), 1, 12);
  const double value_step = tick_step(top_, values);
  const double time_step = tick_step(end_s_, seconds);
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
    labels_.write(painter_, QRectF(frame_.left() - 4.1 * em_, y(v) - em_, 3.6 * em_, 2.0 * em_),
                  Qt::AlignRight | Qt::AlignVCenter, short_decimal(v, 6));
  }
  if (times) {
    for (double t = 0.0; t <= end_s_ * 1.0001; t += time_step) {
      labels_.write(painter_, QRectF(x(t) - 3.0 * em_, frame_.bottom() + 0.25 * em_, 6.0 * em_, 1.5 * em_),
                    Qt::AlignHCenter | Qt::AlignTop, short_decimal(t, 6));
    }
    labels_.write(painter_, QRectF(frame_.left(), frame_.bottom() + 1.7 * em_, frame_.width(), 1.6 * em_),
                  Qt::AlignHCenter | Qt::AlignTop,
                  QCoreApplication::translate("Charts", "time since the trial began (s)"));
  }
  // Into the gaps above and below, where nothing else is written.
  const QFontMetricsF type(painter_.font());
  const auto place_of = [&](double length) {
    return QRectF(frame_.left() - 6.0 * em_, frame_.center().y() - 0.5 * length, 1.6 * em_, length);
  };
  const double most = frame_.height() + 4.0 * em_, least = frame_.height() + 1.2 * em_;
  const auto fits = std::find_if(titles.begin(), titles.end(), [&](const QString& title) {
    const double length = type.horizontalAdvance(title) + 1.0;
    return length <= most && labels_.is_free(place_of(length));
  });
  const QString title = fits == titles.end() ? titles.back() : *fits;
  const double room = fits == titles.end() ? least : type.horizontalAdvance(title) + 1.0;
  painter_.save();
  painter_.translate(frame_.left() - 5.2 * em_, frame_.center().y());
  painter_.rotate(-90.0);
  labels_.write(painter_, QRectF(-0.5 * room, -0.8 * em_, room, 1.6 * em_), Qt::AlignCenter, title);
  painter_.restore();
}

void Panel::line(const Series& series, const QPen& pen) {
  QPainterPath path;
  std::size_t first = 0;
  QRectF piece;  // of the line, about a letter wide: words keep off it
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
      const QRectF dot(point.x() - 0.5, point.y() - 0.5, 1.0, 1.0);
      piece = piece.isNull() ? dot : piece.united(dot);
    }
    if (piece.width() >= em_) labels_.shun(std::exchange(piece, QRectF()));
    first = last + 1;
  }
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(pen);
  painter_.drawPath(path);
  if (!piece.isNull()) labels_.shun(piece);
}

void Panel::level(double value, const QColor& colour, Qt::PenStyle style, const QString& text, bool text_above) {
  painter_.setPen(QPen(colour.darker(110), em_ * 0.13, style));
  painter_.drawLine(QPointF(frame_.left(), y(value)), QPointF(frame_.right(), y(value)));
  const double high = labels_.row_high(), above = y(value) - high - 0.05 * em_, below = y(value) + 0.1 * em_;
  std::vector<LabelSlot> places;
  for (const double top : {text_above ? above : below, text_above ? below : above})
    places.push_back({QRectF(frame_.left() + 0.4 * em_, top, frame_.width() - 0.8 * em_, high), Qt::AlignRight, false});
  labels_.add(text, colour.darker(150), QRectF(frame_.left(), y(value) - 0.4 * em_, frame_.width(), 0.8 * em_), places);
}

std::vector<LabelSlot> Panel::beside(double x, double gap, double first_top, double step) const {
  const double high = labels_.row_high();
  const LabelSlot right{QRectF(x + gap, 0.0, frame_.right() - x - gap, high), Qt::AlignLeft, true};
  const LabelSlot left{QRectF(frame_.left(), 0.0, x - gap - frame_.left(), high), Qt::AlignRight, true};
  const bool right_first = right.row.width() >= 0.3 * frame_.width();
  std::vector<LabelSlot> places;
  for (double top = first_top; top >= frame_.top() - high && top + high <= frame_.bottom() + 0.3 * em_; top += step)
    for (LabelSlot slot : {right_first ? right : left, right_first ? left : right}) {
      slot.row.moveTop(top);
      if (slot.row.width() > 0.0) places.push_back(slot);
    }
  return places;
}

void Panel::moment(double time_s, const QColor& colour, const QString& text) {
  painter_.setPen(QPen(colour.darker(120), em_ * 0.13, Qt::DashDotLine));
  painter_.drawLine(QPointF(x(time_s), frame_.top()), QPointF(x(time_s), frame_.bottom()));
  labels_.add(text, colour.darker(170), QRectF(x(time_s) - 0.4 * em_, frame_.top(), 0.8 * em_, frame_.height()),
              beside(x(time_s), 0.4 * em_, frame_.top() + 0.1 * em_, 0.5 * labels_.row_high()));
}

void Panel::pause(double from_s, double to_s, const QString& text) {
  const QRectF box(x(from_s), frame_.top(), x(to_s) - x(from_s), frame_.height());
  painter_.fillRect(box, kPause);
  const double high = labels_.row_high(), middle = box.center().y() - 0.5 * high;
  std::vector<LabelSlot> places;
  for (double away = 0.0; middle - away >= frame_.top(); away += 0.5 * high)
    for (const double top : {middle - away, middle + away})
      places.push_back({QRectF(box.left(), top, box.width(), high), Qt::AlignHCenter, true});
  labels_.add(text, chart::kInk, box, places);
}

void Panel::peak(double time_s, double value, const QColor& colour, const QString& text) {
  const QPointF at(x(time_s), y(value));
  painter_.setPen(QPen(Qt::white, em_ * 0.15));
  painter_.setBrush(colour);
  painter_.drawEllipse(at, em_ * 0.38, em_ * 0.38);
  labels_.shun(QRectF(at.x() - 0.4 * em_, at.y() - 0.4 * em_, 0.8 * em_, 0.8 * em_));
  const double high = labels_.row_high();
  std::vector<LabelSlot> places = beside(at.x(), 0.6 * em_, at.y() - high - 0.2 * em_, -0.5 * high);
  const auto below = beside(at.x(), 0.6 * em_, at.y() + 0.2 * em_, 0.5 * high);
  places.insert(places.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(2, places.size())), below.begin(),
                below.end());
  labels_.add(text, colour.darker(130), QRectF(at.x() - 0.5 * em_, at.y() - 0.5 * em_, em_, em_), places);
}

void Panel::span(double from_s, double to_s, const QColor& colour) {
  painter_.fillRect(QRectF(x(from_s), frame_.top(), x(to_s) - x(from_s), frame_.height()), colour);
}

namespace {

constexpr double kLegendRow = 1.4, kLegendMark = 2.7, kLegendApart = 2.0;  // em

/// Where each entry stands, from the legend's top left.
std::vector<QRectF> legend_places(const QFontMetricsF& type, double width, double em,
                                  const std::vector<LegendEntry>& entries) {
  std::vector<QRectF> places;
  double x = 0.0, y = 0.0;
  for (const LegendEntry& entry : entries) {
    const double wanted = std::min(width, kLegendMark * em + type.horizontalAdvance(entry.text) + 1.0);
    if (x > 0.0 && x + wanted > width) {
      x = 0.0;
      y += kLegendRow * em;
    }
    places.emplace_back(x, y, wanted, kLegendRow * em);
    x += wanted + kLegendApart * em;
  }
  return places;
}

QFont chart_font(double em) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(std::lround(em)));
  return font;
}

}  // namespace

double legend_high(const QFontMetricsF& type, double width, double em, const std::vector<LegendEntry>& entries) {
  const auto places = legend_places(type, width, em, entries);
  return places.empty() ? 0.0 : places.back().bottom();
}

void draw_legend(QPainter& painter, ChartLabels& labels, const QPointF& top_left, double width, double em,
                 const std::vector<LegendEntry>& entries) {
  const auto places = legend_places(QFontMetricsF(painter.font()), width, em, entries);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const QRectF place = places[i].translated(top_left);
    painter.setPen(entries[i].pen);
    painter.drawLine(QPointF(place.left(), place.center().y()), QPointF(place.left() + 2.2 * em, place.center().y()));
    painter.setPen(chart::kInk);
    labels.write(painter, place.adjusted(kLegendMark * em, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                 entries[i].text);
  }
}

TimeAxis chart_time_axis(const ChartForm& form, double last_s) {
  return {7.0 * form.em, form.width - 1.5 * form.em, std::max(1.0, last_s)};
}

ChartForm picture_form(int width, int height) {
  return {width, height, std::max(10.0, std::min(width / 80.0, height / 45.0)), true};
}

QFontMetricsF chart_type(double em) { return QFontMetricsF(chart_font(em)); }

double begin_chart(QPainter& painter, ChartLabels& labels, const ChartForm& form, double left, double right,
                   const QString& title, const std::vector<LegendEntry>& legend) {
  const double em = form.em;
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.setPen(chart::kInk);
  double top = 0.3 * em;
  if (form.titled) {
    QFont bold = chart_font(em);
    bold.setBold(true);
    bold.setPixelSize(static_cast<int>(std::lround(1.2 * em)));
    if (QFontMetricsF(bold).horizontalAdvance(title) > right - left)
      bold.setPixelSize(static_cast<int>(std::lround(em)));
    painter.setFont(bold);
    labels.write(painter, QRectF(left, 0.6 * em, right - left, 1.8 * em), Qt::AlignLeft | Qt::AlignVCenter, title);
    top = 2.6 * em;
  }
  painter.setFont(chart_font(em));
  draw_legend(painter, labels, QPointF(left, top), right - left, em, legend);
  return top + legend_high(QFontMetricsF(painter.font()), right - left, em, legend) + 0.6 * em;
}

}  // namespace vallecula::gui
