// Force as bars, the display that trainees read best (CLINICAL.md): on the tongue and on the gum, apart, each with its
// training target; the device's own limit is marked as what it is.
#pragma once

#include <QWidget>

namespace vallecula::gui {

struct ForceMarks {
  double tongue_target_n = 0.0;  ///< training target
  double gum_target_n = 0.0;
  double device_limit_n = 0.0;  ///< what the device can give
};

class ForceBars : public QWidget {
  Q_OBJECT
 public:
  explicit ForceBars(QWidget* parent = nullptr);
  void set_marks(const ForceMarks& marks);
  /// Model forces (what the tissue does), N. Peaks are kept until clear().
  void show_forces(double tongue_n, double gum_n);
  void clear();
  double tongue_peak_n() const { return tongue_.peak; }
  double gum_peak_n() const { return gum_.peak; }
  QSize sizeHint() const override { return {420, 132}; }
  QSize minimumSizeHint() const override { return {280, 116}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Bar {
    double now = 0.0, peak = 0.0, target = 0.0;
  };
  void paint_bar(class QPainter& painter, const QRectF& place, const QString& name, const Bar& bar,
                 bool with_limit) const;
  Bar tongue_, gum_;
  double device_limit_ = 0.0, scale_ = 10.0;
};

}  // namespace vallecula::gui
