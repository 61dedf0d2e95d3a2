// A trial's chart with the time cursor on it; a click is a jump. Where it is low its letters are smaller, so that all
// of it is seen; its corner asks for more room.
#pragma once

#include "gui/pages/chart_view.h"

class QToolButton;

namespace vallecula::gui {

class LinkedChart : public ChartView {
  Q_OBJECT
 public:
  /// As ChartView's; the page names it already, so that it has no title.
  LinkedChart(const QString& name, double least_em, QWidget* parent = nullptr);
  /// `last_s`: of the trial's last tick.
  void show_trial(Draw draw, double last_s);
  void show_time(double at_s);
  void mark(double at_s);
  double x_of(double at_s) const;  ///< pixels of the widget
  double time_at(double x) const;
  double em() const override;
  QSize minimumSizeHint() const override;
  /// Whether it has the room it was given by its corner.
  void show_large(bool large);

 signals:
  void wanted(double at_s);
  void room_wanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  double least_em_;
  QToolButton* corner_;
  double last_s_ = 0.0, now_s_ = 0.0, marked_s_ = -1.0;
};

}  // namespace vallecula::gui
