#include "gui/views/tool_look.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/session/placed_tool.h"
#include "gui/session/poly_data.h"

namespace vallecula::gui {
namespace {

struct Bounds {
  engine::Vec3 low = engine::Vec3::Constant(1e30), high = engine::Vec3::Constant(-1e30);
};

Bounds extent_mm(const engine::TriangleMesh& tool) {
  Bounds extent;
  for (const auto& p : tool.points) {
    extent.low = extent.low.cwiseMin(1000.0 * p);
    extent.high = extent.high.cwiseMax(1000.0 * p);
  }
  return extent;
}

constexpr double kBulbRadius = 0.45;          // mm
constexpr std::size_t kScanTriangles = 5000;  // the shipped blades have a thousand

/// The tool's section across its length at `x_mm`, as far as it belongs to the blade: no higher than the handle's foot.
Bounds section_mm(const engine::TriangleMesh& tool, double x_mm) {
  Bounds section;
  for (const auto& t : tool.triangles)
    for (int k = 0; k < 3; ++k) {
      const engine::Vec3 a = 1000.0 * tool.points[t[k]], b = 1000.0 * tool.points[t[(k + 1) % 3]];
      if ((a.x() < x_mm) == (b.x() < x_mm)) continue;
      const engine::Vec3 p = a + (x_mm - a.x()) / (b.x() - a.x()) * (b - a);
      if (p.z() > 1000.0 * kHandleStands) continue;
      section.low = section.low.cwiseMin(p);
      section.high = section.high.cwiseMax(p);
    }
  return section;
}

/// Height of the tool's lower face at this place of its length and width, mm; `otherwise` where there is none.
double underside_mm(const engine::TriangleMesh& tool, double x_mm, double y_mm, double otherwise) {
  double lowest = 1e30;
  for (const auto& t : tool.triangles) {
    const engine::Vec3 a = 1000.0 * tool.points[t[0]], ab = 1000.0 * tool.points[t[1]] - a,
                       ac = 1000.0 * tool.points[t[2]] - a;
    const double area = ab.x() * ac.y() - ab.y() * ac.x(), dx = x_mm - a.x(), dy = y_mm - a.y();
    if (std::abs(area) < 1e-12) continue;  // on edge
    const double s = (dx * ac.y() - dy * ac.x()) / area, r = (ab.x() * dy - ab.y() * dx) / area;
    if (s >= 0.0 && r >= 0.0 && s + r <= 1.0) lowest = std::min(lowest, a.z() + s * ab.z() + r * ac.z());
  }
  return lowest < 1e30 ? lowest : otherwise;
}

/// Where the blade ends and the handle stands: on top (+z) of the blade's last millimetres, in their middle.
engine::Vec3 heel_mm(const engine::TriangleMesh& tool) {
  const Bounds all = extent_mm(tool);
  const double from = all.high.x() - 0.10 * (all.high.x() - all.low.x());
  Bounds heel;
  for (const auto& p : tool.points)
    if (1000.0 * p.x() >= from) {
      heel.low = heel.low.cwiseMin(1000.0 * p);
      heel.high = heel.high.cwiseMax(1000.0 * p);
    }
  return {all.high.x(), 0.5 * (heel.low.y() + heel.high.y()), heel.high.z()};
}

/// A body of revolution about +z through `at`: radius and height pairs from below to above.
vtkSmartPointer<vtkPolyData> turned(const engine::Vec3& at, const std::vector<std::array<double, 2>>& profile) {
  constexpr int kAround = 40;
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& [radius, height] : profile)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / kAround;
      points->InsertNextPoint(at.x() + radius * std::cos(angle), at.y() + radius * std::sin(angle), at.z() + height);
    }
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring)
    for (int i = 0; i < kAround; ++i) {
      const vtkIdType a = static_cast<vtkIdType>(ring) * kAround + i,
                      b = static_cast<vtkIdType>(ring) * kAround + (i + 1) % kAround;
      const vtkIdType quad[4] = {a, b, b + kAround, a + kAround};
      cells->InsertNextCell(4, quad);
    }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  return result;
}

/// A box with round edges: a sphere pulled apart.
vtkSmartPointer<vtkPolyData> rounded_block(const engine::Vec3& centre, const engine::Vec3& half, double edge) {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(25);
  sphere->Update();
  vtkSmartPointer<vtkPolyData> block = sphere->GetOutput();
  for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i) {
    double p[3];
    block->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis) {
      const double flat = std::clamp(4.0 * p[axis], -1.0, 1.0);
      p[axis] = centre[axis] + (half[axis] - edge) * flat + edge * p[axis];
    }
    block->GetPoints()->SetPoint(i, p);
  }
  return block;
}

