// A trial's chart with the time cursor on it; a click is a jump.
#pragma once

#include <QImage>
#include <QPointer>
#include <QThread>
#include <QTimer>
#include <QWidget>
#include <functional>

namespace vallecula::gui {

class LinkedChart : public QWidget {
  Q_OBJECT
 public:
  /// Draws a chart of a size in pixels; called on threads of its own.
  using Draw = std::function<QImage(int width, int height)>;

  explicit LinkedChart(const QString& name, QWidget* parent = nullptr);
  ~LinkedChart() override;
  /// `last_s`: of the trial's last tick.
  void show_chart(Draw draw, double last_s);
  void show_time(double at_s);
  void mark(double at_s);
  bool drawn() const { return !picture_.isNull(); }
  double x_of(double at_s) const;  ///< pixels of the widget
  double time_at(double x) const;
  QSize sizeHint() const override { return {700, 190}; }
  QSize minimumSizeHint() const override { return {300, 120}; }

 signals:
  void wanted(double at_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void draw_soon();
  void draw_now();
  Draw draw_;
  QImage picture_, shown_;  ///< as drawn for paper, and on the window's ground
  QString problem_;
  QTimer soon_;
  QPointer<QThread> drawing_;
  int asked_ = 0;  ///< a picture that was asked for earlier than the newest is not shown
  double last_s_ = 0.0, now_s_ = 0.0, marked_s_ = -1.0;
};

}  // namespace vallecula::gui
