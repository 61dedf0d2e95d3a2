#include "gui/views/sagittal_view.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkClipPolyData.h>
#include <vtkContourTriangulator.h>
#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cstdint>

#include "gui/views/theme.h"
#include "gui/views/tissue_colours.h"
#include "gui/views/tool_look.h"

namespace vallecula::gui {
namespace {

vtkSmartPointer<vtkPlane> sagittal_plane(double x_mm) {
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(x_mm, 0, 0);
  plane->SetNormal(1, 0, 0);
  return plane;
}

struct Section {
  vtkSmartPointer<vtkPolyData> fill, outline;
};

Section cut_of(vtkPolyData* closed_surface, double x_mm) {
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(closed_surface);
  cutter->SetCutFunction(sagittal_plane(x_mm));
  cutter->GenerateCutScalarsOff();
  vtkNew<vtkContourTriangulator> filler;
  filler->SetInputConnection(cutter->GetOutputPort());
  filler->Update();
  Section cut;
  cut.fill = filler->GetOutput();
  cutter->Update();
  cut.outline = cutter->GetOutput();
  return cut;
}

// Layers lie on parallel planes, the later ones nearer to the viewer, so that drawing order needs no tricks.
// The tube is drawn whole, as seen from the patient's left: behind the blade, which it lies to the right of.
constexpr double kFlesh = 0.0, kFood = 0.5, kAir = 1.0, kBone = 2.0, kSoft = 3.0, kEdges = 4.0, kMarks = 5.0,
                 kTube = 100.0, kTool = 160.0, kSight = 220.0;

}  // namespace

SagittalView::SagittalView(QWidget* parent) : GlView(parent) {
  renderer()->SetBackground(0.075, 0.085, 0.10);
  renderer()->SetAutomaticLightCreation(false);
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  renderer()->AddLight(light);
}

vtkSmartPointer<vtkActor> SagittalView::add_flat(vtkPolyData* surface, double towards_viewer_mm, double red,
                                                 double green, double blue) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(red, green, blue);
  actor->SetPosition(towards_viewer_mm, 0, 0);
  renderer()->AddActor(actor);
  return actor;
}

void SagittalView::show_patient(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool,
                                const engine::IntubationDescription* intubation) {
  forget_picture();
  renderer()->RemoveAllViewProps();
  look_ = std::move(look);
  add_anatomy_cuts();
  add_soft_cut();
  tube_.reset();
  marks_.reset();
  if (intubation != nullptr) add_intubation(*intubation);
  add_tool(tool);
  add_sight_line();
  frame();
}

void SagittalView::add_anatomy_cuts() {
  const double x = look_->framing.midline_x_mm;
  const auto& surfaces = look_->package.surfaces;
  const auto find = [&](const char* name) -> vtkSmartPointer<vtkPolyData> {
    const auto found = surfaces.find(name);
    return found == surfaces.end() ? nullptr : to_poly_data(found->second);
  };
  moving_.clear();
  const auto add_moving = [&](vtkPolyData* cut, double layer, const Colour& colour) {
    moving_.emplace_back(cut, *look_->motion, MovingSurface::Kind::cut);
    return add_flat(cut, layer, colour[0], colour[1], colour[2]);
  };
  constexpr Colour kFleshColour = {0.78, 0.50, 0.45}, kAirColour = {0.13, 0.19, 0.27};
  if (const auto face = find("face")) {
    const Section cut = cut_of(face, x);
    add_moving(cut.fill, kFlesh, kFleshColour);
    add_moving(cut.outline, kEdges, {0.40, 0.18, 0.17})->GetProperty()->SetLineWidth(1.4f);
  }
  // Where the tongue lay at rest there is air once it has been lifted away: its rest shape is drawn as air below it.
  add_moving(cut_of(look_->soft->boundary(), x).fill, kAir, kAirColour);
  if (const auto airway = find("airway")) {
    add_moving(cut_of(airway, x).fill, kAir + 0.2, kAirColour);
    const auto& normal = look_->package.landmarks.at("glottis_normal");
    vtkNew<vtkPlane> below;
    below->SetOrigin(look_->package.landmarks.at("glottis_centre").data());
    below->SetNormal(normal.data());
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(cut_of(airway, x).fill);
    clip->SetClipFunction(below);
    clip->InsideOutOn();
    vtkNew<vtkPolyDataConnectivityFilter> trachea;  // and not the food way's pouches beside it
    trachea->SetInputConnection(clip->GetOutputPort());
    trachea->SetExtractionModeToClosestPointRegion();
    trachea->SetClosestPoint(look_->package.landmarks.at("carina").data());
    trachea->Update();
    add_moving(trachea->GetOutput(), kAir + 0.4, kAirwayBlue);
  }
  for (const char* name : {"palate", "mandible"})
    if (const auto bone = find(name)) {
      const Section cut = cut_of(bone, x);
      add_moving(cut.fill, kBone, kBoneColour);
      add_moving(cut.outline, kBone + 0.2, {0.55, 0.50, 0.38})->GetProperty()->SetLineWidth(1.2f);
    }
}

