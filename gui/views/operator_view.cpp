#include "gui/views/operator_view.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

#include "gui/session/operator_axes.h"

namespace vallecula::gui {
namespace {

engine::Vec3 vec(const pipeline::Point& p) { return {p[0], p[1], p[2]}; }

constexpr double kZoomSeconds = 0.8;
constexpr double kWidestClose = 2.6;  // width over height; the cone is three times as wide as the framed mouth is high

}  // namespace

OperatorView::OperatorView(QWidget* parent) : GlView(parent) {
  renderer()->SetBackground(0.10, 0.16, 0.18);
  renderer()->SetBackground2(0.30, 0.42, 0.44);
  renderer()->GradientBackgroundOn();
  renderer()->SetAutomaticLightCreation(false);
  vtkNew<vtkLight> lamp;  // for the steel; tissue has its own lamps in its shader
  lamp->SetLightTypeToHeadlight();
  renderer()->AddLight(lamp);
  connect(this, &GlView::camera_moved, this, [this] {
    if (!look_) return;
    light();
    draw();
  });
}

void OperatorView::show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                                const engine::IntubationDescription* intubation) {
  make_current();
  forget_picture();
  renderer()->RemoveAllViewProps();
  look_ = std::move(look);
  ghost_ = std::make_unique<GhostLook>(tool);
  path_.reset();
  mark_.reset();
  stage_ = std::make_unique<MouthStage>(look_, tool, intubation, MouthStage::Eye::operators, renderer());
  for (const auto& actor : ghost_->actors()) renderer()->AddActor(actor);
  closeness_ = 0.0;
  eye_offset_mm_.setZero();
  blade_in_ = ghost_shown_ = false;
  since_aimed_.restart();
  set_half(half_);
  stage_->set_blue_trachea(blue_trachea_);
  set_free_camera(false);
  use_present();
}

void OperatorView::show_ghost_path(const engine::TriangleMesh& tool, const device::Trajectory& way) {
  path_ = std::make_unique<GhostPathLook>(tool, way);
  renderer()->AddActor(path_->actor());
}

void OperatorView::highlight_glottis() {
  mark_ = std::make_unique<GlottisMark>(look_->package, *look_->motion);
  for (const auto& actor : mark_->actors()) renderer()->AddActor(actor);
}

void OperatorView::set_ghost_time(double time_s) {
  if (path_) path_->place(time_s);
}

void OperatorView::update_from(const engine::Snapshot& snapshot) {
  if (!look_ || snapshot.step < 0) return;
  stage_->update(snapshot);
  eye_offset_mm_ = 1000.0 * snapshot.eye_offset_m;
  ghost_shown_ = ghost_->place(snapshot.device_pose, snapshot.proxy_pose);
  if (mark_) mark_->update(snapshot);
  // In or out, with some play so that the view does not flutter.
  const double depth = stage_->depth();
  if (depth > 0.12) blade_in_ = true;
  if (depth < -0.10) blade_in_ = false;
  aim();
}

double OperatorView::wanted_closeness() const {
  return zoom_ == Zoom::mouth || (zoom_ == Zoom::automatic && blade_in_) ? 1.0 : 0.0;
}

void OperatorView::settle() {
  closeness_ = wanted_closeness();
  aim();
}

void OperatorView::set_free_camera(bool on) {
  free_camera_ = on;
  set_mouse_camera(on);
  aim();
}

void OperatorView::turn_camera(double right_deg, double up_deg) {
  if (!look_ || !free_camera_) return;
  auto* camera = renderer()->GetActiveCamera();
  camera->Azimuth(-right_deg);
  camera->Elevation(up_deg);
  camera->OrthogonalizeViewUp();
  renderer()->ResetCameraClippingRange();
  light();
}

void OperatorView::set_half(bool on) {
  half_ = on;
  if (stage_) stage_->set_half(on);
}

void OperatorView::set_blue_trachea(bool blue) {
  blue_trachea_ = blue;
  if (stage_) stage_->set_blue_trachea(blue);
}

void OperatorView::use(const Quality& quality) {
  GlView::use(quality);
  if (!stage_) return;
  stage_->set_effects(quality.shadows, quality.rim);
  look_->soft->set_coarser(quality.coarser);
  light();
}

void OperatorView::light() { stage_->light(renderer()->GetActiveCamera()); }

void OperatorView::aim() {
  if (!look_) return;
  if (free_camera_) {
    stage_->set_close(false);
    renderer()->ResetCameraClippingRange();
    light();
    return;
  }
  const Framing& framing = look_->framing;
  const double elapsed = 1e-9 * static_cast<double>(since_aimed_.nsecsElapsed());
  since_aimed_.start();
  closeness_ += std::clamp(wanted_closeness() - closeness_, -elapsed / kZoomSeconds, elapsed / kZoomSeconds);
  // A view much wider than high looks past what lies in the close view's cone.
  stage_->set_close(closeness_ >= 1.0 && width() < kWidestClose * height());
  const double eased = closeness_ * closeness_ * (3.0 - 2.0 * closeness_);

  const engine::Vec3 eye = vec(framing.eye) + eye_offset_mm_;
  across_mm_ = framing.face_mm * std::pow(framing.mouth_mm / framing.face_mm, eased);
  // Close to, the view is centred on the opening as it is seen, not on the nose below it.
  const engine::Vec3 at =
      vec(framing.mouth) + eased * (vec(framing.inside) - vec(framing.mouth) + 0.10 * across_mm_ * screen_up());
  const engine::Vec3 up = operator_axes(eye, at).up;
  auto* camera = renderer()->GetActiveCamera();
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetFocalPoint(at.x(), at.y(), at.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(0.5 * across_mm_ / (at - eye).norm())));
  renderer()->ResetCameraClippingRange();
  light();
}

engine::Vec3 OperatorView::screen_up() const {
  return look_ ? operator_axes(vec(look_->framing.eye), vec(look_->framing.mouth)).up : OperatorAxes().up;
}

engine::Vec3 OperatorView::screen_right() const {
  return look_ ? operator_axes(vec(look_->framing.eye), vec(look_->framing.mouth)).right : OperatorAxes().right;
}

double OperatorView::mm_per_pixel() const { return across_mm_ / std::max(1, height()); }

}  // namespace vallecula::gui
