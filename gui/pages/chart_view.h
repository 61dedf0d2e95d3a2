// A chart as large as it is seen, its letters as large as the window's, on the window's ground; drawn on a thread of
// its own. Words that were cut for want of room are said whole while the mouse is over them.
#pragma once

#include <QPointer>
#include <QThread>
#include <QTimer>
#include <QWidget>
#include <functional>

#include "gui/report/chart_panel.h"

namespace vallecula::gui {

class ChartView : public QWidget {
  Q_OBJECT
 public:
  /// Draws a chart of a form; called on threads of its own, where it may throw.
  using Draw = std::function<Chart(const ChartForm&)>;

  /// `least_em`: how high it is at least, in its letters' height; a page with less room scrolls.
  ChartView(const QString& name, double least_em, bool titled, QWidget* parent = nullptr);
  ~ChartView() override;
  /// `meanwhile`: a picture of the same, shown until the first is drawn.
  void show_chart(Draw draw, const QImage& meanwhile = {});
  /// Said in place of a chart.
  void show_problem(const QString& problem);
  bool drawn() const { return !chart_.picture.isNull(); }
  const std::vector<ChartLabel>& labels() const { return chart_.labels; }
  /// Of the widget as it is now.
  ChartForm form() const;
  virtual double em() const;  ///< height of its letters, px
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void draw_soon();
  void draw_now();
  Draw draw_;
  Chart chart_;       ///< as drawn for paper
  QImage shown_;      ///< the same on the window's ground, made when it is painted
  QImage meanwhile_;  ///< for paper
  QString problem_;
  QTimer soon_;
  QPointer<QThread> drawing_;
  double least_em_;
  bool titled_;
  int asked_ = 0;  ///< a picture that was asked for earlier than the newest is not shown
};

}  // namespace vallecula::gui
