#include "gui/views/label_view.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/pages/background.h"
#include "gui/views/label_surfaces.h"
#include "gui/views/theme.h"
#include "pipeline/package/label_map.h"

namespace vallecula::gui {
namespace {

using Surfaces = std::map<std::uint8_t, vtkSmartPointer<vtkPolyData>>;

constexpr double kDegreesAPixel = 0.5, kDegreesAKey = 10.0, kZoomAStep = 1.2, kGrab = 10.0;
constexpr double kMarkPixels = 4.5;  // a landmark's radius, however near one looks

}  // namespace

LabelView::LabelView(SliceScene& scene, QWidget* parent) : GlView(parent), scene_(scene) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(150, 120);
  setAccessibleName(tr("Structures in 3D"));
  setAccessibleDescription(tr("Arrows turn, plus and minus zoom, 0 looks from the front, F shows this view alone"));
  setMouseTracking(true);
  over_ = vtkSmartPointer<vtkRenderer>::New();
  over_->SetLayer(1);
  over_->SetActiveCamera(renderer()->GetActiveCamera());
  over_->InteractiveOff();
  renderWindow()->SetNumberOfLayers(2);
  renderWindow()->AddRenderer(over_);
  const QColor ground = theme::ground();
  renderer()->SetBackground(ground.redF(), ground.greenF(), ground.blueF());
  redraw_.setSingleShot(true);
  redraw_.setInterval(30);
  connect(&redraw_, &QTimer::timeout, this, [this] { draw(); });
  connect(&scene_, &SliceScene::labels_changed, this, &LabelView::labels_changed);
  connect(&scene_, &SliceScene::landmarks_changed, this, &LabelView::show_landmarks);
  connect(&scene_, &SliceScene::landmark_dragged, this, [this](const QString& name, const pipeline::Point& at) {
    const auto mark = marks_.find(name.toStdString());
    if (mark == marks_.end()) return;
    mark->second->SetPosition(at[0], at[1], at[2]);
    draw_soon();
  });
}

LabelView::~LabelView() {
  if (go_on_) *go_on_ = false;
  if (worker_) worker_->wait();
}

void LabelView::draw_soon() {
  if (isVisible() && !redraw_.isActive()) redraw_.start();
}

void LabelView::showEvent(QShowEvent* event) {
  GlView::showEvent(event);
  draw_soon();
}

void LabelView::focusInEvent(QFocusEvent* event) {
  GlView::focusInEvent(event);
  emit focus_changed(true);
}

void LabelView::focusOutEvent(QFocusEvent* event) {
  GlView::focusOutEvent(event);
  emit focus_changed(false);
}

void LabelView::labels_changed() {
  if (scene_.labels() == shown_) {
    show_visible();
    return;
  }
  shown_ = scene_.labels();
  if (shown_ == nullptr) {
    for (auto& [value, actor] : actors_) renderer()->RemoveActor(actor);
    actors_.clear();
    framed_ = false;
    forget_picture();
    draw_soon();
  }
  stale_ = true;
  if (go_on_) *go_on_ = false;
  if (!worker_) make_surfaces();
}

void LabelView::make_surfaces() {
  stale_ = false;
  const auto labels = scene_.shared_labels();
  if (!labels) return;
  auto go_on = std::make_shared<std::atomic<bool>>(true);
  go_on_ = go_on;
  const auto over = [this] {
    worker_.clear();  // the thread is done, but not yet deleted
    if (stale_) make_surfaces();
  };
  worker_ = run_in_background<Surfaces>(
      this, [labels, go_on] { return label_surfaces(*labels, [go_on] { return go_on->load(); }); },
      [this, over, labels](const Surfaces& surfaces) {
        if (labels.get() == shown_ && !stale_) {
          for (auto& [value, actor] : actors_) renderer()->RemoveActor(actor);
          actors_.clear();
          for (const auto& label : pipeline::kLabelNames) {
            const auto found = surfaces.find(label.value);
            if (found == surfaces.end()) continue;
            auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
            mapper->SetInputData(found->second);
            auto actor = vtkSmartPointer<vtkActor>::New();
            actor->SetMapper(mapper);
            actor->GetProperty()->SetColor(label.rgb[0], label.rgb[1], label.rgb[2]);
            // One sees through skin and skull, but not through their far side as well: that would need sorting.
            if (label.value == pipeline::kSkin || label.value == pipeline::kSkull) {
              actor->GetProperty()->SetOpacity(0.35);
              actor->GetProperty()->BackfaceCullingOn();
            }
            renderer()->AddActor(actor);
            actors_[label.value] = actor;
          }
          show_visible();
          if (!framed_) look_from_front();
          framed_ = true;
        }
        over();
      },
      [over](const QString&) { over(); });
}

void LabelView::show_visible() {
  for (auto& [value, actor] : actors_) actor->SetVisibility(scene_.visible(value));
  draw_soon();
}

