#include "engine/sight/line_of_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/posture.h"

namespace vallecula::engine {

namespace {

// A surface this close to a sample is the glottis' own rim, not something in front of it.
constexpr double kRim = 0.0005;  // m
// No anatomy comes farther than this across the line of sight by the bodies' motion: a jaw at its stop moves a gum by 10 mm.
constexpr double kComesNear = 0.015;  // m, at the glottis' distance from the eye

double cross2(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

}  // namespace

LineOfSight::LineOfSight(const SightDescription& sight, const std::vector<SprungBody>& bodies, int samples)
    : eye_(sight.eye) {
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
      if (inside) points_.push_back(centre + s * a + t * b);
    }
  if (points_.empty()) points_.push_back(centre);
  std::size_t occluding = 0;
  for (const TriangleMesh& mesh : sight.occluders) occluding += mesh.points.size();
  for (const SightDescription::Follower& f : sight.followers) {
    if (f.body < 0 || f.body >= static_cast<int>(bodies.size()))
      throw std::invalid_argument("sight: something follows body " + std::to_string(f.body) + ", which is not there");
    if (!f.point_share.empty() && f.point_share.size() != occluding)
      throw std::invalid_argument("sight: a follower has " + std::to_string(f.point_share.size()) +
                                  " shares; the occluders have " + std::to_string(occluding) + " points");
    followers_.push_back({bodies[static_cast<std::size_t>(f.body)], f.body, f.glottis_share, {}});
  }
  keep_occluders_near(sight);
}

/// Of the occluders only triangles that are before the glottis, or can come there, are looked at in a tick.
void LineOfSight::keep_occluders_near(const SightDescription& sight) {
  // As seen from the corners of where the eye can be: across the axis a point's picture goes as the eye does.
  std::array<Scratch, 4> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k].samples.resize(points_.size());
    look_from(kEyeMove * ((k & 1u) != 0 ? 1.0 : -1.0) * sight.eye_right +
                  kEyeMove * ((k & 2u) != 0 ? 1.0 : -1.0) * sight.eye_up,
              corners[k]);
    place_samples(corners[k], {});
  }
  std::size_t first = 0;
  for (const TriangleMesh& mesh : sight.occluders) {
    std::vector<int> kept(mesh.points.size(), -1);
    for (const auto& t : mesh.triangles) {
      bool left = true, right = true, below = true, above = true;  // of the glottis, from wherever it is looked at
      for (const Scratch& eye : corners) {
        const Vec3 a = project(mesh.points[t[0]], eye), b = project(mesh.points[t[1]], eye),
                   c = project(mesh.points[t[2]], eye);
        const auto [u0, u1] = std::minmax({a.x(), b.x(), c.x()});
        const auto [v0, v1] = std::minmax({a.y(), b.y(), c.y()});
        left = left && u1 < eye.low_u - kComesNear;
        right = right && u0 > eye.high_u + kComesNear;
        below = below && v1 < eye.low_v - kComesNear;
        above = above && v0 > eye.high_v + kComesNear;
      }
      if (left || right || below || above) continue;
      std::array<int, 3> own;
      for (int k = 0; k < 3; ++k) {
        int& place = kept[t[k]];
        if (place < 0) {
          place = static_cast<int>(occluders_.points.size());
          occluders_.points.push_back(mesh.points[t[k]]);
          for (std::size_t f = 0; f < followers_.size(); ++f)
            if (!sight.followers[f].point_share.empty())
              followers_[f].point_share.push_back(sight.followers[f].point_share[first + t[k]]);
        }
        own[k] = place;
      }
      occluders_.triangles.push_back(own);
    }
    first += mesh.points.size();
  }
}

Vec3 LineOfSight::sample_at(std::size_t i, const std::vector<Vec3>& body_displacement) const noexcept {
  Vec3 p = points_[i];
  for (const Follower& f : followers_)
    if (f.glottis_share > 0 && !body_displacement.empty())
      p += f.glottis_share * f.body.way_of(points_[i], body_displacement[f.index]);
  return p;
}

void LineOfSight::place_samples(Scratch& scratch, const std::vector<Vec3>& body_displacement) const noexcept {
  scratch.low_u = scratch.low_v = std::numeric_limits<double>::infinity();
  scratch.high_u = scratch.high_v = -scratch.low_u;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3 p = project(sample_at(i, body_displacement), scratch);
    scratch.samples[i] = p;
    scratch.low_u = std::min(scratch.low_u, p.x());
    scratch.high_u = std::max(scratch.high_u, p.x());
    scratch.low_v = std::min(scratch.low_v, p.y());
    scratch.high_v = std::max(scratch.high_v, p.y());
  }
}

