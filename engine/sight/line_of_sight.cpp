#include "engine/sight/line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace vallecula::engine {

namespace {

// A surface this close to a sample is the glottis' own rim, not something in front of it.
constexpr double kRim = 0.0005;  // m

double cross2(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

}  // namespace

LineOfSight::LineOfSight(const SightDescription& sight, int samples) : eye_(sight.eye) {
  const auto& outline = sight.glottis_outline;
  if (outline.empty()) return;  // nothing to be seen: the laboratory's scenes
  Vec3 centre = Vec3::Zero(), normal = Vec3::Zero();
  for (const Vec3& p : outline) centre += p / static_cast<double>(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
    normal += (outline[i] - centre).cross(outline[(i + 1) % outline.size()] - centre) / 2;
  const double area = normal.norm();
  if (outline.size() < 3 || !(area > 1e-9))
    throw std::invalid_argument("glottis: its outline has no area (" + std::to_string(outline.size()) + " points)");
  axis_ = (centre - eye_).normalized();
  distance_ = (centre - eye_).norm();
  u_ = axis_.unitOrthogonal();
  v_ = axis_.cross(u_);

  // An even lattice in the opening's own plane, so that the fraction is one of area.
  const Vec3 n = normal / area, a = n.unitOrthogonal(), b = n.cross(a);
  std::vector<std::pair<double, double>> polygon;
  double low_a = 1e9, high_a = -1e9, low_b = 1e9, high_b = -1e9;
  for (const Vec3& p : outline) {
    polygon.emplace_back(a.dot(p - centre), b.dot(p - centre));
    low_a = std::min(low_a, polygon.back().first);
    high_a = std::max(high_a, polygon.back().first);
    low_b = std::min(low_b, polygon.back().second);
    high_b = std::max(high_b, polygon.back().second);
  }
  const double spacing = std::sqrt(area / samples);
  for (double s = low_a + spacing / 2; s < high_a; s += spacing)
    for (double t = low_b + spacing / 2; t < high_b; t += spacing) {
      bool inside = false;
      for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const auto [ax, ay] = polygon[i];
        const auto [bx, by] = polygon[j];
        if ((ay > t) != (by > t) && s < (bx - ax) * (t - ay) / (by - ay) + ax) inside = !inside;
      }
      if (inside) points_.push_back(project(centre + s * a + t * b));
    }
  if (points_.empty()) points_.push_back(project(centre));
  low_u_ = low_v_ = std::numeric_limits<double>::infinity();
  high_u_ = high_v_ = -low_u_;
  for (const Vec3& p : points_) {
    low_u_ = std::min(low_u_, p.x());
    high_u_ = std::max(high_u_, p.x());
    low_v_ = std::min(low_v_, p.y());
    high_v_ = std::max(high_v_, p.y());
  }
  hidden_by_fixed_.assign(points_.size(), 0);
  for (const TriangleMesh& mesh : sight.occluders) {
    std::vector<Vec3> projected;
    for (const Vec3& p : mesh.points) projected.push_back(project(p));
    for (const auto& t : mesh.triangles) hide_behind(projected[t[0]], projected[t[1]], projected[t[2]], hidden_by_fixed_);
  }
}

Vec3 LineOfSight::project(const Vec3& p) const noexcept {
  const Vec3 d = p - eye_;
  const double depth = axis_.dot(d);
  if (!(depth > 1e-6)) return Vec3(0, 0, -1);
  const double scale = distance_ / depth;
  return Vec3(u_.dot(d) * scale, v_.dot(d) * scale, depth);
}

void LineOfSight::hide_behind(const Vec3& a, const Vec3& b, const Vec3& c, std::vector<char>& hidden) const noexcept {
  if (a.z() < 0 || b.z() < 0 || c.z() < 0) return;
  const auto [u0, u1] = std::minmax({a.x(), b.x(), c.x()});
  const auto [v0, v1] = std::minmax({a.y(), b.y(), c.y()});
  if (u1 < low_u_ || u0 > high_u_ || v1 < low_v_ || v0 > high_v_) return;
  const double area = cross2(b.x() - a.x(), b.y() - a.y(), c.x() - a.x(), c.y() - a.y());
  if (area == 0 || !std::isfinite(area)) return;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (hidden[i]) continue;
    const Vec3& p = points_[i];
    const double wa = cross2(b.x() - p.x(), b.y() - p.y(), c.x() - p.x(), c.y() - p.y()) / area;
    const double wb = cross2(c.x() - p.x(), c.y() - p.y(), a.x() - p.x(), a.y() - p.y()) / area;
    const double wc = 1 - wa - wb;
    if (wa < 0 || wb < 0 || wc < 0) continue;
    // 1/depth is what interpolates linearly in the picture.
    const double depth = 1 / (wa / a.z() + wb / b.z() + wc / c.z());
    if (depth < p.z() - kRim) hidden[i] = 1;
  }
}

LineOfSight::Scratch LineOfSight::make_scratch(std::size_t most_points) const {
  Scratch scratch;
  scratch.hidden = hidden_by_fixed_;
  scratch.projected.resize(most_points);
  return scratch;
}

void LineOfSight::begin(Scratch& scratch) const noexcept {
  std::copy(hidden_by_fixed_.begin(), hidden_by_fixed_.end(), scratch.hidden.begin());
}

double LineOfSight::visible(const Scratch& scratch) const noexcept {
  if (points_.empty()) return 0.0;
  const auto hidden = std::count(scratch.hidden.begin(), scratch.hidden.end(), 1);
  return 1.0 - static_cast<double>(hidden) / static_cast<double>(points_.size());
}

double LineOfSight::unobstructed() const {
  if (points_.empty()) return 0.0;
  const auto hidden = std::count(hidden_by_fixed_.begin(), hidden_by_fixed_.end(), 1);
  return 1.0 - static_cast<double>(hidden) / static_cast<double>(points_.size());
}

}  // namespace vallecula::engine
