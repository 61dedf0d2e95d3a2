// A value for each trial in order, with the lines it is held against.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "gui/report/chart_labels.h"

namespace vallecula::gui {

class TrialChart : public QWidget {
  Q_OBJECT
 public:
  /// Told apart by shape as well as by colour.
  enum class Mark { good, bad, neutral, interrupted };
  struct Point {
    std::optional<double> value;  ///< nothing: the trial has none; its mark stands on the axis
    Mark mark = Mark::neutral;
    bool begins = false;  ///< no line leads here from the point before
    bool apart = false;   ///< its mark stands at its value, but the line passes it by
    QString tip;          ///< said while the mouse is over it
  };
  struct Level {
    double value = 0.0;
    QColor colour;
    QString text;
    bool text_below = false;
  };
  struct Content {
    QString title;
    std::vector<Point> points;
    std::vector<Level> levels;
    QString empty;  ///< said in place of points where there are none
  };

  explicit TrialChart(QWidget* parent);
  void show_content(Content content);
  void set_current(int index);  ///< the point that is ringed; -1: none
  /// Where a point is drawn, in the widget's pixels.
  QPointF position(int index) const;
  /// The words on it as they were drawn last.
  const std::vector<ChartLabel>& labels() const { return labels_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void pointed_at(int index);  ///< clicked
  void wanted(int index);      ///< double-clicked

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF frame() const;
  double title_high() const;             ///< px: in two lines where one is too short
  double left_wide() const;              ///< px: of the scale's figures
  int nearest(const QPointF& at) const;  ///< -1: none there
  double y(double value) const;
  void draw_scales(QPainter& painter, ChartLabels& labels) const;
  void draw_points(QPainter& painter) const;

  Content content_;
  double low_ = 0.0, high_ = 1.0;
  int current_ = -1;
  std::vector<ChartLabel> labels_;
};

}  // namespace vallecula::gui
