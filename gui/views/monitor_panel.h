// The monitor at the bedside: saturation as it is displayed, heart rate, breaths and the CO2 detector, with the last
// minute's course and the alarms in words. Read from two metres.
#pragma once

#include <QWidget>
#include <deque>

#include "engine/snapshot.h"
#include "gui/session/monitor_sound.h"

namespace vallecula::gui {

/// What the alarms begin at (CLINICAL: below 100 ventilate, below 60 compressions; SpO2 below 80 % is severe).
constexpr double kLowSpo2 = 0.80, kSlowHeart = 100.0, kCompressions = 60.0;

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
  /// The same attempt's minute and last breath, which the other has shown from its beginning.
  void go_on_from(const MonitorPanel& other);
  /// Since the last breath given, or since the beginning; s.
  double since_breath_s() const { return now_s_ - last_breath_s_; }
  QSize sizeHint() const override { return {780, 118}; }
  QSize minimumSizeHint() const override { return {480, 104}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Moment {
    double time_s, spo2, heart;
  };
  void paint_numeric(class QPainter& painter, const QRectF& place, const QString& name, const QString& value,
                     const QString& unit, const QColor& colour, bool alarm) const;
  void paint_trend(QPainter& painter, const QRectF& place, double Moment::*of, double low, double high, double limit,
                   const QColor& colour) const;
  void paint_breaths(QPainter& painter, const QRectF& place) const;
  void paint_detector(QPainter& painter, const QRectF& place) const;

  engine::IntubationRecord record_;
  std::deque<Moment> minute_;
  double now_s_ = 0.0, last_breath_s_ = 0.0;  ///< without pauses
  double seen_s_ = 0.0;                       ///< the newest snapshot's own time
  std::int32_t breaths_ = 0;
  double beat_ = 0.0;  ///< of the present beat, 0..1
  bool there_ = false;
};

}  // namespace vallecula::gui
