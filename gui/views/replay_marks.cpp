#include "gui/views/replay_marks.h"

#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>

#include "gui/views/theme.h"

namespace vallecula::gui {

namespace {

constexpr double kSeenFrom_n = 0.1;   // a touch of less has no arrow
constexpr double kThickness_mm = 7.0;  // of an arrow of unit length: its head is 0.2 of that across

vtkSmartPointer<vtkActor> always_seen(vtkPolyDataMapper* mapper, const QColor& colour) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  // Nearer than anything else, and in their own order among themselves.
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
                                                           "gl_FragDepth = 0.001 * gl_FragCoord.z;\n", false);
  return actor;
}

vtkSmartPointer<vtkPolyData> line_through(const std::vector<std::array<float, 3>>& points) {
  auto line = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> at;
  for (const auto& p : points) at->InsertNextPoint(p.data());
  line->SetPoints(at);
  return line;
}

void draw_first(vtkPolyData* line, std::size_t points) {
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> ids(points);
  std::iota(ids.begin(), ids.end(), 0);
  if (points > 1) cells->InsertNextCell(static_cast<vtkIdType>(points), ids.data());
  line->SetLines(cells);
  line->Modified();
}

vtkSmartPointer<vtkActor> line_actor(vtkPolyData* line, const QColor& colour, float width) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(line);
  auto actor = always_seen(mapper, colour);
  actor->GetProperty()->SetLineWidth(width);
  actor->VisibilityOff();
  return actor;
}

/// The arrow source's +x to `direction` (not zero), `length` long, from `at`; all mm.
vtkSmartPointer<vtkMatrix4x4> arrow_matrix(const engine::Vec3& at, const engine::Vec3& direction, double length) {
  const engine::Quat turn = engine::Quat::FromTwoVectors(engine::Vec3::UnitX(), direction);
  const engine::Mat3 axes = turn.toRotationMatrix();
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row) {
    matrix->SetElement(row, 0, length * axes(row, 0));
    matrix->SetElement(row, 1, kThickness_mm * axes(row, 1));
    matrix->SetElement(row, 2, kThickness_mm * axes(row, 2));
    matrix->SetElement(row, 3, at[row]);
  }
  return matrix;
}

}  // namespace

std::array<unsigned char, 3> path_colour(double tongue_n, double target_n) {
  const QColor& c = target_n <= 0.0 || tongue_n < 0.5 * target_n ? theme::device()
                    : tongue_n <= target_n                       ? theme::target()
                                                                 : theme::bad();
  return {static_cast<unsigned char>(c.red()), static_cast<unsigned char>(c.green()),
          static_cast<unsigned char>(c.blue())};
}

ReplayMarks::ReplayMarks() : path_data_(line_through({})), expert_data_(line_through({})) {
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(20);
  arrow->SetShaftResolution(16);
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(arrow->GetOutputPort());
    const auto structure = static_cast<engine::Structure>(i);
    // As in the force chart: what lies on the gums, the palate and the teeth is another matter than the tongue.
    const bool soft = structure == engine::Structure::tongue || structure == engine::Structure::epiglottis ||
                      structure == engine::Structure::larynx;
    arrows_[i] = always_seen(mapper, soft ? theme::device() : theme::bad());
    arrows_[i]->VisibilityOff();
  }
  path_ = line_actor(path_data_, theme::device(), 3.0f);
  expert_ = line_actor(expert_data_, Qt::white, 1.6f);
  expert_->GetProperty()->SetOpacity(0.75);
}

std::vector<vtkSmartPointer<vtkProp>> ReplayMarks::props() const {
  std::vector<vtkSmartPointer<vtkProp>> all{expert_, path_};
  all.insert(all.end(), arrows_.begin(), arrows_.end());
  return all;
}

void ReplayMarks::set_paths(const TipPath& trial, const TipPath& expert, double target_n) {
  path_time_s_ = trial.time_s;
  path_data_->Initialize();
  path_data_->ShallowCopy(line_through(trial.tip_mm));
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (const float force : trial.tongue_n) colours->InsertNextTypedTuple(path_colour(force, target_n).data());
  path_data_->GetPointData()->SetScalars(colours);
  expert_data_->ShallowCopy(line_through(expert.tip_mm));
  draw_first(expert_data_, expert.tip_mm.size());
  show_path_until(0.0);
}

void ReplayMarks::show(const engine::Snapshot& snapshot) {
  loads_ = snapshot.loads;
  now_s_ = snapshot.time_s;
  place_arrows();
  if (path_->GetVisibility() != 0) show_path_until(now_s_);
}

void ReplayMarks::place_arrows() {
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    const double force = loads_[i].force_n.norm();
    const bool shown = with_arrows_ && loads_[i].contacts > 0 && force >= kSeenFrom_n;
    arrows_[i]->SetVisibility(shown);
    if (shown)  // the log has what the tissue does to the tool; a clinician asks what the blade does to the tissue
      arrows_[i]->SetUserMatrix(
          arrow_matrix(1000.0 * loads_[i].centre_m, -loads_[i].force_n / force, kArrowMmPerNewton * force));
  }
}

void ReplayMarks::show_path_until(double time_s) {
  path_points_ = static_cast<std::size_t>(
      std::upper_bound(path_time_s_.begin(), path_time_s_.end(), time_s + 1e-9) - path_time_s_.begin());
  draw_first(path_data_, path_points_);
}

void ReplayMarks::show_arrows(bool on) {
  with_arrows_ = on;
  place_arrows();
}

void ReplayMarks::show_path(bool on) {
  path_->SetVisibility(on);
  if (on) show_path_until(now_s_);
}

void ReplayMarks::show_expert(bool on) { expert_->SetVisibility(on && expert_data_->GetNumberOfPoints() > 1); }

int ReplayMarks::arrows_shown() const {
  return static_cast<int>(
      std::count_if(arrows_.begin(), arrows_.end(), [](const auto& arrow) { return arrow->GetVisibility() != 0; }));
}

}  // namespace vallecula::gui
