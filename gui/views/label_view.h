// The labels of a scan in three dimensions, with its landmarks: to be turned about and looked at.
#pragma once

#include <vtkActor.h>

#include <QPointer>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <map>
#include <memory>

#include "gui/views/gl_view.h"
#include "gui/views/slice_scene.h"

namespace vallecula::gui {

/// Left drag turns (on a landmark it drags that, in the plane of the screen), right or Shift drag pans, wheel zooms;
/// keys: arrows turn, + - zoom, 0 looks from the front again, F (or a double click) shows this view alone. Landmarks
/// are drawn over what hides them. Surfaces are made on a thread of their own.
class LabelView : public GlView {
  Q_OBJECT
 public:
  explicit LabelView(SliceScene& scene, QWidget* parent = nullptr);
  ~LabelView() override;
  /// Are the surfaces of the labels as they are now on the view?
  bool up_to_date() const { return !worker_ && !stale_; }
  /// Where a point of the scan stands on the widget.
  QPointF pixel_of(const pipeline::Point& at) const;

 signals:
  void focus_changed(bool has);
  void alone_wanted();

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void labels_changed();
  void make_surfaces();
  void show_visible();
  void show_landmarks();
  void size_marks();
  void look_from_front();
  void turn(double right_deg, double up_deg);
  void zoom(double factor);
  pipeline::Point moved_in_screen(const pipeline::Point& from, const QPointF& pixels) const;
  void draw_soon();
  std::string landmark_near(const QPointF& pixel) const;

  SliceScene& scene_;
  const pipeline::Labels* shown_ = nullptr;
  std::map<std::uint8_t, vtkSmartPointer<vtkActor>> actors_;
  std::map<std::string, vtkSmartPointer<vtkActor>> marks_;
  vtkSmartPointer<vtkRenderer> over_;  ///< the landmarks', over the structures'
  std::shared_ptr<std::atomic<bool>> go_on_;
  QPointer<QThread> worker_;
  QTimer redraw_;
  bool stale_ = false, framed_ = false;
  QPointF last_, pressed_;
  std::string dragged_;
};

}  // namespace vallecula::gui
