#include "gui/views/swept_surface.h"

#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

#include "gui/session/poly_data.h"

namespace vallecula::gui {
namespace {

engine::Quat nearer(engine::Quat q, const engine::Quat& to) {
  if (q.dot(to) < 0.0) q.coeffs() = -q.coeffs();
  return q;
}

engine::Quat mixed(const engine::Quat& a, const engine::Quat& b, double t) {
  engine::Quat q;
  q.coeffs() = (1.0 - t) * a.coeffs() + t * nearer(b, a).coeffs();
  q.normalize();
  return q;
}

}  // namespace

SweptAxis::SweptAxis(const std::array<engine::Vec3, engine::kTubeNodes>& nodes,
                     const std::array<engine::Quat, engine::kTubeSegments>& frames)
    : nodes_(nodes) {
  double length = 0.0;
  for (int i = 0; i + 1 < engine::kTubeNodes; ++i) length += (nodes[i + 1] - nodes[i]).norm();
  segment_ = std::max(1e-6, length / engine::kTubeSegments);
  frames_.front() = frames.front();
  frames_.back() = frames.back();
  for (int i = 1; i + 1 < engine::kTubeNodes; ++i) frames_[i] = mixed(frames[i - 1], frames[i], 0.5);
}

SweptAxis::Place SweptAxis::at(double from_tip_m) const {
  const double beyond = from_tip_m - length_m();
  if (beyond >= 0.0) {
    const engine::Mat3 axes = frames_.back().toRotationMatrix();
    return {nodes_.back() + beyond * axes.col(0), axes};
  }
  const double place = std::max(0.0, from_tip_m / segment_);
  const int i = std::min(static_cast<int>(place), engine::kTubeSegments - 1);
  const double t = place - i;
  // Hermite's curve between the nodes: 40 of them would be seen as a polygon.
  const engine::Vec3 from = segment_ * (frames_[i] * engine::Vec3::UnitX()),
                     to = segment_ * (frames_[i + 1] * engine::Vec3::UnitX());
  const double u = 1.0 - t;
  return {
      u * u * (1.0 + 2.0 * t) * nodes_[i] + t * t * (3.0 - 2.0 * t) * nodes_[i + 1] + u * u * t * from - t * t * u * to,
      mixed(frames_[i], frames_[i + 1], t).toRotationMatrix()};
}

SweptSurface::SweptSurface(std::vector<Point> points, const std::vector<std::array<int, 3>>& triangles)
    : points_(std::move(points)),
      normals_(vtkSmartPointer<vtkFloatArray>::New()),
      along_(vtkSmartPointer<vtkFloatArray>::New()) {
  std::vector<engine::Vec3> places;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("Texture");
  texture->SetNumberOfComponents(2);
  for (const Point& p : points_) {
    places.push_back(p.offset_m + p.from_tip_m * engine::Vec3::UnitX());
    texture->InsertNextTuple2(p.texture[0], p.texture[1]);
  }
  surface_ = poly_data(places, triangles, 1000.0);
  const auto count = static_cast<vtkIdType>(points_.size());
  normals_->SetName("Normals");
  along_->SetName(kAlongAxis);
  for (const auto& array : {normals_, along_}) {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(count);
    array->Fill(0.0);
  }
  surface_->GetPointData()->SetNormals(normals_);
  surface_->GetPointData()->AddArray(along_);
  surface_->GetPointData()->SetTCoords(texture);
}

SweptSurface SweptSurface::turned(const std::vector<std::array<double, 2>>& rings, int around) {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const auto& before = rings[r > 0 ? r - 1 : 0];
    const auto& after = rings[std::min(r + 1, rings.size() - 1)];
    const double rise = after[1] - before[1], run = after[0] - before[0], slope = std::max(1e-9, std::hypot(rise, run));
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * M_PI * k / around;
      const engine::Vec3 out(0.0, std::cos(angle), std::sin(angle));
      points.push_back({rings[r][0], rings[r][1] * out, (run * out - rise * engine::Vec3::UnitX()) / slope, {}});
      if (r == 0) continue;
      const int a = static_cast<int>(r) * around + k, b = static_cast<int>(r) * around + (k + 1) % around;
      triangles.push_back({a - around, b - around, a});
      triangles.push_back({b - around, b, a});
    }
  }
  return SweptSurface(std::move(points), triangles);
}

void SweptSurface::update(const SweptAxis& axis) {
  auto* out = surface_->GetPoints();
  double from_tip = 0.0;
  SweptAxis::Place place = axis.at(from_tip);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& p = points_[i];
    if (p.from_tip_m != from_tip) {  // the points of a ring follow each other
      from_tip = p.from_tip_m;
      place = axis.at(from_tip);
    }
    const engine::Vec3 at = 1000.0 * (place.at + place.axes * p.offset_m), normal = place.axes * p.normal;
    const auto id = static_cast<vtkIdType>(i);
    out->SetPoint(id, at.data());
    normals_->SetTuple(id, normal.data());
    along_->SetTuple(id, place.axes.col(0).eval().data());
  }
  out->Modified();
  normals_->Modified();
  along_->Modified();
  surface_->Modified();
}

}  // namespace vallecula::gui