void LabelView::show_landmarks() {
  for (auto& [name, actor] : marks_) over_->RemoveActor(actor);
  marks_.clear();
  for (const auto& [name, mark] : scene_.landmarks()) {
    auto ball = vtkSmartPointer<vtkSphereSource>::New();
    ball->SetRadius(1.0);
    ball->SetThetaResolution(16);
    ball->SetPhiResolution(12);
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(ball->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->SetPosition(mark.at[0], mark.at[1], mark.at[2]);
    const QColor colour = mark.given ? theme::over() : QColor(Qt::white);
    actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    over_->AddActor(actor);
    marks_[name] = actor;
  }
  size_marks();
  draw_soon();
}

void LabelView::size_marks() {
  auto* camera = renderer()->GetActiveCamera();
  const double high_mm =
      2.0 * camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  for (auto& [name, actor] : marks_) actor->SetScale(kMarkPixels * high_mm / std::max(1, height()));
}

void LabelView::resizeEvent(QResizeEvent* event) {
  GlView::resizeEvent(event);
  size_marks();
}

void LabelView::look_from_front() {
  auto* camera = renderer()->GetActiveCamera();
  // From the front and a little from the patient's left, where mouth and throat show at once.
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0.6, -1.0, 0.15);
  camera->SetViewUp(0, 0, 1);
  renderer()->ResetCamera();
  camera->Zoom(1.2);
  renderer()->ResetCameraClippingRange();
  size_marks();
  draw_soon();
}

void LabelView::turn(double right_deg, double up_deg) {
  auto* camera = renderer()->GetActiveCamera();
  camera->Azimuth(-right_deg);
  camera->Elevation(up_deg);
  camera->OrthogonalizeViewUp();
  renderer()->ResetCameraClippingRange();
  draw_soon();
}

void LabelView::zoom(double factor) {
  renderer()->GetActiveCamera()->Dolly(factor);
  size_marks();
  renderer()->ResetCameraClippingRange();
  draw_soon();
}

QPointF LabelView::pixel_of(const pipeline::Point& at) const {
  double normal[3] = {at[0], at[1], at[2]};
  renderer()->WorldToView(normal[0], normal[1], normal[2]);
  return {0.5 * (normal[0] + 1.0) * width(), 0.5 * (1.0 - normal[1]) * height()};
}

pipeline::Point LabelView::moved_in_screen(const pipeline::Point& from, const QPointF& pixels) const {
  double x = from[0], y = from[1], z = from[2];
  renderer()->WorldToView(x, y, z);
  x += 2.0 * pixels.x() / width();
  y -= 2.0 * pixels.y() / height();
  renderer()->ViewToWorld(x, y, z);
  return {x, y, z};
}

void LabelView::mousePressEvent(QMouseEvent* event) {
  last_ = pressed_ = event->localPos();
  dragged_.clear();
  if (event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier) dragged_ = landmark_near(last_);
}

std::string LabelView::landmark_near(const QPointF& pixel) const {
  std::string nearest;
  double reach = kGrab;
  for (const auto& [name, mark] : scene_.landmarks()) {
    const QPointF d = pixel_of(mark.at) - pixel;
    if (std::hypot(d.x(), d.y()) > reach) continue;
    reach = std::hypot(d.x(), d.y());
    nearest = name;
  }
  return nearest;
}

void LabelView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && landmark_near(event->localPos()).empty()) emit alone_wanted();
}

void LabelView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->localPos() - last_;
  last_ = event->localPos();
  const bool left = (event->buttons() & Qt::LeftButton) != 0;
  const auto mark = scene_.landmarks().find(dragged_);
  if (mark != scene_.landmarks().end() && left) {
    scene_.drag_landmark(dragged_, moved_in_screen(mark->second.at, moved));
  } else if ((event->buttons() & Qt::RightButton) != 0 || (left && event->modifiers() == Qt::ShiftModifier)) {
    auto* camera = renderer()->GetActiveCamera();
    pipeline::Point focus{}, eye{};
    camera->GetFocalPoint(focus.data());
    camera->GetPosition(eye.data());
    const auto to = moved_in_screen(focus, -moved);
    camera->SetFocalPoint(to[0], to[1], to[2]);
    camera->SetPosition(eye[0] + to[0] - focus[0], eye[1] + to[1] - focus[1], eye[2] + to[2] - focus[2]);
    draw_soon();
  } else if (left) {
    turn(kDegreesAPixel * moved.x(), kDegreesAPixel * moved.y());
  } else {
    const std::string near = landmark_near(last_);
    setCursor(near.empty() ? Qt::ArrowCursor : Qt::OpenHandCursor);
    setToolTip(words_of(near));
  }
}

void LabelView::mouseReleaseEvent(QMouseEvent* event) {
  if (!dragged_.empty() && event->localPos() != pressed_) scene_.drop_landmark(dragged_);
  dragged_.clear();
}

void LabelView::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(kZoomAStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void LabelView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return turn(-kDegreesAKey, 0.0);
    case Qt::Key_Right:
      return turn(kDegreesAKey, 0.0);
    case Qt::Key_Up:
      return turn(0.0, -kDegreesAKey);
    case Qt::Key_Down:
      return turn(0.0, kDegreesAKey);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kZoomAStep);
    case Qt::Key_Minus:
      return zoom(1.0 / kZoomAStep);
    case Qt::Key_0:
      return look_from_front();
    case Qt::Key_F:
      return alone_wanted();
    default:
      GlView::keyPressEvent(event);
  }
}

}  // namespace vallecula::gui
