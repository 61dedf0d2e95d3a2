// What mouse and keyboard do in a slice.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "gui/views/slice_view.h"

namespace vallecula::gui {
namespace {

constexpr double kHuAPixel = 2.0;  // window and level
constexpr double kZoomANotch = 1.2;
constexpr double kDragBegins = 4.0;  // pixels: below it a ruler's press and release are two clicks

}  // namespace

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (shown_ == nullptr) return;
  const QPointF at = event->localPos();
  last_ = pressed_ = at;
  drag_ = Drag::none;
  if (event->button() == Qt::RightButton) {
    drag_ = Drag::window;
  } else if (event->button() == Qt::MiddleButton || (event->modifiers() & Qt::ShiftModifier) != 0) {
    drag_ = Drag::pan;
  } else if (event->button() == Qt::LeftButton) {
    const SliceTool tool = scene_.tool();
    dragged_ = tool == SliceTool::crosshair ? landmark_near(at) : std::string();
    if (!dragged_.empty()) {
      drag_ = Drag::landmark;
      const auto mark = scene_.landmarks().at(dragged_).at, here = point_at(at);
      for (int a = 0; a < 3; ++a) grabbed_[a] = mark[a] - here[a];
    } else if (tool == SliceTool::crosshair) {
      drag_ = Drag::crosshair;
      scene_.set_crosshair(point_at(at));
    } else if (tool == SliceTool::window) {
      drag_ = Drag::window;
    } else {
      drag_ = Drag::measure;
      scene_.put_point(plane_, point_at(at));
    }
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (shown_ == nullptr) return;
  const QPointF at = event->localPos(), moved = at - last_;
  last_ = at;
  scene_.hover(point_at(at));
  if (drag_ == Drag::none && scene_.tool() == SliceTool::crosshair) {
    const QString name = words_of(landmark_near(at));
    setCursor(name.isEmpty() ? Qt::ArrowCursor : Qt::OpenHandCursor);
    setToolTip(name);
  }
  switch (drag_) {
    case Drag::crosshair:
      scene_.set_crosshair(point_at(at));
      break;
    case Drag::window: {
      // To the right wider, upwards darker, as viewers have it.
      GreyWindow window = scene_.grey();
      window.width += kHuAPixel * moved.x();
      window.centre -= kHuAPixel * moved.y();
      scene_.set_grey(window);
      break;
    }
    case Drag::pan:
      middle_ -= QPointF(moved.x() / scale_, axes_.down_sign * moved.y() / scale_);
      fitted_ = false;
      update();
      break;
    case Drag::landmark: {
      auto to = point_at(at);
      for (int a = 0; a < 3; ++a) to[a] += grabbed_[a];
      scene_.drag_landmark(dragged_, to);
      break;
    }
    case Drag::none:
    case Drag::measure:
      break;
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  const Drag was = drag_;
  drag_ = Drag::none;
  const QPointF moved = event->localPos() - pressed_;
  if (was == Drag::landmark && !moved.isNull()) scene_.drop_landmark(dragged_);
  if (was == Drag::measure && scene_.measuring() && std::hypot(moved.x(), moved.y()) > kDragBegins)
    scene_.put_point(plane_, point_at(event->localPos()));
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && scene_.tool() == SliceTool::crosshair &&
      landmark_near(event->localPos()).empty())
    emit alone_wanted();
  else
    mousePressEvent(event);  // two quick clicks of a ruler are two points
}

void SliceView::wheelEvent(QWheelEvent* event) {
  const int notches = event->angleDelta().y();
  if (notches == 0) return;
  if ((event->modifiers() & Qt::ControlModifier) != 0)
    zoom(std::pow(kZoomANotch, notches / 120.0), event->position());
  else
    scene_.scroll(plane_, notches > 0 ? 1 : -1);
  event->accept();
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (shown_ == nullptr) return QWidget::keyPressEvent(event);
  auto at = scene_.crosshair();
  const auto step = [&](int axis, double sign) {
    at[axis] += sign * shown_->grid.spacing[axis];
    scene_.set_crosshair(at);
    scene_.hover(scene_.crosshair());
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return step(axes_.across, -1.0);
    case Qt::Key_Right:
      return step(axes_.across, 1.0);
    case Qt::Key_Up:
      return step(axes_.down, -axes_.down_sign);
    case Qt::Key_Down:
      return step(axes_.down, axes_.down_sign);
    case Qt::Key_PageUp:
      return scene_.scroll(plane_, 1);
    case Qt::Key_PageDown:
      return scene_.scroll(plane_, -1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kZoomANotch, pixel_of(scene_.crosshair()));
    case Qt::Key_Minus:
      return zoom(1.0 / kZoomANotch, pixel_of(scene_.crosshair()));
    case Qt::Key_0:
      return fit();
    case Qt::Key_F:
      return alone_wanted();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return scene_.put_point(plane_, scene_.crosshair());
    case Qt::Key_Escape:
      if (scene_.tool() == SliceTool::crosshair) break;
      return scene_.set_tool(SliceTool::crosshair);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return scene_.remove_last_measure();
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace vallecula::gui
