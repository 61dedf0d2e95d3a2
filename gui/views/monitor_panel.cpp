#include "gui/views/monitor_panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "curricula/score/intubation_score.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kShown = 60.0;      // s of trend
constexpr double kEvery = 0.25;      // s between its points
constexpr double kBeatShare = 0.30;  // of a beat in which the heart is drawn large
constexpr int kLeastType = 8;        // px
constexpr double kLongAgoS = 30.0;   // without a breath: an attempt's ceiling
// A rate is told from five breaths on, as the mean of up to the last six; a series ends with ten seconds without one,
// as the engine's does (assumed: a monitor's rate is a mean of several breaths, and two make none).
constexpr std::size_t kRateFrom = 5, kRateOf = 6;
constexpr double kSeriesEndsS = 10.0;
constexpr double kShutCords = 0.05;  // of their opening: no air comes through (engine/physiology)
// px at a text scale of one: the height and what grows of it with the text, a word's type, the line of alarms.
constexpr double kHigh = 118.0, kLeastHigh = 104.0, kGrows = 60.0, kWord = 14.8, kAlarmLine = 23.0, kAround = 8.0;

// Of a figure's place: px about its words, and what of the width they may have.
constexpr double kBefore = 7.0, kBehind = 5.0, kNameShare = 0.5, kUnitShare = 0.36;

double text_scale() { return theme::look().text_scale; }
double alarm_line() { return kAlarmLine * text_scale(); }
int high(double at_scale_one) { return static_cast<int>(std::lround(at_scale_one + kGrows * (text_scale() - 1.0))); }
/// px of a word's type in a place so tall: larger with the text, and with a panel that was made larger.
double word_of(double tall) { return kWord * text_scale() * tall / (high(kHigh) - alarm_line() - kAround); }

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
  font.setPixelSize(std::max(kLeastType, static_cast<int>(pixels)));
  font.setBold(bold);
  return font;
}

/// As large as that, or as the width allows.
QFont fitted(QPainter& painter, double pixels, const QString& text, double wide, bool bold = true) {
  const auto asked = [&] { return QFontMetricsF(sized(painter, pixels, bold)).horizontalAdvance(text); };
  if (asked() > wide) pixels *= wide / asked();
  while (pixels > kLeastType && asked() > wide) pixels -= 1.0;  // letters do not grow evenly with their type
  return sized(painter, pixels, bold);
}

}  // namespace

QString spo2_digits(double spo2) {
  const double percent = 100.0 * spo2;
  return std::round(percent) < curricula::kLeastToldSpo2 ? QString("< %1").arg(curricula::kLeastToldSpo2, 0, 'f', 0)
                                                         : QString::number(percent, 'f', 0);
}

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
  setToolTip(
      tr("Lines: the last minute; dotted: where the alarm begins. Breaths given are counted wherever they went; their "
         "rate is the mean of the last %1.")
          .arg(kRateOf) +
      '\n' +
      tr("SpO2: real oximeters state their accuracy from 70 to 100 %; below 70 % digits are a trend. Below %1 % none "
         "are "
         "shown: no newborn's curve was published so low.")
          .arg(curricula::kLeastToldSpo2, 0, 'f', 0));
}

QSize MonitorPanel::sizeHint() const { return {780, high(kHigh)}; }
QSize MonitorPanel::minimumSizeHint() const { return {480, high(kLeastHigh)}; }

void MonitorPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateGeometry();
}

void MonitorPanel::set_waiting(bool waiting) {
  if (waiting == waiting_) return;
  waiting_ = waiting;
  describe();
  update();
}

void MonitorPanel::clear() {
  minute_.clear();
  given_s_.clear();
  now_s_ = seen_s_ = last_breath_s_ = beat_ = 0.0;
  own_breath_s_ = -kNever;
  breaths_ = 0;
  there_ = waiting_ = false;
  update();
}

