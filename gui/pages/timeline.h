// A replay's time as a slider, with what happened marked on it.
#pragma once

#include <QSlider>
#include <vector>

#include "gui/session/replay_events.h"

namespace vallecula::gui {

class Timeline : public QSlider {
  Q_OBJECT
 public:
  explicit Timeline(QWidget* parent = nullptr);
  void show_trial(std::vector<ReplayEvent> events, double end_s);
  /// Notes have marks of their own.
  void show_notes(std::vector<double> at_s);
  /// Until when pictures are ready.
  void set_ready(double until_s);
  /// A second somebody jumped to stays marked until the next.
  void mark(double at_s);
  double marked_s() const { return marked_s_; }
  /// The cursor, without a signal.
  void show_time(double at_s);

  double x_of(double at_s) const;  ///< pixels
  double time_at(double x) const;
  /// The event whose mark is nearest to a place, within a few pixels; null: none.
  const ReplayEvent* event_near(double x) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {300, 62}; }

 signals:
  void wanted(double at_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  std::vector<ReplayEvent> events_;
  std::vector<double> notes_s_;
  double end_s_ = 1.0, ready_s_ = 0.0, marked_s_ = -1.0;
};

/// "1:02.3"
QString clock_text(double at_s);

/// Colour of an event's mark; each kind has its own height or shape on the timeline as well.
QColor event_colour(ReplayEvent::Kind kind);

}  // namespace vallecula::gui