void SagittalView::add_soft_cut() {
  const auto& mesh = look_->package.tongue;
  soft_.clear();
  soft_points_ = vtkSmartPointer<vtkPoints>::New();
  soft_points_->SetDataTypeToFloat();
  for (const auto& p : mesh.points) soft_points_->InsertNextPoint(p.data());
  for (const std::uint8_t tissue : {0, 1}) {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(soft_points_);
    grid->Allocate(static_cast<vtkIdType>(mesh.tets.size()));
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
      if ((i < mesh.tissue.size() ? mesh.tissue[i] : 0) != tissue) continue;
      const vtkIdType ids[4] = {mesh.tets[i][0], mesh.tets[i][1], mesh.tets[i][2], mesh.tets[i][3]};
      grid->InsertNextCell(VTK_TETRA, 4, ids);
    }
    if (grid->GetNumberOfCells() == 0) continue;  // a CT in which no epiglottis was found
    soft_.push_back(grid);
    vtkNew<vtkCutter> fill;  // a cut tetrahedron is a filled triangle or quadrangle: no outline has to be closed
    fill->SetInputData(grid);
    fill->SetCutFunction(sagittal_plane(look_->framing.midline_x_mm));
    fill->GenerateCutScalarsOff();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(fill->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    const Colour& colour = tissue == 1 ? kEpiglottisColour : kTongueColour;
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    actor->SetPosition(kSoft + 0.3 * tissue, 0, 0);
    renderer()->AddActor(actor);
  }

  vtkNew<vtkCutter> outline;
  outline->SetInputData(look_->soft->surface());
  outline->SetCutFunction(sagittal_plane(look_->framing.midline_x_mm));
  outline->GenerateCutScalarsOff();
  vtkNew<vtkPolyDataMapper> edge;
  edge->SetInputConnection(outline->GetOutputPort());
  edge->ScalarVisibilityOff();
  vtkNew<vtkActor> edge_actor;
  edge_actor->SetMapper(edge);
  edge_actor->GetProperty()->LightingOff();
  edge_actor->GetProperty()->SetColor(0.42, 0.12, 0.13);
  edge_actor->GetProperty()->SetLineWidth(1.6f);
  edge_actor->SetPosition(kEdges, 0, 0);
  renderer()->AddActor(edge_actor);
}

void SagittalView::add_tool(const engine::TriangleMesh& tool) {
  const auto make = [&](vtkPolyData* surface, double red, double green, double blue, double opacity) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(red, green, blue);
    actor->GetProperty()->SetAmbient(0.3);
    actor->GetProperty()->SetDiffuse(0.6);
    actor->GetProperty()->SetOpacity(opacity);
    actor->VisibilityOff();
    renderer()->AddActor(actor);
    return actor;
  };
  const auto blade = blade_surface(tool), handle = handle_surface(tool);
  ghost_ = make(blade, 0.6, 0.6, 0.62, 0.35);
  blade_ = make(blade, 0.70, 0.73, 0.78, 1.0);
  handle_ = make(handle, 0.55, 0.57, 0.62, 1.0);
}

void SagittalView::add_intubation(const engine::IntubationDescription& intubation) {
  marks_ = airway_marks(intubation.course, look_->framing.midline_x_mm, kFood, kMarks);
  for (const auto& mark : marks_->props) renderer()->AddViewProp(mark);
  tube_ = std::make_unique<TubeLook>(intubation);
  for (const auto& actor : tube_->actors()) {
    actor->SetPosition(kTube, 0, 0);
    renderer()->AddActor(actor);
  }
}

void SagittalView::add_sight_line() {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(look_->framing.eye.data());
  points->InsertNextPoint(look_->framing.glottis.data());
  vtkNew<vtkCellArray> lines;
  const vtkIdType ids[2] = {0, 1};
  lines->InsertNextCell(2, ids);
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(lines);
  sight_ = add_flat(line, kSight, 0.95, 0.45, 0.30);
  sight_->GetProperty()->SetLineWidth(2.0f);
}

