#include "gui/records_pages/trial_chart.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/report/chart_panel.h"
#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kRadius = 4.5;                            ///< of a mark, pixels
constexpr double kReach = 12.0;                            ///< of the mouse
constexpr double kRight = 12.0;                            ///< pixels
constexpr double kLeastLines = 9.0, kLeastLetters = 24.0;  ///< of text: its least height and width

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

/// In as many lines as its place is high.
void draw_title(QPainter& painter, ChartLabels& labels, const QString& title, const QRectF& place) {
  painter.setPen(theme::text());
  const QFontMetricsF type(painter.font());
  QString rest = title;
  QRectF line(place.left(), place.top(), place.width(), type.lineSpacing());
  while (type.horizontalAdvance(rest) > line.width() && line.bottom() + type.lineSpacing() <= place.bottom() + 1.0) {
    int end = rest.lastIndexOf(' ');
    while (end > 0 && type.horizontalAdvance(rest.left(end)) > line.width()) end = rest.lastIndexOf(' ', end - 1);
    if (end <= 0) break;
    labels.write(painter, line, Qt::AlignLeft | Qt::AlignVCenter, rest.left(end));
    rest = rest.mid(end + 1);
    line.translate(0.0, type.lineSpacing());
  }
  labels.write(painter, line, Qt::AlignLeft | Qt::AlignVCenter, rest);
}

}  // namespace

TrialChart::TrialChart(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
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

QSize TrialChart::minimumSizeHint() const {
  const QFontMetrics type(font());
  return {static_cast<int>(kLeastLetters * type.averageCharWidth()),
          static_cast<int>(kLeastLines * type.lineSpacing())};
}

QSize TrialChart::sizeHint() const { return {std::max(260, minimumSizeHint().width()), minimumSizeHint().height()}; }

double TrialChart::title_high() const {
  const QFontMetricsF type(font());
  const bool one = type.horizontalAdvance(content_.title) <= width() - 12;
  return (one ? 1.0 : 2.0) * type.lineSpacing() + 4.0;
}

double TrialChart::left_wide() const {
  const QFontMetricsF type(font());
  return std::max(type.horizontalAdvance("0.0000"), type.horizontalAdvance(tr("trial"))) + 8.0;
}

QRectF TrialChart::frame() const {
  const double line = QFontMetricsF(font()).lineSpacing();
  return QRectF(rect()).adjusted(left_wide(), title_high() + 0.3 * line, -kRight, -1.5 * line);
}

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
  const QFontMetricsF type(painter.font());
  ChartLabels labels(type, 0.8 * type.lineSpacing());
  draw_title(painter, labels, content_.title, QRectF(6, 2, width() - 12, title_high()));
  if (content_.points.empty()) {
    painter.setPen(theme::faint());
    painter.drawText(QRectF(rect()).adjusted(20, title_high() + 2, -20, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     content_.empty);
    labels_ = labels.draw(painter);
    return;
  }
  draw_scales(painter, labels);
  for (int i = 0; i < static_cast<int>(content_.points.size()); ++i)
    labels.shun(QRectF(position(i).x() - kRadius, position(i).y() - kRadius, 2.0 * kRadius, 2.0 * kRadius));
  QColor paper = theme::ground();
  paper.setAlpha(190);
  labels_ = labels.draw(painter, paper);
  draw_points(painter);  // over the words: no trial is hidden
}

void TrialChart::draw_scales(QPainter& painter, ChartLabels& labels) const {
  const QRectF in = frame();
  const QFontMetricsF type(painter.font());
  const double line = type.lineSpacing(), left = left_wide();
  const double step = tick_step(high_ - low_, std::clamp(static_cast<int>(in.height() / (1.5 * line)), 1, 4));
  for (double value = std::ceil(low_ / step) * step; value <= high_; value += step) {
    const double at = y(value);
    painter.setPen(QPen(theme::track(), 1.0));
    painter.drawLine(QPointF(in.left(), at), QPointF(in.right(), at));
    painter.setPen(theme::faint());
    labels.write(painter, QRectF(0, at - 0.5 * line, left - 6, line), Qt::AlignRight | Qt::AlignVCenter,
                 short_decimal(std::abs(value) < 1e-9 * step ? 0.0 : value, 6));
  }
  const int count = static_cast<int>(content_.points.size());
  const int numbers = std::max(1, static_cast<int>(in.width() / (1.6 * type.horizontalAdvance("0000"))));
  const int every = std::max(1, static_cast<int>(std::ceil(tick_step(count, std::min(12, numbers)))));
  for (int number = every; number <= count; number += every) {
    painter.setPen(theme::faint());
    const QString words = QString::number(number);
    const double half = 0.5 * type.horizontalAdvance(words) + 1.0;
    const double middle = std::min(position(number - 1).x(), width() - half);  // the last ends with the chart
    labels.write(painter, QRectF(middle - half, in.bottom() + 2 + 0.2 * line, 2.0 * half, line), Qt::AlignCenter,
                 words);
  }
  painter.setPen(theme::faint());
  labels.write(painter, QRectF(2, in.bottom() + 2 + 0.2 * line, left - 4, line), Qt::AlignLeft | Qt::AlignTop,
               tr("trial"));
  for (const Level& level : content_.levels) {
    painter.setPen(QPen(level.colour, 1.4, Qt::DashLine));
    painter.drawLine(QPointF(in.left(), y(level.value)), QPointF(in.right(), y(level.value)));
    const double above = y(level.value) - labels.row_high() - 1, below = y(level.value) + 1;
    std::vector<LabelSlot> places;
    for (const double top : {level.text_below ? below : above, level.text_below ? above : below})
      places.push_back({QRectF(in.left() + 4, top, in.width() - 8, labels.row_high()), Qt::AlignRight, false});
    labels.add(level.text, level.colour.lighter(115), QRectF(in.left(), y(level.value) - 4, in.width(), 8), places);
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
  const auto cut = std::find_if(labels_.begin(), labels_.end(), [help](const ChartLabel& label) {
    return label.cut() && label.box.contains(help->pos());
  });
  if (index >= 0)
    QToolTip::showText(help->globalPos(), content_.points[static_cast<std::size_t>(index)].tip, this);
  else if (cut != labels_.end())
    QToolTip::showText(help->globalPos(), cut->whole, this);
  else
    QToolTip::hideText();
  return true;
}

}  // namespace vallecula::gui
