#include "gui/views/mouth_stage.h"

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>
#include <cmath>

#include "gui/views/drape_look.h"

namespace vallecula::gui {
namespace {

engine::Vec3 eigen_of(const pipeline::Point& p) { return {p[0], p[1], p[2]}; }

double eased(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

vtkSmartPointer<vtkActor> tissue_actor(vtkPolyData* surface, MouthStage::Eye eye) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  shade_as_tissue(actor, mapper, 0.0, eye == MouthStage::Eye::operators ? Sides::front : Sides::both);
  return actor;
}

// The lamp of a blade outside the mouth is a spot of light in a lit room; inside it is the light.
constexpr double kLampOutside = 0.35, kLampInside = 1.2, kRoomInside = 0.80, kRoomBehindBlade = 0.34;
constexpr double kExposure = 1.05;                       // of a camera that sees by the lamp alone
constexpr double kGlowNatural = 0.05, kGlowBlue = 0.45;  // blue is a sign: to be found where little light falls
constexpr int kBladeSolids = 2;                          // a capsule along the blade, one along the handle
constexpr std::array<int, 5> kShadowNodes{0, 6, 14, 24, 39};

bool blue_everywhere = false;

}  // namespace

MouthStage::MouthStage(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                       const engine::IntubationDescription* intubation, Eye eye, vtkRenderer* renderer)
    : look_(std::move(look)), tool_(std::make_unique<ToolLook>(tool)) {
  tissues_ = {tissue_actor(eye == Eye::operators ? look_->face : look_->around_mouth, eye),
              tissue_actor(look_->soft->surface(), eye)};
  if (eye == Eye::operators) {
    close_skin_ = tissue_actor(look_->seen_close, eye);
    close_skin_->VisibilityOff();
    tissues_.push_back(close_skin_);
    drape_ = drape(*look_);
    if (drape_) renderer->AddActor(drape_);
  }
  if (look_->trachea->GetNumberOfPoints() > 0) {
    trachea_ = tissue_actor(look_->trachea, eye);
    trachea_->GetMapper()->SetScalarModeToUsePointFieldData();
    tissues_.push_back(trachea_);
  }
  if (intubation != nullptr) {
    tube_ = std::make_unique<TubeLook>(*intubation);
    cords_ = std::make_unique<CordsLook>(*intubation);
    secretions_ = std::make_unique<SecretionsLook>(intubation->secretions);
    tube_radius_mm_ = 500.0 * intubation->tube.outer_diameter;
    catheter_radius_mm_ = 500.0 * intubation->catheter_outer_m;
    tissues_.push_back(cords_->actor());
  }
  colour_trachea();
  lighting_.lips = eigen_of(look_->framing.mouth);
  lighting_.inward = (eigen_of(look_->framing.glottis) - lighting_.lips).normalized();
  if (eye == Eye::in_the_mouth) exposure_ = kExposure;
  lighting_.lamp_solids_from = kBladeSolids + 1;
  for (const auto& actor : tissues_) renderer->AddActor(actor);
  for (const auto& actor : tool_->actors()) renderer->AddActor(actor);
  if (intubation == nullptr) return;
  renderer->AddActor(secretions_->actor());  // what is seen through comes in the order from afar to near
  for (const auto& actor : tube_->actors()) renderer->AddActor(actor);
}

void MouthStage::update(const engine::Snapshot& snapshot) {
  look_->update(snapshot);
  tool_->place(snapshot.proxy_pose);
  if (tube_) {
    tube_->update(snapshot);
    cords_->update(snapshot);
    secretions_->update(snapshot);
  }
  const engine::Vec3 mouth = eigen_of(look_->framing.mouth), way = eigen_of(look_->framing.glottis) - mouth;
  depth_ = (1000.0 * snapshot.proxy_pose.position - mouth).dot(way) / way.squaredNorm();
  // The eye follows the lamp: the deeper the blade, the less of the room is left and the brighter the lamp looks.
  const double in = eased(-0.05, 0.65, depth_);
  lighting_.room_inside = kRoomInside + in * (kRoomBehindBlade - kRoomInside);
  lighting_.lamp = exposure_ * (kLampOutside + in * (kLampInside - kLampOutside));
  gather_solids(snapshot);
}

void MouthStage::gather_solids(const engine::Snapshot& snapshot) {
  auto& solids = lighting_.solids;
  solids = {};
  const auto put = [&](int i, const engine::Vec3& at_mm, double radius_mm) {
    for (int axis = 0; axis < 3; ++axis) solids[i][axis] = static_cast<float>(at_mm[axis]);
    solids[i][3] = static_cast<float>(radius_mm);
  };
  const engine::Pose& pose = snapshot.proxy_pose;
  const auto world = [&](const engine::Vec3& mm) { return engine::Vec3(1000.0 * pose.position + pose.rotation * mm); };
  const BladeExtent& blade = tool_->extent();
  put(0, world({blade.half_width_mm, 0.0, 0.0}), blade.half_width_mm);
  put(1, world({blade.length_mm, 0.0, 0.0}), 8.0);
  put(2, world({blade.length_mm, 0.0, 80.0}), 0.0);
  if (!tube_ || !snapshot.has_intubation) return;
  const double radius = snapshot.intubation.in_hand == engine::InHand::catheter ? catheter_radius_mm_ : tube_radius_mm_;
  for (int i = 0; i < static_cast<int>(kShadowNodes.size()); ++i)
    put(kBladeSolids + 1 + i, 1000.0 * snapshot.tube_axis[static_cast<std::size_t>(kShadowNodes[i])],
        i + 1 < static_cast<int>(kShadowNodes.size()) ? radius : 0.0);
}

void MouthStage::light(vtkCamera* camera) {
  lighting_.bulb = tool_->bulb_mm();
  lighting_.beam = tool_->beam();
  colour_trachea();
  for (const auto& actor : tissues_) set_lighting(actor, camera, lighting_);
}

void MouthStage::set_blue_trachea(std::optional<bool> blue) {
  blue_ = blue;
  colour_trachea();
}

void MouthStage::set_blue_everywhere(bool blue) { blue_everywhere = blue; }

void MouthStage::colour_trachea() {
  const bool blue = blue_.value_or(blue_everywhere);
  if (!trachea_ || blue_shown_ == blue) return;
  blue_shown_ = blue;
  trachea_->GetMapper()->SelectColorArray(blue ? kTracheaBlue : kTracheaNatural);
  set_glow(trachea_, blue ? kGlowBlue : kGlowNatural);
}

void MouthStage::set_close(bool on) {
  close_skin_->SetVisibility(on);
  tissues_.front()->SetVisibility(!on);
  if (drape_) drape_->SetVisibility(!on);
}

void MouthStage::set_half(bool on) {
  for (vtkActor* half : {tissues_.front().Get(), drape_.Get()})
    if (half != nullptr) half->GetMapper()->RemoveAllClippingPlanes();
  if (!on) return;
  vtkNew<vtkPlane> middle;
  middle->SetOrigin(look_->framing.midline_x_mm, 0.0, 0.0);
  middle->SetNormal(-1.0, 0.0, 0.0);
  for (vtkActor* half : {tissues_.front().Get(), drape_.Get()})
    if (half != nullptr) half->GetMapper()->AddClippingPlane(middle);
}

void MouthStage::set_effects(bool shadows, bool rim) {
  lighting_.shadows = shadows;
  lighting_.rim = rim;
}

}  // namespace vallecula::gui
