// One slice of a scan, with what a person needs to judge and mend it: scroll, zoom, pan, window, ruler, angle, seeds,
// landmarks to drag. Drawn by QPainter from the voxels: exact, and quick without a graphics card.
#pragma once

#include <QPointF>
#include <QWidget>

#include "gui/views/slice_scene.h"

namespace vallecula::gui {

/// Mouse: left as the scene's tool says (on a landmark it drags that), right drag window and level, middle or
/// Shift-left drag pan, wheel slices, Ctrl-wheel zoom. Keys: arrows move the crosshair by a voxel, PgUp PgDn slices, +
/// - 0 zoom, Enter puts the tool's point at the crosshair, Escape puts the tool away, Delete takes the last
/// measure away, F (or a double click) shows this view alone.
class SliceView : public QWidget {
  Q_OBJECT
 public:
  SliceView(SliceScene& scene, SlicePlane plane, QWidget* parent = nullptr);

  SlicePlane plane() const { return plane_; }
  /// Where a point of the scan stands on the widget (the through axis is left out), and back, in the slice shown.
  QPointF pixel_of(const pipeline::Point& at) const;
  pipeline::Point point_at(const QPointF& pixel) const;
  double pixels_per_mm() const { return scale_; }
  /// The whole slice in the middle.
  void fit();
  QSize sizeHint() const override { return {420, 340}; }

 signals:
  /// A double click, or F: this view alone, or all of them again.
  void alone_wanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  class Names;
  enum class Drag { none, crosshair, window, pan, landmark, measure };
  void zoom(double factor, const QPointF& about);
  void scan_changed();
  std::string landmark_near(const QPointF& pixel) const;
  bool in_slice(const pipeline::Point& at) const;
  void draw_measures(QPainter& painter, Names& names) const;
  void draw_landmarks(QPainter& painter, Names& names) const;
  void draw_seeds(QPainter& painter, Names& names) const;
  void draw_crosshair(QPainter& painter) const;
  void draw_edges(QPainter& painter) const;

  SliceScene& scene_;
  SlicePlane plane_;
  SliceAxes axes_;
  const pipeline::Hounsfield* shown_ = nullptr;
  double scale_ = 1.0;        ///< pixels a mm
  QPointF middle_{0.0, 0.0};  ///< mm along across and down at the widget's middle
  bool fitted_ = true;        ///< until a person zooms or pans
  QImage picture_;
  int picture_index_ = -1, picture_version_ = -1;
  Drag drag_ = Drag::none;
  QPointF last_, pressed_;
  pipeline::Point grabbed_{};  ///< from the pointer to the dragged landmark, mm
  std::string dragged_;
};

}  // namespace vallecula::gui
