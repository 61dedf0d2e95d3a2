#include "gui/pages/timeline.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

namespace {

using Kind = ReplayEvent::Kind;

constexpr double kSide = 12.0, kTrackTop = 22.0, kTrackHeight = 16.0;  // pixels
constexpr double kNear = 6.0;

bool lasts(Kind kind) {
  return kind == Kind::attempt_begins || kind == Kind::pause || kind == Kind::device_limit || kind == Kind::over_target;
}

/// Steps of 1, 2, 5, 10, 15, 30, 60 s ...: about a label every 90 pixels.
double label_step(double end_s, double width) {
  for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0})
    if (end_s / step * 90.0 <= width) return step;
  return 600.0;
}

}  // namespace

QString clock_text(double at_s) {
  const auto tenths = static_cast<long long>(std::floor(10.0 * std::max(0.0, at_s) + 0.5));
  return QString("%1:%2%3%4")
      .arg(tenths / 600)
      .arg(tenths / 10 % 60, 2, 10, QChar('0'))
      .arg(QLocale().decimalPoint())
      .arg(tenths % 10);
}

QColor event_colour(Kind kind) {
  switch (kind) {
    case Kind::attempt_begins:
    case Kind::attempt_ends:
      return theme::text();
    case Kind::first_sight:
      return theme::within();
    case Kind::cords_passed:
      return QColor(0xCC, 0x79, 0xA7);
    case Kind::co2:
      return theme::target();
    case Kind::peak:
    case Kind::over_target:
      return theme::over();
    case Kind::oesophagus:
    case Kind::alarm:
      return theme::bad();
    case Kind::device_limit:
      return theme::device();
    case Kind::distraction:
      return QColor(196, 160, 250);
    case Kind::breath:
    case Kind::pause:
      return theme::faint();
  }
  return theme::text();
}

