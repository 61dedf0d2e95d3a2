#include "gui/views/video_view.h"

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>

namespace vallecula::gui {
namespace {

constexpr double kNearMm = 0.3;  // what touches the lens fills the picture, and is not cut away
constexpr double kFarMm = 200.0;

/// The rim of the little screen.
vtkSmartPointer<vtkActor2D> thin_frame() {
  vtkNew<vtkPoints> corners;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) corners->InsertNextPoint(x, y, 0);
  vtkNew<vtkCellArray> lines;
  const vtkIdType around[5] = {0, 1, 2, 3, 0};
  lines->InsertNextCell(5, around);
  vtkNew<vtkPolyData> outline;
  outline->SetPoints(corners);
  outline->SetLines(lines);
  vtkNew<vtkCoordinate> share;
  share->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(outline);
  mapper->SetTransformCoordinate(share);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.08, 0.09, 0.10);
  actor->GetProperty()->SetLineWidth(5.0f);
  return actor;
}

}  // namespace

VideoView::VideoView(QWidget* parent) : GlView(parent) {
  renderer()->SetBackground(0.45, 0.16, 0.14);  // beyond all that is drawn there is more of the same
  renderer()->SetAutomaticLightCreation(false);
  vtkNew<vtkLight> lamp;  // for the steel; tissue has its own lamps in its shader
  lamp->SetLightTypeToHeadlight();
  renderer()->AddLight(lamp);
}

void VideoView::show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                             const engine::IntubationDescription* intubation) {
  make_current();
  forget_picture();
  renderer()->RemoveAllViewProps();
  stage_ = std::make_unique<MouthStage>(std::move(look), tool, intubation, MouthStage::Eye::in_the_mouth, renderer());
  stage_->set_blue_trachea(blue_trachea_);
  renderer()->AddActor2D(thin_frame());
  use_present();
}

void VideoView::update_from(const engine::Snapshot& snapshot) {
  if (!stage_ || snapshot.step < 0) return;
  stage_->update(snapshot);
  const engine::Pose& blade = snapshot.proxy_pose;
  const engine::Vec3 at = 1000.0 * blade.position + blade.rotation * stage_->tool().camera_mm(),
                     ahead = -(blade.rotation * engine::Vec3::UnitX()), up = blade.rotation * engine::Vec3::UnitZ();
  const engine::Vec3 to = at + 20.0 * ahead;
  auto* camera = renderer()->GetActiveCamera();
  camera->SetPosition(at.x(), at.y(), at.z());
  camera->SetFocalPoint(to.x(), to.y(), to.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  camera->SetUseHorizontalViewAngle(width() < height());
  camera->SetViewAngle(kFieldDeg);
  camera->SetClippingRange(kNearMm, kFarMm);
  stage_->light(camera);
}

void VideoView::set_blue_trachea(bool blue) {
  blue_trachea_ = blue;
  if (stage_) stage_->set_blue_trachea(blue);
}

void VideoView::use(const Quality& quality) {
  GlView::use(quality);
  if (!stage_) return;
  stage_->set_effects(quality.shadows, quality.rim);
  stage_->light(renderer()->GetActiveCamera());
}

}  // namespace vallecula::gui
