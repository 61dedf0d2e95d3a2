// The monitor at the bedside: saturation as it is displayed, heart rate, breaths and the CO2 detector, with the last
// minute's course and the alarms in words. Read from two metres.
#pragma once

#include <QWidget>
#include <algorithm>
#include <deque>

#include "engine/snapshot.h"
#include "gui/session/monitor_sound.h"

namespace vallecula::gui {

/// What the alarms begin at (CLINICAL: below 100 ventilate, below 60 compressions; SpO2 below 80 % is severe).
constexpr double kLowSpo2 = 0.80, kSlowHeart = 100.0, kCompressions = 60.0;

/// The saturation's digits: "87"; "< 30" of what no figure is to be believed of (curricula::kLeastToldSpo2).
QString spo2_digits(double spo2);

/// Alarms of a moment, the gravest first, in words; empty: none.
QStringList alarms_of(const engine::IntubationRecord& record);
/// How the gravest of them sounds: high where compressions are due or the saturation is severe, else medium.
AlarmSound alarm_sound_of(const engine::IntubationRecord& record);

class MonitorPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MonitorPanel(QWidget* parent = nullptr);
  /// To be called for every frame.
  void show_snapshot(const engine::Snapshot& snapshot);
  void clear();
  /// The infant breathes by itself for as long as its cords let it (the scenario's word): then there is no time without
  /// a breath to be counted.
  void set_breathes(bool by_itself) { breathes_ = by_itself; }
  /// Greyed out with a word why: what else is shown is another's, and this infant's time stands.
  void set_waiting(bool waiting);
  /// The same attempt's minute and last breath, which the other has shown from its beginning.
  void go_on_from(const MonitorPanel& other);
  /// Since the last breath given or its own, or since the beginning; s.
  double since_breath_s() const { return now_s_ - std::max(last_breath_s_, own_breath_s_); }
  bool breathes_now() const { return breathes_ && now_s_ - own_breath_s_ <= kOwnPauseS; }
  /// Of the last breaths given, per minute; 0: too few or too long ago to tell one.
  double given_per_min() const;
  /// Its words follow the text's size; its figures, large as they are, do not.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// Longer than from breath to breath, so that only cords that stay shut are told as a pause.
  static constexpr double kOwnPauseS = 3.0, kNever = 1e9;
  struct Moment {
    double time_s, spo2, heart;
  };
  void count_breaths();
  void describe();
  void paint_numeric(class QPainter& painter, const QRectF& place, const QString& name, const QString& value,
                     const QString& unit, const QColor& colour, bool alarm) const;
  void paint_trend(QPainter& painter, const QRectF& place, double Moment::*of, double low, double high, double limit,
                   const QString& limit_word, const QColor& colour) const;
  void paint_breaths(QPainter& painter, const QRectF& place) const;
  void paint_detector(QPainter& painter, const QRectF& place) const;

  engine::IntubationRecord record_;
  std::deque<Moment> minute_;
  std::deque<double> given_s_;                ///< the last breaths given of one series, without pauses
  double now_s_ = 0.0, last_breath_s_ = 0.0;  ///< without pauses
  double own_breath_s_ = -kNever;             ///< when air last came through its cords by itself
  double seen_s_ = 0.0;                       ///< the newest snapshot's own time
  std::int32_t breaths_ = 0;
  bool breathes_ = false, waiting_ = false;
  double beat_ = 0.0;  ///< of the present beat, 0..1
  bool there_ = false;
};

}  // namespace vallecula::gui