vtkSmartPointer<vtkPolyData> with_normals(vtkPolyData* input, double edge_degrees) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(input);
  normals->SetFeatureAngle(edge_degrees);
  normals->SplittingOn();
  normals->Update();
  return normals->GetOutput();
}

/// A scan's triangles are small and of all shapes: each corner's normal is the mean by area, and nothing is split.
void give_smooth_normals(const engine::TriangleMesh& tool, vtkPolyData* surface) {
  std::vector<engine::Vec3> sums(tool.points.size(), engine::Vec3::Zero());
  for (const auto& t : tool.triangles) {
    const engine::Vec3& a = tool.points[t[0]];
    const engine::Vec3 twice_area = (tool.points[t[1]] - a).cross(tool.points[t[2]] - a);
    for (const int v : t) sums[v] += twice_area;
  }
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (const auto& sum : sums) normals->InsertNextTuple(sum.normalized().eval().data());
  surface->GetPointData()->SetNormals(normals);
}

/// Steel shows the room: lamps and the dark between them, a bright ceiling, warm skin from below. A few lines instead
/// of an environment map; the mirrored point drifts across a flat face (`vertexVC` in it), as it does in a room of
/// finite size.
void make_metallic(vtkActor* actor, double strength) {
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true,
      "//VTK::Light::Impl\n"
      "  vec3 toEye = normalize(-vertexVC.xyz);\n"
      "  vec3 mirror = reflect(-toEye, normalVCVSOutput);\n"
      "  float height = mirror.y + 0.030 * vertexVC.y + 0.018 * vertexVC.x;\n"
      "  vec3 room = mix(vec3(0.36, 0.36, 0.38), vec3(0.84, 0.86, 0.90), 0.5 + 0.5 * sin(2.3 * height + 0.4));\n"
      "  room = mix(room, vec3(0.97, 0.98, 1.0), 0.6 * smoothstep(0.60, 1.2, mirror.y));\n"
      "  room = mix(room, vec3(0.66, 0.50, 0.47), 0.45 * smoothstep(-0.2, -0.9, mirror.z));\n"
      "  room += vec3(0.22) * smoothstep(0.86, 0.99, dot(mirror, normalize(vec3(-0.30, 0.45, 0.84))));\n"
      "  fragOutput0.rgb = mix(fragOutput0.rgb, room, " +
          std::to_string(strength) + ");\n",
      false);
}

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* surface) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

constexpr double kGhostApartM = 0.0005, kGhostTurnedRad = 3.0 * 3.14159265358979 / 180.0;

}  // namespace

vtkSmartPointer<vtkMatrix4x4> tool_matrix(const engine::Pose& pose) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const engine::Mat3 rotation = pose.rotation.toRotationMatrix();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, rotation(row, column));
    matrix->SetElement(row, 3, 1000.0 * pose.position[row]);
  }
  return matrix;
}

vtkSmartPointer<vtkPolyData> blade_surface(const engine::TriangleMesh& tool) {
  const auto mesh = poly_data(tool.points, tool.triangles, 1000.0);
  if (tool.triangles.size() < kScanTriangles) return with_normals(mesh, 35.0);
  give_smooth_normals(tool, mesh);
  return mesh;
}

vtkSmartPointer<vtkPolyData> handle_surface(const engine::TriangleMesh& tool) {
  if (has_handle(tool)) return vtkSmartPointer<vtkPolyData>::New();
  const Bounds extent = extent_mm(tool);
  const double blade = extent.high.x() - extent.low.x();
  const double radius = std::clamp(0.10 * blade, 7.0, 9.5), long_mm = std::clamp(1.2 * blade, 85.0, 120.0);
  engine::Vec3 foot = heel_mm(tool);
  foot.x() -= 0.35 * radius;
  std::vector<std::array<double, 2>> profile{{0.0, -1.0},          {0.42 * radius, -1.0}, {0.46 * radius, -0.2},
                                             {0.46 * radius, 9.0}, {0.60 * radius, 10.5}, {0.92 * radius, 11.5},
                                             {radius, 13.0},       {radius, 20.0},        {0.95 * radius, 21.0}};
  const double grip_from = 22.0, grip_to = long_mm - 9.0;
  for (double height = grip_from; height < grip_to; height += 3.2) {  // the rings the hand holds on to
    profile.push_back({0.95 * radius, height});
    profile.push_back({1.0 * radius, height + 0.7});
    profile.push_back({1.0 * radius, height + 1.9});
    profile.push_back({0.95 * radius, height + 2.6});
  }
  profile.insert(profile.end(),
                 {{radius, grip_to + 1.0}, {radius, long_mm - 2.0}, {0.85 * radius, long_mm}, {0.0, long_mm}});
  vtkNew<vtkAppendPolyData> whole;
  whole->AddInputData(with_normals(turned(foot, profile), 40.0));
  whole->AddInputData(
      rounded_block(foot + engine::Vec3(0.1 * radius, 0.0, 1.6), {0.70 * radius, 0.55 * radius, 2.0}, 1.0));
  whole->Update();
  return whole->GetOutput();
}

