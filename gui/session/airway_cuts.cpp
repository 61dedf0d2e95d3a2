#include "gui/session/airway_cuts.h"

#include <algorithm>

namespace vallecula::gui {

using engine::Vec3;

namespace {

constexpr double kForkShare = 1.3;  // of a cut's width over that of the one kForkBack before it: the lumen forks
constexpr std::size_t kForkBack = 4;

}  // namespace

Across::Across(const Vec3& way)
    : along(way.normalized()),
      left((Vec3::UnitX() - along.x() * along).normalized()),
      front(along.cross(left)) {}

std::optional<Cut> cut_at(const engine::TriangleMesh& mesh, const Vec3& point, const Across& frame) {
  std::optional<Cut> cut;
  std::vector<Outline> others;
  for (const auto& outline : plane_section(mesh, point, frame.along)) {
    const Outline one = measured(outline, frame.left, frame.front);
    // Of outlines within one another the innermost is the lumen about the point.
    if (holds(outline, point, frame.left, frame.front) && (!cut || one.area < cut->own.area))
      cut = Cut{one, {}};
    else
      others.push_back(one);
  }
  if (cut) cut->others = std::move(others);
  return cut;
}

Line::Line(std::vector<Vec3> points) : points_(std::move(points)) {
  lengths_.push_back(0.0);
  for (std::size_t i = 1; i < points_.size(); ++i)
    lengths_.push_back(lengths_.back() + (points_[i] - points_[i - 1]).norm());
}

Vec3 Line::at(double s) const {
  std::size_t i = 1;
  while (i + 1 < points_.size() && lengths_[i] < s) ++i;
  const double share = (s - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

Vec3 Line::along(double s, double about) const {
  const double low = std::max(0.0, s - about), high = std::min(length(), s + about);
  return (at(high) - at(low)).normalized();
}

Followed follow(const engine::TriangleMesh& mesh, const Vec3& start, Vec3 along, double step,
                const std::function<bool(const Vec3& at, const Vec3& along)>& goes_on) {
  Followed way{{start}};
  std::vector<Vec3>& centres = way.centres;
  std::vector<Outline> cuts;
  while (goes_on(centres.back(), along)) {
    const auto cut = cut_at(mesh, centres.back() + step * along, Across(along));
    if (!cut) break;
    const Outline& own = cut->own;
    if (!cuts.empty() && (own.area < kLeastShare * cuts.back().area || own.area > kMostShare * cuts.back().area)) break;
    way.forked = cuts.size() > 2 * kForkBack && own.half_left > kForkShare * cuts[cuts.size() - kForkBack].half_left;
    if (way.forked) break;
    along = (0.7 * along + 0.3 * (own.centre - centres.back()).normalized()).normalized();
    centres.push_back(own.centre);
    cuts.push_back(own);
  }
  return way;
}

std::vector<Vec3> smoothed(std::vector<Vec3> points) {
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<Vec3> old = points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) points[i] = 0.25 * old[i - 1] + 0.5 * old[i] + 0.25 * old[i + 1];
  }
  return points;
}

}  // namespace vallecula::gui