/// What lies before or beside the mouth this far from the middle would be drawn through what the cut shows.
bool SagittalView::beside_the_cut(const engine::Snapshot& snapshot) const {
  constexpr double kAside_mm = 12.0;
  return snapshot.has_intubation && snapshot.intubation.place == engine::TipPlace::outside &&
         std::abs(1e3 * snapshot.intubation.tip_m.x() - look_->framing.midline_x_mm) > kAside_mm;
}

void SagittalView::update_from(const engine::Snapshot& snapshot, double sight_percent) {
  if (!look_ || snapshot.step < 0) return;
  const std::size_t nodes = look_->package.tongue.points.size();
  if (snapshot.soft_points.size() == 3 * nodes) {
    auto* array = vtkFloatArray::SafeDownCast(soft_points_->GetData());
    float* out = array->GetPointer(0);
    for (std::size_t i = 0; i < 3 * nodes; ++i) out[i] = 1000.0f * snapshot.soft_points[i];
    array->Modified();
    soft_points_->Modified();
    for (const auto& grid : soft_) grid->Modified();
  }
  if (words_scale_ != theme::look().text_scale) fit_words();
  for (MovingSurface& cut : moving_) cut.update(snapshot);
  if (tube_) tube_->update(snapshot);
  if (tube_ && beside_the_cut(snapshot))
    for (const auto& actor : tube_->actors()) actor->VisibilityOff();
  const auto in_front = [](const engine::Pose& pose) {
    auto matrix = tool_matrix(pose);
    matrix->SetElement(0, 3, matrix->GetElement(0, 3) + kTool);
    return matrix;
  };
  const auto proxy = in_front(snapshot.proxy_pose);
  for (const auto& actor : {blade_, handle_}) {
    actor->SetUserMatrix(proxy);
    actor->VisibilityOn();
  }
  ghost_->SetUserMatrix(in_front(snapshot.device_pose));
  ghost_->SetVisibility((snapshot.device_pose.position - snapshot.proxy_pose.position).norm() > 0.0005);
  const bool seen = 100.0 * snapshot.glottis_visible >= sight_percent;
  if (seen)
    sight_->GetProperty()->SetColor(0.45, 0.95, 0.50);
  else
    sight_->GetProperty()->SetColor(0.95, 0.45, 0.30);
}

void SagittalView::frame() {
  double low_y = 1e30, high_y = -1e30, low_z = 1e30, high_z = -1e30;
  std::vector<const char*> wanted{"upper_gum_midline", "lower_gum_midline", "glottis_centre", "vallecula", "hyoid",
                                  "epiglottis_tip"};
  if (tube_) wanted.push_back("carina");
  for (const char* name : wanted) {
    const auto found = look_->package.landmarks.find(name);
    if (found == look_->package.landmarks.end()) continue;
    low_y = std::min(low_y, found->second[1]);
    high_y = std::max(high_y, found->second[1]);
    low_z = std::min(low_z, found->second[2]);
    high_z = std::max(high_z, found->second[2]);
  }
  const double depth = high_y - low_y, tall = high_z - low_z;
  width_mm_ = 2.2 * depth;                   // lips and nose in front, the back wall of the throat behind
  height_mm_ = (tube_ ? 1.45 : 2.1) * tall;  // the palate and nose above, the windpipe below
  centre_y_ = 0.5 * (low_y + high_y) - 0.08 * depth;
  centre_z_ = 0.5 * (low_z + high_z) + (tube_ ? 0.10 : -0.05) * tall;
  auto* camera = renderer()->GetActiveCamera();
  camera->ParallelProjectionOn();
  const double x = look_->framing.midline_x_mm;
  camera->SetFocalPoint(x, centre_y_, centre_z_);
  camera->SetPosition(x + 500.0, centre_y_, centre_z_);
  camera->SetViewUp(0, 0, 1);
  camera->SetClippingRange(100.0, 900.0);
  const double aspect = static_cast<double>(std::max(width(), 1)) / std::max(height(), 1);
  camera->SetParallelScale(0.5 * std::max(height_mm_, width_mm_ / aspect));
  fit_words();
}

/// As large as the window's text, and no more of them than have room.
void SagittalView::fit_words() {
  words_scale_ = theme::look().text_scale;
  if (!marks_) return;
  const double px_per_mm = 0.5 * std::max(height(), 1) / renderer()->GetActiveCamera()->GetParallelScale();
  const double before_px = 0.5 * width() + (marks_->good_front_mm.x() - centre_y_) * px_per_mm;
  marks_->set_type(words_scale_, 10.0 * px_per_mm, before_px);
}

void SagittalView::resizeEvent(QResizeEvent* event) {
  GlView::resizeEvent(event);
  if (look_) frame();
}

}  // namespace vallecula::gui
