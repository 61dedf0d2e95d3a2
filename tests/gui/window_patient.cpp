#include "tests/gui/window_patient.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vallecula::gui::window_test {
namespace {

using pipeline::Point;

double capsule(const Point& p, const Point& a, const Point& b, double ra, double rb, double wide = 1.0) {
  const Point ab{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, ap{(p[0] - a[0]) / wide, p[1] - a[1], p[2] - a[2]};
  const double t = std::clamp(
      (ap[0] * ab[0] + ap[1] * ab[1] + ap[2] * ab[2]) / (ab[0] * ab[0] + ab[1] * ab[1] + ab[2] * ab[2]), 0.0, 1.0);
  return std::sqrt(std::pow(ap[0] - t * ab[0], 2) + std::pow(ap[1] - t * ab[1], 2) + std::pow(ap[2] - t * ab[2], 2)) -
         (ra + t * (rb - ra));
}

double both(double a, double b, double soft) {  // smooth union
  const double h = std::clamp(0.5 + 0.5 * (b - a) / soft, 0.0, 1.0);
  return b + h * (a - b) - soft * h * (1.0 - h);
}

double head(const Point& p) {
  double d = capsule(p, {0, 42, 40}, {0, 55, 45}, 46, 48);
  d = both(d, capsule(p, {0, 18, 8}, {0, 22, -18}, 26, 24, 1.25), 14);
  d = both(d, capsule(p, {0, 35, -40}, {0, 45, -75}, 28, 28), 12);
  d = both(d, capsule(p, {0, -2, 17}, {0, 2, 26}, 4.5, 3), 5);
  d = both(d, capsule(p, {0, 5, -34}, {0, 8, -34}, 8, 8, 1.4), 8);
  d = both(d, capsule(p, {-8, 1, 4}, {8, 1, 4}, 4.5, 4.5), 4);
  return both(d, capsule(p, {-8, 0, -25}, {8, 0, -25}, 4.5, 4.5), 4);
}

double cavity(const Point& p) {
  double d = capsule(p, {0, -12, -8}, {0, 12, -7}, 13, 13, 1.3);
  d = both(d, capsule(p, {0, 12, -7}, {0, 34, -22}, 13, 10, 1.2), 3);
  d = both(d, capsule(p, {0, 34, -22}, {0, 36, -43}, 8, 5), 3);
  d = std::min(d, capsule(p, {0, 36, -43}, {0, 34, -52}, 5, 3.5));
  return std::min(d, capsule(p, {0, 34, -52}, {0, 47.6, -95.8}, 3.5, 3.5));
}

double tongue(const Point& p) {
  return both(capsule(p, {0, 10, -22}, {0, 18, -27}, 4.5, 8, 1.6), capsule(p, {0, 18, -27}, {0, 23, -33}, 8, 8, 1.6),
              3);
}

double epiglottis(const Point& p) { return capsule(p, {0, 28, -42}, {0, 36, -35}, 1.4, 1.0, 3.0); }
double soft(const Point& p) { return both(tongue(p), epiglottis(p), 1.5); }

template <class Distance>
pipeline::Surface surface_of(Distance distance, double step) {
  const int nx = static_cast<int>(110 / step), ny = static_cast<int>(150 / step), nz = static_cast<int>(210 / step);
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(nx, ny, nz);
  grid->SetSpacing(step, step, step);
  grid->SetOrigin(-0.5 * step * (nx - 1), -25, -105);
  grid->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(grid->GetScalarPointer());
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        double p[3];
        grid->GetPoint((static_cast<vtkIdType>(k) * ny + j) * nx + i, p);
        const bool rim = i == 0 || j == 0 || k == 0 || i == nx - 1 || j == ny - 1 || k == nz - 1;
        *value++ = rim ? 10.0f : static_cast<float>(distance(Point{p[0], p[1], p[2]}));
      }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->Update();
  pipeline::Surface surface;
  auto* mesh = contour->GetOutput();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    Point p;
    mesh->GetPoint(i, p.data());
    surface.points.push_back(p);
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i) {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(i, ids);
    std::array<int, 3> t{static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)),
                         static_cast<int>(ids->GetId(2))};
    // Outward: the distance grows along the normal.
    const Point &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) + 1e-12;
    const Point m{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
    const auto at = [&](double s) {
      return distance(Point{m[0] + s * n[0] / size, m[1] + s * n[1] / size, m[2] + s * n[2] / size});
    };
    if (at(0.3) < at(-0.3)) std::swap(t[1], t[2]);
    surface.triangles.push_back(t);
  }
  return surface;
}

