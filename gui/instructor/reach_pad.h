// Where the tip of the tool is in the reach that a laryngoscopy needs: seen as the operator sees it, depth beside it.
#pragma once

#include <QWidget>
#include <array>

#include "gui/instructor/check_run.h"

namespace vallecula::gui {

class ReachPad : public QWidget {
  Q_OBJECT
 public:
  explicit ReachPad(QWidget* parent = nullptr);
  /// m, right, up and towards the person.
  void show_tip(const std::array<double, 3>& tip_m, const std::array<bool, kReachMarks>& reached, bool asked_for);
  QSize sizeHint() const override { return {340, 300}; }
  QSize minimumSizeHint() const override { return {240, 200}; }

 signals:
  /// The mouse was dragged on it, or its wheel turned: m.
  void dragged(double right_m, double up_m);
  void wheeled(double away_m);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  QRectF plane() const;  ///< the square that stands for kShownM
  double pixels_per_m() const { return plane().width() / kShownM; }
  static constexpr double kShownM = 0.12;  ///< across the square
  std::array<double, 3> tip_m_{0, 0, 0};
  std::array<bool, kReachMarks> reached_{};
  bool asked_for_ = false;
  QPoint last_;
};

}  // namespace vallecula::gui
