#include "gui/views/heat_look.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "gui/session/poly_data.h"

namespace vallecula::gui {
namespace {

constexpr double kClearBelow = 0.01;
constexpr double kNearer = -300.0;  // 65000ths of the depth that is drawn: under a millimetre, just before the drawn skin

}  // namespace

std::array<unsigned char, 4> heat_colour(double share) {
  if (!(share >= kClearBelow)) return {0, 0, 0, 0};
  struct Stop {
    double at, red, green, blue, alpha;
  };
  constexpr Stop kStops[] = {{0.0, 255, 245, 170, 90},
                             {0.35, 240, 180, 50, 170},
                             {0.65, 213, 94, 0, 205},
                             {1.0, 70, 10, 90, 235}};
  const double s = std::clamp(share, 0.0, 1.0);
  int upper = 1;
  while (upper < 3 && s > kStops[upper].at) ++upper;
  const Stop &a = kStops[upper - 1], &b = kStops[upper];
  const double t = (s - a.at) / (b.at - a.at);
  const auto mixed = [&](double x, double y) { return static_cast<unsigned char>(std::lround(x + t * (y - x))); };
  return {mixed(a.red, b.red), mixed(a.green, b.green), mixed(a.blue, b.blue), mixed(a.alpha, b.alpha)};
}

HeatLook::HeatLook(const SoftBoundary& boundary) : boundary_(boundary) {
  surface_ = poly_data(std::vector<std::array<float, 3>>(boundary_.node.size()), boundary_.triangles);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Heat");
  colours->SetNumberOfComponents(4);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(boundary_.node.size()));
  colours->Fill(0);
  surface_->GetPointData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface_);
  mapper->SetColorModeToDirectScalars();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, kNearer);
  actor_ = vtkSmartPointer<vtkActor>::New();
  actor_->SetMapper(mapper);
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->BackfaceCullingOn();
  actor_->ForceTranslucentOn();
  actor_->PickableOff();
  actor_->VisibilityOff();
}

void HeatLook::show(const engine::Snapshot& snapshot, const std::vector<float>& kpa) {
  auto* points = vtkFloatArray::SafeDownCast(surface_->GetPoints()->GetData());
  auto* colours = vtkUnsignedCharArray::SafeDownCast(surface_->GetPointData()->GetScalars());
  for (std::size_t i = 0; i < boundary_.node.size(); ++i) {
    const float* p = snapshot.soft_points.data() + 3 * static_cast<std::size_t>(boundary_.node[i]);
    const float mm[3] = {1000.0f * p[0], 1000.0f * p[1], 1000.0f * p[2]};
    points->SetTypedTuple(static_cast<vtkIdType>(i), mm);
    colours->SetTypedTuple(static_cast<vtkIdType>(i), heat_colour(kpa[i] / kHeatTopKpa).data());
  }
  points->Modified();
  colours->Modified();
  surface_->GetPoints()->Modified();
  surface_->Modified();
}

}  // namespace vallecula::gui
