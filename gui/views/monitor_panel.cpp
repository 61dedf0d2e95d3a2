#include "gui/views/monitor_panel.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kShown = 60.0;      // s of trend
constexpr double kEvery = 0.25;      // s between its points
constexpr double kBeatShare = 0.30;  // of a beat in which the heart is drawn large

// As bedside monitors have them: heart green, saturation cyan; an alarm is told by words and a filled field as well.
const QColor kHeart(94, 214, 120), kOxygen(92, 206, 236), kQuiet(205, 212, 220), kAlarm(226, 74, 51);
const QColor kPurple(122, 72, 160), kYellow(243, 215, 65);

QPainterPath heart_shape(const QPointF& at, double size) {
  QPainterPath path;
  path.moveTo(at + QPointF(0.0, 0.9 * size));
  path.cubicTo(at + QPointF(-1.5 * size, -0.1 * size), at + QPointF(-0.7 * size, -1.2 * size),
               at + QPointF(0.0, -0.35 * size));
  path.cubicTo(at + QPointF(0.7 * size, -1.2 * size), at + QPointF(1.5 * size, -0.1 * size),
               at + QPointF(0.0, 0.9 * size));
  return path;
}

QFont sized(QPainter& painter, double pixels, bool bold) {
  QFont font = painter.font();
  font.setPixelSize(std::max(8, static_cast<int>(pixels)));
  font.setBold(bold);
  return font;
}

/// Bold, as large as that, or as the width allows.
QFont fitted(QPainter& painter, double pixels, const QString& text, double wide) {
  const double asked = QFontMetricsF(sized(painter, pixels, true)).horizontalAdvance(text);
  return sized(painter, asked > wide ? pixels * wide / asked : pixels, true);
}

}  // namespace

QStringList alarms_of(const engine::IntubationRecord& record) {
  QStringList alarms;
  if (record.heart_per_min < kCompressions)
    alarms << QCoreApplication::translate("MonitorPanel", "HEART RATE BELOW 60: COMPRESSIONS");
  else if (record.heart_per_min < kSlowHeart)
    alarms << QCoreApplication::translate("MonitorPanel", "HEART RATE BELOW 100: VENTILATE");
  if (record.spo2 < kLowSpo2) alarms << QCoreApplication::translate("MonitorPanel", "SpO2 BELOW 80 %");
  return alarms;
}

AlarmSound alarm_sound_of(const engine::IntubationRecord& record) {
  if (record.heart_per_min < kCompressions || record.spo2 < kLowSpo2) return AlarmSound::high;
  return record.heart_per_min < kSlowHeart ? AlarmSound::medium : AlarmSound::none;
}

MonitorPanel::MonitorPanel(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Monitor: saturation, heart rate, breaths, CO2"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void MonitorPanel::clear() {
  minute_.clear();
  now_s_ = seen_s_ = last_breath_s_ = beat_ = 0.0;
  breaths_ = 0;
  there_ = false;
  update();
}

void MonitorPanel::go_on_from(const MonitorPanel& other) {
  record_ = other.record_;
  minute_ = other.minute_;
  now_s_ = other.now_s_;
  last_breath_s_ = other.last_breath_s_;
  seen_s_ = other.seen_s_;
  breaths_ = other.breaths_;
  beat_ = other.beat_;
  there_ = other.there_;
  update();
}