void LineOfSight::look_from(const Vec3& eye_offset, Scratch& scratch) const noexcept {
  scratch.eye = eye_ + eye_offset;
  scratch.distance = distance_ - axis_.dot(eye_offset);
}

Vec3 LineOfSight::project(const Vec3& p, const Scratch& from) const noexcept {
  const Vec3 d = p - from.eye;
  const double depth = axis_.dot(d);
  if (!(depth > 1e-6)) return Vec3(0, 0, -1);
  const double scale = from.distance / depth;
  return Vec3(u_.dot(d) * scale, v_.dot(d) * scale, depth);
}

void LineOfSight::hide_behind(const Vec3& a, const Vec3& b, const Vec3& c, Scratch& scratch) const noexcept {
  if (a.z() < 0 || b.z() < 0 || c.z() < 0) return;
  const auto [u0, u1] = std::minmax({a.x(), b.x(), c.x()});
  const auto [v0, v1] = std::minmax({a.y(), b.y(), c.y()});
  if (u1 < scratch.low_u || u0 > scratch.high_u || v1 < scratch.low_v || v0 > scratch.high_v) return;
  const double area = cross2(b.x() - a.x(), b.y() - a.y(), c.x() - a.x(), c.y() - a.y());
  if (area == 0 || !std::isfinite(area)) return;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (scratch.hidden[i]) continue;
    const Vec3& p = scratch.samples[i];
    // Most points lie beside the triangle, and the sides' signs say so without a division.
    const double side_a = cross2(b.x() - p.x(), b.y() - p.y(), c.x() - p.x(), c.y() - p.y());
    if (area > 0 ? side_a < 0 : side_a > 0) continue;
    const double side_b = cross2(c.x() - p.x(), c.y() - p.y(), a.x() - p.x(), a.y() - p.y());
    if (area > 0 ? side_b < 0 : side_b > 0) continue;
    const double wa = side_a / area, wb = side_b / area, wc = 1 - wa - wb;
    if (wc < 0) continue;
    // 1/depth is what interpolates linearly in the picture.
    const double depth = 1 / (wa / a.z() + wb / b.z() + wc / c.z());
    if (depth < p.z() - kRim) scratch.hidden[i] = 1;
  }
}

LineOfSight::Scratch LineOfSight::make_scratch(std::size_t most_points) const {
  Scratch scratch;
  scratch.hidden.resize(points_.size());
  scratch.samples.resize(points_.size());
  scratch.projected.resize(std::max(most_points, occluders_.points.size()));
  return scratch;
}

void LineOfSight::begin(Scratch& scratch, const std::vector<Vec3>& body_displacement,
                        const Vec3& eye_offset) const noexcept {
  look_from(eye_offset.allFinite() ? eye_offset : Vec3(Vec3::Zero()), scratch);
  std::fill(scratch.hidden.begin(), scratch.hidden.end(), 0);
  place_samples(scratch, body_displacement);
  add(scratch, static_cast<int>(occluders_.points.size()), occluders_.triangles, [&](int i) -> Vec3 {
    const Vec3& rest = occluders_.points[i];
    Vec3 p = rest;
    for (const Follower& f : followers_)
      if (!f.point_share.empty() && f.point_share[i] > 0 && !body_displacement.empty())
        p += f.point_share[i] * f.body.way_of(rest, body_displacement[f.index]);
    return p;
  });
}

void LineOfSight::hide_below(Scratch& scratch, const std::vector<Vec3>& body_displacement, const Vec3& up,
                             double height) const noexcept {
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (up.dot(sample_at(i, body_displacement)) < height) scratch.hidden[i] = 1;
}

double LineOfSight::visible(const Scratch& scratch) const noexcept {
  if (points_.empty()) return 0.0;
  const auto hidden = std::count(scratch.hidden.begin(), scratch.hidden.end(), 1);
  return 1.0 - static_cast<double>(hidden) / static_cast<double>(points_.size());
}

double LineOfSight::unobstructed() const {
  if (points_.empty()) return 0.0;
  Scratch scratch = make_scratch(0);
  begin(scratch, {});
  return visible(scratch);
}

}  // namespace vallecula::engine