void MonitorPanel::go_on_from(const MonitorPanel& other) {
  record_ = other.record_;
  minute_ = other.minute_;
  given_s_ = other.given_s_;
  own_breath_s_ = other.own_breath_s_;
  breathes_ = other.breathes_;
  now_s_ = other.now_s_;
  last_breath_s_ = other.last_breath_s_;
  seen_s_ = other.seen_s_;
  breaths_ = other.breaths_;
  beat_ = other.beat_;
  there_ = other.there_;
  update();
}

void MonitorPanel::show_snapshot(const engine::Snapshot& snapshot) {
  set_waiting(false);
  if (!snapshot.has_intubation || snapshot.step < 0) return;
  if (there_ && snapshot.time_s < seen_s_) clear();
  // The infant's time stands in a pause, the servo's goes on.
  const bool paused = (snapshot.faults & engine::kFaultDeviceInvalid) != 0 ||
                      (snapshot.intubation.faults & engine::kIntubationFaultHand) != 0;
  const double passed = there_ && !paused ? snapshot.time_s - seen_s_ : 0.0;
  record_ = snapshot.intubation;
  now_s_ = there_ ? now_s_ + passed : snapshot.time_s;
  seen_s_ = snapshot.time_s;
  count_breaths();
  beat_ = std::fmod(beat_ + passed * record_.heart_per_min / 60.0, 1.0);
  if (minute_.empty() || now_s_ - minute_.back().time_s >= kEvery)
    minute_.push_back({now_s_, record_.spo2, record_.heart_per_min});
  while (minute_.front().time_s < now_s_ - kShown) minute_.pop_front();
  there_ = true;
  describe();
  update();
}

void MonitorPanel::count_breaths() {
  const std::int32_t more = record_.breaths_given - breaths_;
  breaths_ = record_.breaths_given;
  // A closed cord or a tube elsewhere is what holds it off; through a tube in the airway it breathes as without.
  const bool tube_in = record_.place == engine::TipPlace::trachea || record_.place == engine::TipPlace::main_bronchus;
  if (breathes_ && (!there_ || tube_in || record_.glottis_opening > kShutCords)) own_breath_s_ = now_s_;
  if (more == 0) return;
  last_breath_s_ = now_s_;
  // Of several at once nobody knows when they were: what was shown before was another moment.
  if (more != 1 || (!given_s_.empty() && now_s_ - given_s_.back() > kSeriesEndsS)) given_s_.clear();
  given_s_.push_back(now_s_);
  if (given_s_.size() > kRateOf) given_s_.pop_front();
}

double MonitorPanel::given_per_min() const {
  if (given_s_.size() < kRateFrom || now_s_ - given_s_.back() > kSeriesEndsS) return 0.0;
  const double mean_s = (given_s_.back() - given_s_.front()) / static_cast<double>(given_s_.size() - 1);
  return 60.0 / std::max({mean_s, now_s_ - given_s_.back(), 1e-3});
}

void MonitorPanel::describe() {
  if (!there_) return setAccessibleDescription(QString());
  const QString breath =
      breathes_now() ? tr("it breathes by itself") : tr("%1 s since the last breath").arg(since_breath_s(), 0, 'f', 0);
  QStringList parts{tr("saturation %1 %").arg(spo2_digits(record_.spo2)),
                    tr("heart rate %1 a minute").arg(record_.heart_per_min, 0, 'f', 0), breath};
  if (waiting_) parts.prepend(tr("Your own infant waits"));
  setAccessibleDescription((QStringList(parts.join(", ")) + alarms_of(record_)).join("; "));
}

