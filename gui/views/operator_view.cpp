#include "gui/views/operator_view.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "gui/session/operator_axes.h"
#include "gui/views/tissue_shading.h"

namespace vallecula::gui {
namespace {

vtkSmartPointer<vtkActor> tissue_actor(vtkPolyData* surface, double glow) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->BackfaceCullingOn();  // closed surfaces: half the drawing is never seen
  shade_as_tissue(actor, mapper, glow);
  return actor;
}

engine::Vec3 vec(const pipeline::Point& p) { return {p[0], p[1], p[2]}; }

constexpr double kZoomSeconds = 0.8;
constexpr double kLampStrength = 0.75;

}  // namespace

OperatorView::OperatorView(QWidget* parent) : GlView(parent) {
  renderer()->SetBackground(0.10, 0.16, 0.18);
  renderer()->SetBackground2(0.30, 0.42, 0.44);
  renderer()->GradientBackgroundOn();
  renderer()->SetAutomaticLightCreation(false);
  vtkNew<vtkLight> light;  // for the steel; tissue has its own lamps in its shader
  light->SetLightTypeToHeadlight();
  renderer()->AddLight(light);
  connect(this, &GlView::camera_moved, this, [this] {
    if (!look_) return;
    move_lamp();
    draw();
  });
}

void OperatorView::show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                                const engine::IntubationDescription* intubation) {
  renderer()->RemoveAllViewProps();
  look_ = std::move(look);
  tool_ = std::make_unique<ToolLook>(tool);
  ghost_ = std::make_unique<GhostLook>(tool);
  tissues_ = {tissue_actor(look_->face, 0.0), tissue_actor(look_->soft->surface(), 0.0)};
  if (look_->trachea->GetNumberOfPoints() > 0)
    tissues_.push_back(
        tissue_actor(look_->trachea, 0.45));  // a sign, not a tissue: to be found where little light falls
  tube_.reset();
  cords_.reset();
  secretions_.reset();
  path_.reset();
  mark_.reset();
  if (intubation != nullptr) {
    tube_ = std::make_unique<TubeLook>(*intubation);
    cords_ = std::make_unique<CordsLook>(*intubation);
    secretions_ = std::make_unique<SecretionsLook>(intubation->secretions);
    tissues_.push_back(cords_->actor());
  }
  for (const auto& actor : tissues_) renderer()->AddActor(actor);
  for (const auto& actor : tool_->actors()) renderer()->AddActor(actor);
  if (intubation != nullptr) {  // what is seen through comes in the order from afar to near
    renderer()->AddActor(secretions_->actor());
    for (const auto& actor : tube_->actors()) renderer()->AddActor(actor);
  }
  for (const auto& actor : ghost_->actors()) renderer()->AddActor(actor);
  closeness_ = 0.0;
  blade_in_ = ghost_shown_ = false;
  since_aimed_.restart();
  set_half(half_);
  set_free_camera(false);
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
  look_->update(snapshot);
  follow(snapshot);
}

void OperatorView::follow(const engine::Snapshot& snapshot) {
  if (!look_ || snapshot.step < 0) return;
  tool_->place(snapshot.proxy_pose);
  ghost_shown_ = ghost_->place(snapshot.device_pose, snapshot.proxy_pose);
  if (mark_) mark_->update(snapshot);
  if (tube_) {
    tube_->update(snapshot);
    cords_->update(snapshot);
    secretions_->update(snapshot);
  }
  // In or out: how far the tip is past the gums on the way to the glottis, with some play so that the view does not
  // flutter.
  const engine::Vec3 mouth = vec(look_->framing.mouth), way = vec(look_->framing.glottis) - mouth;
  const double depth = (1000.0 * snapshot.proxy_pose.position - mouth).dot(way) / way.squaredNorm();
  if (depth > 0.12) blade_in_ = true;
  if (depth < -0.10) blade_in_ = false;
  aim();
}

void OperatorView::settle() {
  const bool close = zoom_ == Zoom::mouth || (zoom_ == Zoom::automatic && blade_in_);
  closeness_ = close ? 1.0 : 0.0;
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
  move_lamp();
}

void OperatorView::set_half(bool on) {
  half_ = on;
  if (tissues_.empty()) return;
  auto* skin = tissues_.front()->GetMapper();
  skin->RemoveAllClippingPlanes();
  if (!on) return;
  vtkNew<vtkPlane> middle;
  middle->SetOrigin(look_->framing.midline_x_mm, 0.0, 0.0);
  middle->SetNormal(-1.0, 0.0, 0.0);
  skin->AddClippingPlane(middle);
}

void OperatorView::move_lamp() {
  for (const auto& actor : tissues_)
    set_lamp(actor, renderer()->GetActiveCamera(), tool_->bulb_mm(), tool_->beam(), kLampStrength);
}

void OperatorView::aim() {
  if (!look_) return;
  if (free_camera_) {
    renderer()->ResetCameraClippingRange();
    move_lamp();
    return;
  }
  const Framing& framing = look_->framing;
  const bool close = zoom_ == Zoom::mouth || (zoom_ == Zoom::automatic && blade_in_);
  const double elapsed = 1e-9 * static_cast<double>(since_aimed_.nsecsElapsed());
  since_aimed_.start();
  closeness_ += std::clamp((close ? 1.0 : 0.0) - closeness_, -elapsed / kZoomSeconds, elapsed / kZoomSeconds);
  const double eased = closeness_ * closeness_ * (3.0 - 2.0 * closeness_);

  const engine::Vec3 eye = vec(framing.eye);
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
  move_lamp();
}

engine::Vec3 OperatorView::screen_up() const {
  return look_ ? operator_axes(vec(look_->framing.eye), vec(look_->framing.mouth)).up : OperatorAxes().up;
}

engine::Vec3 OperatorView::screen_right() const {
  return look_ ? operator_axes(vec(look_->framing.eye), vec(look_->framing.mouth)).right : OperatorAxes().right;
}

double OperatorView::mm_per_pixel() const { return across_mm_ / std::max(1, height()); }

}  // namespace vallecula::gui
