#include "gui/views/soft_surface.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gui/session/poly_data.h"
#include "gui/session/soft_boundary.h"
#include "gui/views/tissue_colours.h"
#include "gui/views/tissue_shading.h"

namespace vallecula::gui {
namespace {

using Float3 = std::array<float, 3>;

Float3 minus(const Float3& a, const Float3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
float dot(const Float3& a, const Float3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Float3 cross(const Float3& a, const Float3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Float3 unit(const Float3& a) {
  const float length = std::sqrt(dot(a, a));
  return length > 1e-12f ? Float3{a[0] / length, a[1] / length, a[2] / length} : Float3{0, 0, 1};
}

constexpr float kRoundness = 0.7f;  // of Phong tessellation (Boubekeur and Alexa 2008 take 0.75)
constexpr double kPapillaMm = 1.6;  // grain of the tongue's velvet
constexpr double kPapillaTilt = 0.16;

}  // namespace

SoftSurface::SoftSurface(const pipeline::TetMesh& mesh, int levels) : SoftSurface(mesh, levels, nullptr) {}

SoftSurface::SoftSurface(const pipeline::TetMesh& mesh, const pipeline::Surface& fine) : SoftSurface(mesh, 0, &fine) {}

SoftSurface::SoftSurface(const pipeline::TetMesh& mesh, int levels, const pipeline::Surface* fine)
    : nodes_(mesh.points.size()) {
  SoftBoundary boundary = soft_boundary(mesh);
  node_of_ = std::move(boundary.node);
  triangles_ = std::move(boundary.triangles);
  std::vector<double> epiglottis(nodes_, 0.0), tets_at(nodes_, 0.0);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    for (int node : mesh.tets[i]) {
      tets_at[node] += 1.0;
      if (i < mesh.tissue.size() && mesh.tissue[i] == 1) epiglottis[node] += 1.0;
    }
  std::vector<double> pale;
  for (int node : node_of_) {
    pale.push_back(tets_at[node] > 0 ? epiglottis[node] / tets_at[node] : 0.0);
    const auto& p = mesh.points[node];
    points_.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }

  const auto* coarse = &triangles_;
  std::size_t count = points_.size();
  for (int level = 0; level < levels; ++level) {
    Level fine;
    std::map<std::array<int, 2>, int> middle;
    const auto split = [&](int a, int b) {
      const auto [found, fresh] = middle.emplace(std::array<int, 2>{std::min(a, b), std::max(a, b)},
                                                 static_cast<int>(count + fine.edges.size()));
      if (fresh) {
        fine.edges.push_back({a, b});
        pale.push_back(0.5 * (pale[a] + pale[b]));
      }
      return found->second;
    };
    for (const auto& t : *coarse) {
      const int ab = split(t[0], t[1]), bc = split(t[1], t[2]), ca = split(t[2], t[0]);
      fine.triangles.insert(fine.triangles.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    count += fine.edges.size();
    levels_.push_back(std::move(fine));
    coarse = &levels_.back().triangles;
  }
  shown_levels_ = levels_.size();
  points_.resize(count);
  if (fine != nullptr) {
    ties_ = tie_to_tets(mesh, fine->points);
    for (const auto& t : fine->triangles) {
      const int first = static_cast<int>(count);
      fine_.push_back({first + t[0], first + t[1], first + t[2]});
    }
    for (std::size_t i = 0; i < ties_.size(); ++i) {
      const auto& p = fine->points[i];
      points_.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
      double of_epiglottis = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto node = static_cast<std::size_t>(ties_[i].nodes[k]);
        of_epiglottis += ties_[i].shares[k] * (tets_at[node] > 0 ? epiglottis[node] / tets_at[node] : 0.0);
      }
      pale.push_back(std::clamp(of_epiglottis, 0.0, 1.0));
    }
    count += ties_.size();
    fine_shown_ = true;
    coarse = &fine_;
  }
  normals_.resize(count);
  bumps_.assign(count, {0, 0, 0});

  surface_ = vtkSmartPointer<vtkPolyData>::New();
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  surface_->SetPoints(points);
  surface_->SetPolys(cells_of(*coarse));
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(count));
  surface_->GetPointData()->SetNormals(normals);
  refine_and_publish();

  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetName("Colours");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<double, 3> p{points_[i][0], points_[i][1], points_[i][2]};
    Colour base{};
    for (int c = 0; c < 3; ++c) base[c] = (1.0 - pale[i]) * kTongueColour[c] + pale[i] * kEpiglottisColour[c];
    const Colour colour = mottled(base, p, 0.16 * (1.0 - 0.6 * pale[i]));
    for (int c = 0; c < 3; ++c) colours->SetComponent(static_cast<vtkIdType>(i), c, 255.0 * colour[c]);
    const auto slope = grain_slope(p, kPapillaMm);
    for (int c = 0; c < 3; ++c) bumps_[i][c] = static_cast<float>(kPapillaTilt * (1.0 - 0.8 * pale[i]) * slope[c]);
  }
  surface_->GetPointData()->SetScalars(colours);
  auto wet = vtkSmartPointer<vtkFloatArray>::New();
  wet->SetName(kWetness);
  wet->SetNumberOfComponents(2);
  wet->SetNumberOfTuples(static_cast<vtkIdType>(count));
  wet->Fill(1.0);
  surface_->GetPointData()->AddArray(wet);
  refine_and_publish();
}

void SoftSurface::shade(const Openness& openness) {
  auto* wet = vtkFloatArray::SafeDownCast(surface_->GetPointData()->GetArray(kWetness));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto& n = normals_[i];
    const double light = 0.35 + 0.65 * std::min(1.0, 1.4 * openness.at({points_[i][0], points_[i][1], points_[i][2]},
                                                                       {n[0], n[1], n[2]}));
    wet->SetComponent(static_cast<vtkIdType>(i), 1, light);
  }
  wet->Modified();
}

void SoftSurface::set_coarser(int levels) {
  if (!fine_.empty()) {
    if (fine_shown_ == (levels <= 0)) return;
    fine_shown_ = levels <= 0;
    surface_->SetPolys(cells_of(fine_shown_ ? fine_ : triangles_));
    refine_and_publish();
    return;
  }
  const auto left = levels_.size() - std::min(levels_.size(), static_cast<std::size_t>(std::max(0, levels)));
  if (left == shown_levels_) return;
  shown_levels_ = left;
  surface_->SetPolys(cells_of(left == 0 ? triangles_ : levels_[left - 1].triangles));
  refine_and_publish();
}

void SoftSurface::update(const std::vector<float>& soft_points_m) {
  if (soft_points_m.size() != 3 * nodes_) return;
  for (std::size_t i = 0; i < node_of_.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) points_[i][axis] = 1000.0f * soft_points_m[3 * node_of_[i] + axis];
  const std::size_t first = points_.size() - ties_.size();
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    Float3 at{0, 0, 0};
    for (std::size_t k = 0; k < 4; ++k) {
      const float* node = &soft_points_m[3 * static_cast<std::size_t>(ties_[i].nodes[k])];
      for (int axis = 0; axis < 3; ++axis) at[axis] += 1000.0f * ties_[i].shares[k] * node[axis];
    }
    points_[first + i] = at;
  }
  refine_and_publish();
}

void SoftSurface::compute_normals(const std::vector<std::array<int, 3>>& triangles, std::size_t points) {
  std::fill(normals_.begin(), normals_.begin() + static_cast<std::ptrdiff_t>(points), Float3{0, 0, 0});
  for (const auto& t : triangles) {
    const Float3 normal = cross(minus(points_[t[1]], points_[t[0]]), minus(points_[t[2]], points_[t[0]]));
    for (int corner : t)
      for (int axis = 0; axis < 3; ++axis) normals_[corner][axis] += normal[axis];
  }
  for (std::size_t i = 0; i < points; ++i) normals_[i] = unit(normals_[i]);
}

void SoftSurface::refine_and_publish() {
  std::size_t count = node_of_.size();
  if (fine_shown_) {
    count = points_.size();
    compute_normals(fine_, count);
  } else {
    compute_normals(triangles_, count);
  }
  for (std::size_t l = 0; l < shown_levels_; ++l) {
    const Level& level = levels_[l];
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
      const auto [a, b] = level.edges[e];
      const Float3 &pa = points_[a], &pb = points_[b], &na = normals_[a], &nb = normals_[b];
      const Float3 m{0.5f * (pa[0] + pb[0]), 0.5f * (pa[1] + pb[1]), 0.5f * (pa[2] + pb[2])};
      const float above_a = dot(minus(m, pa), na), above_b = dot(minus(m, pb), nb);
      for (int axis = 0; axis < 3; ++axis)
        points_[count + e][axis] = m[axis] - kRoundness * 0.5f * (above_a * na[axis] + above_b * nb[axis]);
    }
    count += level.edges.size();
    compute_normals(level.triangles, count);
  }
  auto* points = vtkFloatArray::SafeDownCast(surface_->GetPoints()->GetData());
  auto* normals = vtkFloatArray::SafeDownCast(surface_->GetPointData()->GetNormals());
  for (std::size_t i = 0; i < count; ++i) {
    const Float3& n = normals_[i];
    const Float3& bump = bumps_[i];
    const float along = dot(bump, n);
    const Float3 tilted =
        unit({n[0] - bump[0] + along * n[0], n[1] - bump[1] + along * n[1], n[2] - bump[2] + along * n[2]});
    points->SetTypedTuple(static_cast<vtkIdType>(i), points_[i].data());
    normals->SetTypedTuple(static_cast<vtkIdType>(i), tilted.data());
  }
  points->Modified();
  normals->Modified();
  surface_->GetPoints()->Modified();
  surface_->Modified();
}

vtkSmartPointer<vtkPolyData> SoftSurface::boundary() const {
  const auto end = points_.begin() + static_cast<std::ptrdiff_t>(node_of_.size());
  return poly_data(std::vector(points_.begin(), end), triangles_);
}

}  // namespace vallecula::gui