pipeline::TetMesh tets_of_soft(double step) {
  pipeline::TetMesh mesh;
  std::map<std::array<int, 3>, int> node;
  const auto number = [&](int i, int j, int k) {
    const auto [found, fresh] = node.emplace(std::array<int, 3>{i, j, k}, static_cast<int>(mesh.points.size()));
    if (fresh) mesh.points.push_back({i * step, j * step, k * step});
    return found->second;
  };
  const int from_x = -18, to_x = 18, from_y = 0, to_y = 32, from_z = -40, to_z = -10;
  for (int k = from_z; k < to_z; ++k)
    for (int j = from_y; j < to_y; ++j)
      for (int i = from_x; i < to_x; ++i) {
        const Point centre{(i + 0.5) * step, (j + 0.5) * step, (k + 0.5) * step};
        if (soft(centre) > 0.0) continue;
        int c[8];
        for (int corner = 0; corner < 8; ++corner)
          c[corner] = number(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2 & 1));
        // Kuhn: six tetrahedra around the diagonal 0-7, alike in every cube, so neighbours fit.
        const int ways[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
        for (const auto& way : ways) {
          mesh.tets.push_back({c[0], c[way[0]], c[way[1]], c[7]});
          mesh.tissue.push_back(epiglottis(centre) < tongue(centre) ? 1 : 0);
        }
      }
  mesh.anchor.assign(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point& p = mesh.points[i];
    if (cavity(p) < 0.0) continue;
    const double to_hyoid = std::hypot(p[0], std::hypot(p[1] - 22.5, p[2] + 41.5));
    mesh.anchor[i] = static_cast<std::uint8_t>(to_hyoid < 9.0 ? pipeline::Anchor::hyoid
                                               : p[2] < -43.0 ? pipeline::Anchor::larynx
                                                              : pipeline::Anchor::mandible);
  }
  return mesh;
}

}  // namespace

pipeline::PatientPackage coarse_patient() {
  pipeline::PatientPackage package;
  package.name = "coarse";
  package.landmarks = {{"upper_gum_midline", {0, 0, 0}},       {"lower_gum_midline", {0, 4, -22}},
                       {"vallecula", {0, 28.5, -40}},          {"glottis_centre", {0, 34.5, -49}},
                       {"glottis_normal", {0, -0.259, 0.966}}, {"carina", {0, 47.6, -95.8}},
                       {"operator_eye", {0, -225, 232}},       {"hyoid", {0, 22.5, -41.5}},
                       {"epiglottis_tip", {0, 36.5, -34.8}},   {"condyle_axis", {0, 46.7, -6.3}}};
  package.materials = {{"tongue", {6000, 0.45, 1040}}, {"epiglottis", {1e5, 0.45, 1080}}};
  package.tongue = tets_of_soft(1.6);
  const auto walls = [](const Point& p) { return std::max(head(p), -std::min(cavity(p), soft(p))); };
  auto face = surface_of(walls, 1.4);
  for (const auto& t : face.triangles) {
    const Point& p = face.points[t[0]];
    const double mouth = std::hypot(p[0] / 1.45, p[2] + 10);
    auto tissue = pipeline::Tissue::skin;
    if (cavity(p) < 0.9 && p[1] > -1.0)
      tissue = p[2] < -42              ? pipeline::Tissue::larynx
               : p[2] > -3 && p[1] < 5 ? pipeline::Tissue::gum
                                       : pipeline::Tissue::mucosa;
    else if (mouth < 16 && p[1] < 3)
      tissue = pipeline::Tissue::lip;
    face.tissue.push_back(static_cast<std::uint8_t>(tissue));
  }
  package.surfaces["face"] = face;
  package.surfaces["airway"] = surface_of(
      [](const Point& p) {
        return std::max({cavity(p), -soft(p), -(p[1] + 4.0)});
      },
      1.0);
  pipeline::Surface glottis;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * 3.14159265 * i / 16;
    glottis.points.push_back({2.0 * std::cos(angle), 34.5 + 2.4 * std::sin(angle), -49.0 + 0.65 * std::sin(angle)});
    if (i >= 2) glottis.triangles.push_back({0, i - 1, i});
  }
  package.surfaces["glottis"] = glottis;
  const auto bone = surface_of([](const Point& p) { return capsule(p, {-10, 12, 5}, {10, 12, 5}, 3, 3); }, 1.4);
  package.surfaces["palate"] = bone;
  const auto chin = surface_of([](const Point& p) { return capsule(p, {-8, 4, -32}, {8, 4, -32}, 3.5, 3.5); }, 1.4);
  package.surfaces["mandible"] = chin;
  return package;
}

engine::TriangleMesh plain_blade() {
  engine::TriangleMesh blade;
  for (int corner = 0; corner < 8; ++corner)
    blade.points.push_back({corner & 1 ? 0.080 : 0.0, corner & 2 ? 0.005 : -0.005, corner & 4 ? 0.001 : -0.001});
  blade.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return blade;
}

engine::Snapshot lifted_snapshot(const pipeline::PatientPackage& package, double into, double lift_mm) {
  engine::Snapshot snapshot;
  snapshot.step = 1000;
  snapshot.ticks = 1000;
  snapshot.time_s = 1.0;
  const engine::Vec3 lift(0.0, -0.788, -0.616);
  for (const auto& p : package.tongue.points) {
    // Free at the dorsum, held at the floor.
    const double share = std::clamp((p[2] + 42.0) / 16.0, 0.1, 1.0);
    for (int axis = 0; axis < 3; ++axis)
      snapshot.soft_points.push_back(static_cast<float>(1e-3 * (p[axis] + share * lift_mm * lift[axis])));
  }
  const engine::Vec3 outside(-0.004, -0.045, 0.040), inside(-0.001, 0.0285, -0.038);
  engine::Mat3 axes;  // along the blade to the handle: up and out of the mouth; +z: the lift
  const engine::Vec3 z = lift, x = (outside - inside - (outside - inside).dot(z) * z).normalized();
  axes.col(0) = x;
  axes.col(2) = z;
  axes.col(1) = z.cross(x);
  snapshot.proxy_pose.rotation = engine::Quat(axes);
  snapshot.proxy_pose.position = outside + into * (inside - outside) + 1e-3 * lift_mm * lift;
  snapshot.device_pose = snapshot.proxy_pose;
  return snapshot;
}

}  // namespace vallecula::gui::window_test
