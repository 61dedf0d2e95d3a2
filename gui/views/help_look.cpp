#include "gui/views/help_look.h"

#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkStripper.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <stdexcept>

#include "gui/views/patient_look.h"
#include "gui/views/theme.h"
#include "gui/views/tool_look.h"

namespace vallecula::gui {
namespace {

constexpr double kRestS = 1.5;    // between two rounds of the expert's way
constexpr double kLineMm = 0.35;  // half the outline's thickness
constexpr double kHidden = 0.30;  // opacity of what something lies before
// In front of all there is: VTK shifts a fragment's depth by 16e-6 of the whole range a unit.
constexpr double kBeforeAll = -66000.0;

}  // namespace

GhostPathLook::GhostPathLook(const engine::TriangleMesh& tool, device::Trajectory way)
    : way_(std::move(way)), actor_(vtkSmartPointer<vtkActor>::New()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(blade_surface(tool));
  mapper->ScalarVisibilityOff();
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetColor(0.78, 0.80, 0.84);
  actor_->GetProperty()->SetOpacity(0.34);
  actor_->GetProperty()->SetAmbient(0.6);
  actor_->GetProperty()->SetDiffuse(0.4);
  place(0.0);
}

void GhostPathLook::place(double time_s) {
  const double round_s = way_.end_s() - way_.start_s() + kRestS;
  const device::Keyframe at = way_.at(way_.start_s() + std::fmod(std::max(0.0, time_s), round_s));
  const auto& p = at.position_m;
  const auto& q = at.rotation_wxyz;
  actor_->SetUserMatrix(tool_matrix({{p[0], p[1], p[2]}, engine::Quat(q[0], q[1], q[2], q[3])}));
}

GlottisMark::GlottisMark(const pipeline::PatientPackage& package, const AnatomyMotion& motion) {
  const auto glottis = package.surfaces.find("glottis");
  if (glottis == package.surfaces.end() || glottis->second.triangles.empty())
    throw std::runtime_error("patient package " + package.name + " has no glottis to point out: import it again");
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(to_poly_data(glottis->second));
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  vtkNew<vtkStripper> joined;
  joined->SetInputConnection(edges->GetOutputPort());
  joined->JoinContiguousSegmentsOn();
  vtkNew<vtkTubeFilter> thick;
  thick->SetInputConnection(joined->GetOutputPort());
  thick->SetRadius(kLineMm * size_of(package));
  thick->SetNumberOfSides(8);
  thick->Update();
  line_ = thick->GetOutput();
  moving_.emplace(line_, motion, MovingSurface::Kind::solid);
  for (const bool hidden : {true, false}) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(line_);
    mapper->ScalarVisibilityOff();
    if (hidden) {
      mapper->SetResolveCoincidentTopologyToPolygonOffset();
      mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, kBeforeAll);
    }
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(theme::target().redF(), theme::target().greenF(), theme::target().blueF());
    actor->GetProperty()->LightingOff();
    if (hidden) actor->GetProperty()->SetOpacity(kHidden);
    actors_.push_back(actor);
  }
}

}  // namespace vallecula::gui