void MonitorPanel::show_snapshot(const engine::Snapshot& snapshot) {
  if (!snapshot.has_intubation || snapshot.step < 0) return;
  if (there_ && snapshot.time_s < seen_s_) clear();
  // The infant's time stands in a pause, the servo's goes on.
  const bool paused = (snapshot.faults & engine::kFaultDeviceInvalid) != 0 ||
                      (snapshot.intubation.faults & engine::kIntubationFaultHand) != 0;
  const double passed = there_ && !paused ? snapshot.time_s - seen_s_ : 0.0;
  record_ = snapshot.intubation;
  now_s_ = there_ ? now_s_ + passed : snapshot.time_s;
  seen_s_ = snapshot.time_s;
  if (record_.breaths_given != breaths_) last_breath_s_ = now_s_;
  breaths_ = record_.breaths_given;
  beat_ = std::fmod(beat_ + passed * record_.heart_per_min / 60.0, 1.0);
  if (minute_.empty() || now_s_ - minute_.back().time_s >= kEvery)
    minute_.push_back({now_s_, record_.spo2, record_.heart_per_min});
  while (minute_.front().time_s < now_s_ - kShown) minute_.pop_front();
  there_ = true;
  setAccessibleDescription(tr("saturation %1 %, heart rate %2 a minute, %3 s since the last breath%4")
                               .arg(100.0 * record_.spo2, 0, 'f', 0)
                               .arg(record_.heart_per_min, 0, 'f', 0)
                               .arg(since_breath_s(), 0, 'f', 0)
                               .arg(alarms_of(record_).isEmpty() ? "" : "; " + alarms_of(record_).join("; ")));
  update();
}

void MonitorPanel::paint_numeric(QPainter& painter, const QRectF& place, const QString& name, const QString& value,
                                 const QString& unit, const QColor& colour, bool alarm) const {
  const double tall = place.height();
  if (alarm) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(kAlarm);
    painter.drawRoundedRect(place, 4, 4);
  }
  const QRectF inside = place.adjusted(7, 2, -5, -2);
  painter.setPen(alarm ? QColor(Qt::white) : colour);
  painter.setFont(sized(painter, 0.17 * tall, true));
  painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, name);
  painter.drawText(inside, Qt::AlignTop | Qt::AlignRight, unit);
  painter.setFont(sized(painter, std::min(0.64 * tall, 0.44 * inside.width()), true));  // three digits have room
  painter.drawText(inside.adjusted(0, 0.12 * tall, 0, 0), Qt::AlignVCenter | Qt::AlignRight, value);
}