ToolLook::ToolLook(const engine::TriangleMesh& tool) {
  const auto blade = actor_of(blade_surface(tool));
  blade->GetProperty()->SetColor(0.80, 0.82, 0.85);
  blade->GetProperty()->SetAmbient(0.12);
  blade->GetProperty()->SetDiffuse(0.6);
  blade->GetProperty()->SetSpecular(0.9);
  blade->GetProperty()->SetSpecularPower(48.0);
  make_metallic(blade, 0.7);
  const auto handle = actor_of(handle_surface(tool));
  handle->GetProperty()->SetColor(0.55, 0.57, 0.61);
  handle->GetProperty()->SetAmbient(0.12);
  handle->GetProperty()->SetDiffuse(0.6);
  handle->GetProperty()->SetSpecular(0.6);
  handle->GetProperty()->SetSpecularPower(30.0);
  make_metallic(handle, 0.55);

  const Bounds extent = extent_mm(tool);
  const double blade_mm = extent.high.x() - extent.low.x();
  // On the operator's side of the blade, where it does not stand in the tongue, halfway to the patient's right.
  const double along = std::min(0.22 * blade_mm, 16.0);
  const Bounds section = section_mm(tool, along);
  bulb_ = {along, 0.5 * (section.high.y() + 0.5 * (section.low.y() + section.high.y())), section.low.z() - 0.6};
  camera_ = {along + 2.0, 0.5 * (section.low.y() + section.high.y()), section.low.z() - 2.0};
  extent_ = {blade_mm, 0.5 * (section.high.y() - section.low.y())};
  vtkNew<vtkSphereSource> ball;
  // Let into the blade's lower face. Its light is put a little lower, at the edge of the flange that hangs beside it (a
  // simplification: tissue is lit as if the flange were not there).
  ball->SetRadius(kBulbRadius);
  ball->SetCenter(bulb_.x(), bulb_.y(), underside_mm(tool, bulb_.x(), bulb_.y(), section.low.z()) - 0.3 * kBulbRadius);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(12);
  ball->Update();
  const auto bulb = actor_of(ball->GetOutput());
  bulb->GetProperty()->SetColor(1.0, 0.97, 0.86);
  bulb->GetProperty()->LightingOff();
  actors_ = {blade, handle, bulb};
}

void ToolLook::place(const engine::Pose& pose) {
  const auto matrix = tool_matrix(pose);
  for (const auto& actor : actors_) actor->SetUserMatrix(matrix);
  bulb_at_ = 1000.0 * pose.position + pose.rotation * (bulb_ - engine::Vec3(0, 0, 1.5));
  beam_ = pose.rotation * engine::Vec3(-1.0, 0.0, -0.05).normalized();
}

GhostLook::GhostLook(const engine::TriangleMesh& tool) {
  vtkNew<vtkAppendPolyData> whole;
  whole->AddInputData(blade_surface(tool));
  whole->AddInputData(handle_surface(tool));
  whole->Update();
  const auto ghost = actor_of(whole->GetOutput());
  ghost->GetProperty()->SetColor(0.62, 0.62, 0.64);
  ghost->GetProperty()->SetOpacity(0.38);
  ghost->GetProperty()->SetAmbient(0.5);
  ghost->GetProperty()->SetDiffuse(0.5);
  ghost->VisibilityOff();
  actors_ = {ghost};
}

bool GhostLook::place(const engine::Pose& device, const engine::Pose& proxy) {
  const bool apart = (device.position - proxy.position).norm() > kGhostApartM ||
                     device.rotation.angularDistance(proxy.rotation) > kGhostTurnedRad;
  const auto matrix = tool_matrix(device);
  for (const auto& actor : actors_) {
    actor->SetVisibility(apart);
    actor->SetUserMatrix(matrix);
  }
  return apart;
}

}  // namespace vallecula::gui