void MonitorPanel::paint_numeric(QPainter& painter, const QRectF& place, const QString& name, const QString& value,
                                 const QString& unit, const QColor& colour, bool alarm) const {
  const double tall = place.height(), word = word_of(tall);
  if (alarm) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(kAlarm);
    painter.drawRoundedRect(place, 4, 4);
  }
  const QRectF inside = place.adjusted(kBefore, 2, -kBehind, -2);
  painter.setPen(alarm ? QColor(Qt::white) : colour);
  painter.setFont(fitted(painter, word, name, kNameShare * inside.width()));
  painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, name);
  painter.setFont(fitted(painter, word, unit, kUnitShare * inside.width()));
  painter.drawText(inside, Qt::AlignTop | Qt::AlignRight, unit);
  // Three digits have room, and so has a sign before two.
  painter.setFont(fitted(painter, std::min(0.64 * tall, 0.44 * inside.width()), value, inside.width()));
  painter.drawText(inside.adjusted(0, 0.7 * word, 0, 0), Qt::AlignVCenter | Qt::AlignRight, value);
}

void MonitorPanel::paint_trend(QPainter& painter, const QRectF& place, double Moment::*of, double low, double high,
                               double limit, const QString& limit_word, const QColor& colour) const {
  const auto at = [&](double time_s, double value) {
    return QPointF(place.right() - (now_s_ - time_s) / kShown * place.width(),
                   place.bottom() - std::clamp((value - low) / (high - low), 0.0, 1.0) * place.height());
  };
  painter.setPen(QPen(QColor(70, 78, 88), 1.0, Qt::DotLine));
  painter.drawLine(at(now_s_ - kShown, limit), at(now_s_, limit));
  painter.setFont(sized(painter, 0.75 * word_of(place.height() + 8.0), false));
  const QFontMetricsF type(painter.font());
  if (type.horizontalAdvance(limit_word) < place.width()) {
    painter.setPen(QColor(150, 158, 168));
    painter.drawText(at(now_s_ - kShown, limit) + QPointF(0.0, type.ascent()), limit_word);
  }
  QPolygonF line;
  for (const Moment& m : minute_) line << at(m.time_s, m.*of);
  painter.setPen(QPen(colour, 2.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(line);
}

void MonitorPanel::paint_breaths(QPainter& painter, const QRectF& place) const {
  const double tall = place.height(), word = word_of(tall), large = 0.42 * tall;
  const bool by_itself = there_ && breathes_now();
  const auto line = [&](const QRectF& where, Qt::Alignment at, double pixels, const QString& text) {
    painter.setFont(fitted(painter, pixels, text, place.width()));
    painter.drawText(where, at | Qt::AlignLeft, text);
  };
  painter.setPen(kQuiet);
  line(place, Qt::AlignTop, word, by_itself ? tr("Breathing") : tr("Since breath"));
  const bool long_ago = there_ && !by_itself && since_breath_s() > kLongAgoS;
  painter.setPen(long_ago ? theme::over() : kQuiet);
  line(place.adjusted(0, word, 0, -1.18 * word), Qt::AlignVCenter, large,
       by_itself ? tr("by itself")
       : there_  ? QString("%1 s").arg(since_breath_s(), 0, 'f', 0)
                 : QString("-"));
  painter.setPen(kQuiet);
  const double rate = given_per_min();
  line(place, Qt::AlignBottom, word,
       !there_                     ? QString()
       : rate > 0.0                ? tr("Given %1/min").arg(rate, 0, 'f', 0)
       : record_.breaths_given > 0 ? tr("%1 given").arg(record_.breaths_given)
                                   : tr("None given"));
}

void MonitorPanel::paint_detector(QPainter& painter, const QRectF& place) const {
  const double tall = place.height(), word = word_of(tall);
  painter.setPen(kQuiet);
  painter.setFont(fitted(painter, word, tr("CO2 detector"), place.width()));
  painter.drawText(place, Qt::AlignTop | Qt::AlignLeft, tr("CO2 detector"));
  const bool yellow = there_ && record_.detector_yellow;
  const QRectF patch = place.adjusted(0, 1.6 * word, 0, -0.02 * tall);
  painter.setPen(QPen(QColor(230, 234, 238), 1.5));
  painter.setBrush(yellow ? kYellow : kPurple);
  painter.drawRoundedRect(patch, 6, 6);
  painter.setPen(yellow ? QColor(50, 40, 0) : QColor(Qt::white));
  const QString colour = yellow ? tr("YELLOW") : tr("PURPLE"), gas = yellow ? tr("CO2") : tr("no CO2");
  painter.setFont(fitted(painter, std::min(1.4 * word, 0.4 * patch.height()), colour, 0.92 * patch.width()));
  painter.drawText(patch.adjusted(0, 0.04 * tall, 0, -0.30 * tall), Qt::AlignCenter, colour);
  painter.setFont(fitted(painter, std::min(0.87 * word, 0.3 * patch.height()), gas, 0.92 * patch.width(), false));
  painter.drawText(patch.adjusted(0, 0.34 * tall, 0, 0), Qt::AlignCenter, gas);
}

void MonitorPanel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(6, 9, 12));
  painter.drawRoundedRect(rect(), 7, 7);
  const QStringList alarms = there_ ? alarms_of(record_) : QStringList();
  const double below = alarm_line(), gap = 10.0, numeric = std::min(0.17 * width(), 1.55 * (height() - below));
  const QRectF all(10.0, 5.0, width() - 20.0, height() - kAround - below);
  const double breaths = 0.145 * text_scale() * all.width(), detector = 0.135 * text_scale() * all.width();
  const double trend = 0.5 * (all.width() - 2.0 * numeric - breaths - detector - 5.0 * gap);
  double x = all.left();
  const auto next = [&](double wide) {
    const QRectF place(x, all.top(), wide, all.height());
    x += wide + gap;
    return place;
  };
  const QString none("- -");
  if (waiting_) painter.setOpacity(0.35);
  const bool low = there_ && record_.spo2 < kLowSpo2, slow = there_ && record_.heart_per_min < kSlowHeart;
  paint_numeric(painter, next(numeric), "SpO2", there_ ? spo2_digits(record_.spo2) : none, "%", kOxygen, low);
  paint_trend(painter, next(trend).adjusted(0, 4, 0, -4), &Moment::spo2, 0.4, 1.0, kLowSpo2, "80", kOxygen);
  const QRectF heart = next(numeric);
  paint_numeric(painter, heart, tr("HR"), there_ ? QString::number(record_.heart_per_min, 'f', 0) : none, "/min",
                kHeart, slow);
  if (there_ && record_.heart_per_min > 0.0) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(slow ? QColor(Qt::white) : kHeart);
    // Between name and unit, no larger than is free there.
    const double word = word_of(heart.height()), inside = heart.width() - kBefore - kBehind;
    const auto wide = [&](const QString& text, double share) {
      return QFontMetricsF(fitted(painter, word, text, share * inside)).horizontalAdvance(text);
    };
    const double name = wide(tr("HR"), kNameShare), free = inside - name - wide("/min", kUnitShare);
    const double size = std::min((beat_ < kBeatShare ? 0.56 : 0.35) * word, 0.42 * free);
    painter.drawPath(heart_shape(
        heart.topLeft() + QPointF(kBefore + name + std::min(0.9 * word, 0.5 * free), 0.7 * word + 1.0), size));
  }
  paint_trend(painter, next(trend).adjusted(0, 4, 0, -4), &Moment::heart, 40.0, 200.0, kSlowHeart, "100", kHeart);
  paint_breaths(painter, next(breaths));
  paint_detector(painter, next(detector));
  painter.setOpacity(1.0);
  const QRectF words(10.0, height() - below - 2.0, width() - 20.0, below);
  const QString line = waiting_ ? tr("Your own infant: its time stands meanwhile") : alarms.join("     ");
  painter.setFont(fitted(painter, 17.0 * text_scale(), line, words.width()));
  painter.setPen(waiting_ ? theme::device() : QColor(255, 176, 150));
  painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft, line);
}

}  // namespace vallecula::gui