void MonitorPanel::paint_trend(QPainter& painter, const QRectF& place, double Moment::*of, double low, double high,
                               double limit, const QColor& colour) const {
  const auto at = [&](double time_s, double value) {
    return QPointF(place.right() - (now_s_ - time_s) / kShown * place.width(),
                   place.bottom() - std::clamp((value - low) / (high - low), 0.0, 1.0) * place.height());
  };
  painter.setPen(QPen(QColor(70, 78, 88), 1.0, Qt::DotLine));
  painter.drawLine(at(now_s_ - kShown, limit), at(now_s_, limit));
  QPolygonF line;
  for (const Moment& m : minute_) line << at(m.time_s, m.*of);
  painter.setPen(QPen(colour, 2.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(line);
}

void MonitorPanel::paint_breaths(QPainter& painter, const QRectF& place) const {
  const double tall = place.height(), small = std::min(0.17 * tall, 0.135 * place.width());
  painter.setPen(kQuiet);
  painter.setFont(fitted(painter, small, tr("Since breath"), place.width()));
  painter.drawText(place, Qt::AlignTop | Qt::AlignLeft, tr("Since breath"));
  const bool long_ago = there_ && since_breath_s() > 30.0;  // an attempt's ceiling
  painter.setPen(long_ago ? theme::over() : kQuiet);
  painter.setFont(sized(painter, 0.42 * tall, true));
  painter.drawText(place.adjusted(0, 0.17 * tall, 0, -0.20 * tall), Qt::AlignVCenter | Qt::AlignLeft,
                   there_ ? QString("%1 s").arg(since_breath_s(), 0, 'f', 0) : QString("-"));
  painter.setPen(kQuiet);
  painter.setFont(sized(painter, small, true));
  painter.drawText(place, Qt::AlignBottom | Qt::AlignLeft,
                   !there_                       ? QString()
                   : record_.given_per_min > 0.0 ? tr("Given %1/min").arg(record_.given_per_min, 0, 'f', 0)
                   : record_.breaths_given > 0   ? tr("%1 given").arg(record_.breaths_given)
                                                 : tr("None given"));
}

void MonitorPanel::paint_detector(QPainter& painter, const QRectF& place) const {
  const double tall = place.height();
  painter.setPen(kQuiet);
  painter.setFont(fitted(painter, std::min(0.17 * tall, 0.135 * place.width()), tr("CO2 detector"), place.width()));
  painter.drawText(place, Qt::AlignTop | Qt::AlignLeft, tr("CO2 detector"));
  const bool yellow = there_ && record_.detector_yellow;
  const QRectF patch(place.left(), place.top() + 0.27 * tall, place.width(), 0.71 * tall);
  painter.setPen(QPen(QColor(230, 234, 238), 1.5));
  painter.setBrush(yellow ? kYellow : kPurple);
  painter.drawRoundedRect(patch, 6, 6);
  painter.setPen(yellow ? QColor(50, 40, 0) : QColor(Qt::white));
  painter.setFont(sized(painter, std::min(0.24 * tall, 0.20 * patch.width()), true));
  painter.drawText(patch.adjusted(0, 0.04 * tall, 0, -0.30 * tall), Qt::AlignCenter,
                   yellow ? tr("YELLOW") : tr("PURPLE"));
  painter.setFont(sized(painter, 0.15 * tall, false));
  painter.drawText(patch.adjusted(0, 0.34 * tall, 0, 0), Qt::AlignCenter, yellow ? tr("CO2") : tr("no CO2"));
}

void MonitorPanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(6, 9, 12));
  painter.drawRoundedRect(rect(), 7, 7);
  const QStringList alarms = there_ ? alarms_of(record_) : QStringList();
  const double alarm_line = 23.0, gap = 10.0, numeric = std::min(0.17 * width(), 1.55 * (height() - alarm_line));
  const QRectF all(10.0, 5.0, width() - 20.0, height() - 8.0 - alarm_line);
  const double breaths = 0.145 * all.width(), detector = 0.135 * all.width();
  const double trend = 0.5 * (all.width() - 2.0 * numeric - breaths - detector - 5.0 * gap);
  double x = all.left();
  const auto next = [&](double wide) {
    const QRectF place(x, all.top(), wide, all.height());
    x += wide + gap;
    return place;
  };
  const QString none("- -");
  const bool low = there_ && record_.spo2 < kLowSpo2, slow = there_ && record_.heart_per_min < kSlowHeart;
  paint_numeric(painter, next(numeric), "SpO2", there_ ? QString::number(100.0 * record_.spo2, 'f', 0) : none, "%",
                kOxygen, low);
  paint_trend(painter, next(trend).adjusted(0, 4, 0, -4), &Moment::spo2, 0.4, 1.0, kLowSpo2, kOxygen);
  const QRectF heart = next(numeric);
  paint_numeric(painter, heart, tr("HR"), there_ ? QString::number(record_.heart_per_min, 'f', 0) : none, "/min",
                kHeart, slow);
  if (there_ && record_.heart_per_min > 0.0) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(slow ? QColor(Qt::white) : kHeart);
    painter.drawPath(
        heart_shape(heart.topLeft() + QPointF(std::max(0.30 * heart.width(), 40.0), 0.12 * heart.height() + 1.0),
                    (beat_ < kBeatShare ? 0.095 : 0.06) * heart.height()));
  }
  paint_trend(painter, next(trend).adjusted(0, 4, 0, -4), &Moment::heart, 40.0, 200.0, kSlowHeart, kHeart);
  paint_breaths(painter, next(breaths));
  paint_detector(painter, next(detector));
  painter.setFont(sized(painter, 17, true));
  const QRectF words(10.0, height() - alarm_line - 2.0, width() - 20.0, alarm_line);
  if (!alarms.isEmpty()) {
    painter.setPen(QColor(255, 176, 150));
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, alarms.join("     "));
  }
}

}  // namespace vallecula::gui
