#include "engine/contact/lips.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace vallecula::engine {

namespace {

constexpr double kMostStretch = 0.015;  // m: a lip drawn farther slips off the blade
constexpr double kReach = 0.03;         // m: a tool farther from the lips than this cannot hold them
constexpr double kAtRest = 1e-7;        // m
constexpr double kMostRate = 0.5;       // of a step's way back: more would overshoot

double cotangent(const Vec3& corner, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - corner, v = b - corner;
  return u.dot(v) / std::max(1e-15, u.cross(v).norm());
}

}  // namespace

Lips::Lips(const LipDescription& lips, const std::vector<SprungBody>& bodies, double step_s) {
  if (lips.surface.points.empty()) return;
  if (!(lips.bed_pa_m > 0) || !(lips.tension_n_m >= 0) || !(lips.recovery_s > 0))
    throw std::invalid_argument("lips: their bed's stiffness and recovery must be above 0, their tension not below");
  if (!lips.jaw_share.empty()) {
    if (lips.jaw_share.size() != lips.surface.points.size() || lips.jaw_body < 0 ||
        lips.jaw_body >= static_cast<int>(bodies.size()))
      throw std::invalid_argument("lips: a share of a jaw's motion is needed for each point, and the jaw itself");
    jaw_index_ = lips.jaw_body;
    jaw_ = bodies[static_cast<std::size_t>(lips.jaw_body)];
  }
  points_.resize(lips.surface.points.size());
  low_ = high_ = lips.surface.points.front();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    points_[i].rest = lips.surface.points[i];
    if (jaw_index_ >= 0) points_[i].jaw_share = lips.jaw_share[i];
    low_ = low_.cwiseMin(points_[i].rest);
    high_ = high_.cwiseMax(points_[i].rest);
  }
  // A third of each triangle's area rests on each corner; the tension acts by the cotangents, as in a soap film.
  std::map<std::pair<int, int>, double> ties;
  for (const auto& t : lips.surface.triangles) {
    const auto corner = [&](int k) -> const Vec3& { return lips.surface.points[t[k]]; };
    const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
    for (int k = 0; k < 3; ++k) {
      points_[t[k]].bed += lips.bed_pa_m * area / 3;
      const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      ties[{std::min(a, b), std::max(a, b)}] +=
          lips.tension_n_m / 2 * cotangent(corner(k), corner((k + 1) % 3), corner((k + 2) % 3));
    }
  }
  std::vector<std::vector<Tie>> of(points_.size());
  for (const auto& [ends, stiffness] : ties) {
    if (!(stiffness > 0)) continue;  // across obtuse corners: a tie that pushed would not be stable
    of[ends.first].push_back({ends.second, stiffness});
    of[ends.second].push_back({ends.first, stiffness});
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& p = points_[i];
    p.first = static_cast<int>(ties_.size());
    for (const Tie& tie : of[i]) {
      p.tie += tie.stiffness;
      ties_.push_back(tie);
    }
    p.last = static_cast<int>(ties_.size());
    if (p.bed > 0) p.rate = std::min(kMostRate, step_s * (p.bed + p.tie) / (lips.recovery_s * p.bed));
  }
}

void LipState::set_rest() noexcept {
  std::fill(displacement.begin(), displacement.end(), Vec3::Zero());
  wrench = Wrench{};
  stiffness.setZero();
  at_rest = true;
}

LipState Lips::make_state() const {
  LipState state;
  state.displacement.assign(points_.size(), Vec3::Zero());
  state.next = state.displacement;
  return state;
}

void Lips::step(const ToolField& tool, const Pose& pose, const std::vector<Vec3>& body_displacement,
                LipState& state) const noexcept {
  state.wrench = Wrench{};
  state.stiffness.setZero();
  if (points_.empty()) return;
  const Vec3 nearest = pose.position.cwiseMax(low_).cwiseMin(high_);
  const bool near = (nearest - pose.position).norm() < tool.radius + kReach;
  if (!near && state.at_rest) return;
  const Mat3 to_tool = pose.rotation.toRotationMatrix().transpose();
  // What pulls at a point: its bed, and its neighbours.
  const auto pull = [&](const Point& p, const std::vector<Vec3>& u, const Vec3& own) {
    Vec3 sum = -(p.bed + p.tie) * own;
    for (int k = p.first; k < p.last; ++k) sum += ties_[k].stiffness * u[ties_[k].to];
    return sum;
  };
  double most = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& p = points_[i];
    Vec3 u = state.displacement[i];
    if (p.bed + p.tie > 0) u += p.rate / (p.bed + p.tie) * pull(p, state.displacement, u);
    if (near) {
      Vec3 at = p.rest + u;
      if (p.jaw_share > 0) at += p.jaw_share * jaw_.way_of(p.rest, body_displacement[jaw_index_]);
      const Vec3 arm = at - pose.position;
      const SignedDistanceGrid::Sample s = tool.fine.sample(to_tool * arm);
      if (s.distance < 0 && s.gradient.squaredNorm() > 0.5) {
        const Vec3 n = to_tool.transpose() * s.gradient;  // out of the tool
        const Vec3 put = u - s.distance * n;
        if (put.norm() < kMostStretch) {
          u = put;
          const double held = -pull(p, state.displacement, u).dot(n);
          if (held > 0) {
            state.wrench.force -= held * n;
            state.wrench.torque -= arm.cross(held * n);
            Eigen::Matrix<double, 6, 1> direction;
            direction << n, arm.cross(n);
            state.stiffness += p.bed * direction * direction.transpose();
          }
        }
      }
    }
    state.next[i] = u;
    most = std::max(most, u.squaredNorm());
  }
  state.displacement.swap(state.next);
  state.at_rest = most < kAtRest * kAtRest;
  if (state.at_rest) std::fill(state.displacement.begin(), state.displacement.end(), Vec3::Zero());
}

}  // namespace vallecula::engine