Timeline::Timeline(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setObjectName("timeline");
  setAccessibleName(tr("Time in the trial"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
}

void Timeline::show_trial(std::vector<ReplayEvent> events, double end_s) {
  events_ = std::move(events);
  notes_s_.clear();
  end_s_ = std::max(1e-3, end_s);
  ready_s_ = 0.0;
  marked_s_ = -1.0;
  const QSignalBlocker quiet(this);
  setRange(0, static_cast<int>(std::ceil(1e3 * end_s_)));
  setValue(0);
  update();
}

void Timeline::show_notes(std::vector<double> at_s) {
  notes_s_ = std::move(at_s);
  update();
}

void Timeline::set_ready(double until_s) {
  if (until_s == ready_s_) return;
  ready_s_ = until_s;
  update();
}

void Timeline::mark(double at_s) {
  marked_s_ = at_s;
  update();
}

void Timeline::show_time(double at_s) {
  const QSignalBlocker quiet(this);
  setValue(static_cast<int>(std::lround(1e3 * at_s)));
  setAccessibleDescription(tr("%1 of %2").arg(clock_text(at_s), clock_text(end_s_)));
}

double Timeline::x_of(double at_s) const {
  return kSide + (width() - 2.0 * kSide) * std::clamp(at_s / end_s_, 0.0, 1.0);
}

double Timeline::time_at(double x) const {
  return end_s_ * std::clamp((x - kSide) / std::max(1.0, width() - 2.0 * kSide), 0.0, 1.0);
}

const ReplayEvent* Timeline::event_near(double x) const {
  const ReplayEvent* nearest = nullptr;
  double best = kNear;
  for (const ReplayEvent& event : events_) {
    // A breath is one of many: anything else near it is meant.
    const double away = std::abs(x_of(event.at_s) - x) + (minor(event) ? 3.0 : 0.0);
    if (away >= best) continue;
    best = away;
    nearest = &event;
  }
  return nearest;
}

void Timeline::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF track(kSide, kTrackTop, width() - 2.0 * kSide, kTrackHeight);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::track());
  painter.drawRoundedRect(track, 3, 3);
  const auto span = [&](double from_s, double to_s, double top, double height, const QColor& colour) {
    painter.fillRect(QRectF(x_of(from_s), top, std::max(2.0, x_of(to_s) - x_of(from_s)), height), colour);
  };
  span(0.0, ready_s_, track.bottom() - 3.0, 3.0, theme::accent());
  for (const ReplayEvent& event : events_)
    if (event.kind == Kind::attempt_begins)
      span(event.at_s, event.to_s, track.top(), track.height() - 3.0, theme::faint());
  for (const ReplayEvent& event : events_) {
    if (!lasts(event.kind) || event.kind == Kind::attempt_begins) continue;
    const double top = event.kind == Kind::over_target ? track.top() : track.top() + 6.0;
    span(event.at_s, event.to_s, top, 6.0, event_colour(event.kind));
  }
  for (const ReplayEvent& event : events_) {
    const double x = x_of(event.at_s);
    painter.setPen(QPen(event_colour(event.kind), 2.0));
    painter.setBrush(event_colour(event.kind));
    if (minor(event)) {
      painter.setPen(QPen(event_colour(event.kind), 1.0));
      painter.drawLine(QPointF(x, track.bottom()), QPointF(x, track.bottom() + 4.0));
    } else if (event.kind == Kind::attempt_begins || event.kind == Kind::attempt_ends) {
      painter.drawLine(QPointF(x, 8.0), QPointF(x, track.bottom()));
      const double way = event.kind == Kind::attempt_begins ? 6.0 : -6.0;  // a flag into the attempt
      painter.drawPolygon(QPolygonF({QPointF(x, 6.0), QPointF(x + way, 10.0), QPointF(x, 14.0)}));
    } else if (event.kind == Kind::peak) {
      painter.setPen(Qt::NoPen);
      painter.drawPolygon(QPolygonF(
          {QPointF(x, track.top() - 1.0), QPointF(x - 5.0, track.top() - 10.0), QPointF(x + 5.0, track.top() - 10.0)}));
    } else if (!lasts(event.kind)) {
      painter.drawLine(QPointF(x, track.top() - 6.0), QPointF(x, track.bottom()));
      painter.setPen(Qt::NoPen);
      painter.drawEllipse(QPointF(x, track.top() - 8.0), 4.0, 4.0);
    }
  }
  painter.setPen(QPen(theme::faint(), 1.0));
  painter.setBrush(QColor(255, 250, 205));
  for (const double at_s : notes_s_)  // a slip of paper
    painter.drawRect(QRectF(x_of(at_s) - 3.0, track.bottom() + 1.0, 7.0, 7.0));
  if (marked_s_ >= 0.0) {
    painter.setPen(QPen(theme::target(), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(x_of(marked_s_) - 5.0, track.top() - 4.0, 10.0, track.height() + 8.0), 3, 3);
  }

  QFont font = painter.font();
  font.setPointSizeF(theme::points(8.0));
  painter.setFont(font);
  painter.setPen(theme::faint());
  const double step = label_step(end_s_, track.width());
  for (double at_s = 0.0; at_s <= end_s_ * 1.0001; at_s += step) {
    painter.drawLine(QPointF(x_of(at_s), track.bottom()), QPointF(x_of(at_s), track.bottom() + 3.0));
    painter.drawText(QRectF(x_of(at_s) - 40.0, track.bottom() + 8.0, 80.0, painter.fontMetrics().height()),
                     Qt::AlignHCenter | Qt::AlignTop, QString("%1 s").arg(at_s, 0, 'f', 0));
  }
  const double x = x_of(1e-3 * value());
  painter.setPen(QPen(theme::text(), 2.0));
  painter.drawLine(QPointF(x, 2.0), QPointF(x, track.bottom() + 6.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::text());
  painter.drawEllipse(QPointF(x, track.center().y()), 6.0, 6.0);
  if (hasFocus()) {
    painter.setPen(QPen(theme::accent(), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  }
}

QSize Timeline::sizeHint() const { return {600, 48 + static_cast<int>(theme::points(14.0))}; }

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  const ReplayEvent* near = event_near(event->pos().x());
  setSliderDown(true);
  emit wanted(near != nullptr ? near->at_s : time_at(event->pos().x()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) emit wanted(time_at(event->pos().x()));
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) setSliderDown(false);
}

void Timeline::wheelEvent(QWheelEvent* event) { event->ignore(); }

void Timeline::keyPressEvent(QKeyEvent* event) { event->ignore(); }  // the page has one meaning for each, everywhere

bool Timeline::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const ReplayEvent* near = event_near(help->pos().x());
    const double at_s = near != nullptr ? near->at_s : time_at(help->pos().x());
    QToolTip::showText(help->globalPos(),
                       clock_text(at_s) + (near != nullptr ? "  " + in_words(near->text) : QString()), this);
    return true;
  }
  return QSlider::event(event);
}

}  // namespace vallecula::gui
