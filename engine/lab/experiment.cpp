#include "engine/lab/experiment.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "engine/mesh/soft_mesh.h"
#include "engine/mesh/triangle_bvh.h"
#include "engine/state.h"

namespace vallecula::engine {

namespace {

constexpr double kMissedS = 0.001;    // a force written later after it was due is a miss (DESIGN 4.5)
constexpr int kPenetrationParts = 4;  // a surface triangle is looked at in 15 points
constexpr double kNear = 0.001;       // m; nearer than this the distance is taken from the tool's triangles, exactly
constexpr double kReturnSpeed = 0.1;      // m/s: how fast a held tool follows a hand that has come back, at most
constexpr int kStiffnessWindow = 20;  // steps over which the contact's stiffness is taken

struct Penetration {
  double deepest = 0.0, vertex = 0.0;  // m; of any surface point, of a vertex
};

/// Points of the tissue's surface in the tool: vertices and a lattice in each triangle near it.
Penetration deepest_penetration(const Scene& scene, const TriangleBvh& surface, const Pose& tool,
                           const std::vector<Vec3>& nodes) {
  const Mat3 to_tool = tool.rotation.toRotationMatrix().transpose();
  Penetration found;
  for (const auto& t : scene.surface.triangles) {
    const Vec3 a = to_tool * (nodes[t[0]] - tool.position), b = to_tool * (nodes[t[1]] - tool.position),
               c = to_tool * (nodes[t[2]] - tool.position);
    const Vec3 centre = (a + b + c) / 3;
    const double reach = std::max({(a - centre).norm(), (b - centre).norm(), (c - centre).norm()});
    if (scene.tool.coarse.distance(centre) > reach + scene.tool.coarse.spacing()) continue;
    for (int i = 0; i <= kPenetrationParts; ++i)
      for (int j = 0; i + j <= kPenetrationParts; ++j) {
        const Vec3 p = a + (b - a) * (double(i) / kPenetrationParts) + (c - a) * (double(j) / kPenetrationParts);
        if (scene.tool.fine.distance(p) > kNear) continue;
        const double depth = -surface.signed_distance(p, kNear);
        found.deepest = std::max(found.deepest, depth);
        const bool vertex = (i == 0 && j == 0) || i == kPenetrationParts || j == kPenetrationParts;
        if (vertex) found.vertex = std::max(found.vertex, depth);
      }
  }
  return found;
}

/// Moves `from` towards `to` by at most `most` (m, and most * 10 in rad: a blade's length is about 0.1 m).
Pose approach(const Pose& from, const Pose& to, double most) {
  const double way = std::max((to.position - from.position).norm(), 0.1 * from.rotation.angularDistance(to.rotation));
  if (way <= most) return to;
  const double share = most / way;
  Pose pose;
  pose.position = from.position + share * (to.position - from.position);
  pose.rotation = from.rotation.slerp(share, to.rotation);
  return pose;
}

/// The device's limit without a coupling (DESIGN 4.4): the tool is at the device's pose until the tissue's force is
/// over the limit; then it stays at its last admissible pose until the trial force has fallen. The trial force is what
/// the tissue would answer with at the device's pose: the held force and the contact's stiffness, as last felt, over
/// the way the device has gone on.
class LimitedTool {
 public:
  LimitedTool(const ExperimentSettings& settings, double step_s, double body_size)
      : settings_(settings), step_s_(step_s), least_stiffness_(settings.force_limit_n / body_size) {}

  /// The tool's pose for this step.
  Pose next(const Pose& device) {
    if (first_) proxy_ = admissible_ = device;
    first_ = false;
    device_ = device;
    switch (state_) {
      case HapticState::tracking:
        proxy_ = device;
        break;
      case HapticState::limited:
      case HapticState::lost:
        proxy_ = admissible_;
        break;
      case HapticState::recovering:
        proxy_ = approach(proxy_, device, std::min(settings_.force_rate_n_s / stiffness_, kReturnSpeed) * step_s_);
        break;
    }
    return proxy_;
  }

  /// Judges the step by the force of the tissue on the tool; returns the force to display.
  Vec3 judge(const Vec3& force) {
    if (!std::isfinite(settings_.force_limit_n)) return force;
    const double size = force.norm(), limit = settings_.force_limit_n;
    time_in_state_ += step_s_;
    if (state_ == HapticState::tracking) feel(size);
    // Signed: a hand that has come back is let go by what it has come back, however hard the held tissue presses.
    const double beyond = size > 0 ? -(device_.position - proxy_.position).dot(force) / size : 0.0;
    const double trial = std::max(0.0, size + stiffness_ * beyond);
    switch (state_) {
      case HapticState::tracking:
        if (size > limit) enter(HapticState::limited);
        break;
      case HapticState::limited:
        if (trial < kLeaveShare * limit) {
          enter(HapticState::recovering);
        } else if (time_in_state_ > settings_.limit_time_s) {
          enter(HapticState::lost);
        }
        break;
      case HapticState::lost:
        if (trial < kLeaveShare * limit) enter(HapticState::recovering);
        break;
      case HapticState::recovering:
        // Both: folded tissue may hold a tool that is being drawn out, which is no pressing on.
        if (size > limit && trial > limit) {
          enter(HapticState::limited);
        } else if ((proxy_.position - device_.position).norm() == 0.0) {
          enter(HapticState::tracking);
        }
        break;
    }
    if (!proxy_held(state_)) admissible_ = proxy_;
    Vec3 wanted = state_ == HapticState::lost ? Vec3::Zero().eval() : force;
    if (wanted.norm() > limit) wanted *= limit / wanted.norm();
    const Vec3 change = wanted - displayed_;
    const double most = settings_.force_rate_n_s * step_s_;
    displayed_ = change.norm() > most ? Vec3(displayed_ + change * (most / change.norm())) : wanted;
    return displayed_;
  }

  HapticState state() const { return state_; }
  const Pose& proxy() const { return proxy_; }

 private:
  void enter(HapticState state) {
    state_ = state;
    time_in_state_ = 0.0;
  }
  /// The contact's stiffness on the way in, over the last steps.
  void feel(double size) {
    const int at = felt_++ % kStiffnessWindow;
    if (felt_ > kStiffnessWindow) {
      const double way = (proxy_.position - positions_[at]).norm();
      if (way > 1e-6 && size > sizes_[at]) stiffness_ = std::max(least_stiffness_, (size - sizes_[at]) / way);
    }
    positions_[at] = proxy_.position;
    sizes_[at] = size;
    stiffness_ = std::max(stiffness_, least_stiffness_);
  }

  const ExperimentSettings& settings_;
  double step_s_, least_stiffness_, stiffness_ = 1.0, time_in_state_ = 0.0;
  HapticState state_ = HapticState::tracking;
  Pose device_, proxy_, admissible_;
  Vec3 displayed_ = Vec3::Zero();
  bool first_ = true;
  int felt_ = 0;
  std::array<Vec3, kStiffnessWindow> positions_;
  std::array<double, kStiffnessWindow> sizes_{};
};

void sleep_until(double time) {
  timespec t{};
  t.tv_sec = static_cast<time_t>(time);
  t.tv_nsec = static_cast<long>((time - static_cast<double>(t.tv_sec)) * 1e9);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) != 0) {
  }
}

}  // namespace

ExperimentResult run_experiment(const Scene& scene, const std::function<Pose(double)>& pose,
                                const ExperimentSettings& settings,
                                const std::function<void(const ExperimentStep&, const std::vector<Vec3>&)>& each) {
  const double h = scene.model.step_s;
  const auto& tets = scene.description.soft.tets;
  const auto volume_of = [&](const std::vector<Vec3>& p, int& inverted) {
    double volume = 0.0;
    inverted = 0;
    for (const auto& k : tets) {
      const double v = tet_volume(p[k[0]], p[k[1]], p[k[2]], p[k[3]]);
      volume += v;
      inverted += v <= 0 ? 1 : 0;
    }
    return volume;
  };
  int none = 0;
  const double rest_volume = volume_of(scene.model.rest, none);
  Vec3 low = scene.model.rest.front(), high = low;
  for (const Vec3& p : scene.model.rest) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }

  const TriangleBvh tool_surface(scene.description.tool.surface);
  SceneState state(scene);
  LimitedTool tool(settings, h, (high - low).norm());
  ExperimentResult result;
  const std::int64_t count = static_cast<std::int64_t>(std::floor(settings.duration_s / h + 1e-6)) + 1;
  result.steps.reserve(static_cast<std::size_t>(count));
  result.final_nodes = scene.model.rest;
  state.placed = true;
  state.proxy.pose = pose(0.0);
  std::array<StructureLoad, kLoadedStructures> loads;
  const double began = monotonic_seconds() + 0.01;
  for (std::int64_t n = 0; n < count; ++n) {
    ExperimentStep s;
    s.time_s = static_cast<double>(n) * h;
    const double due = began + s.time_s;
    if (settings.realtime) sleep_until(due);
    const double start = thread_seconds(), began_s = monotonic_seconds();
    const Pose before = state.proxy.pose;
    state.proxy.pose = tool.next(pose(s.time_s));
    loads = {};
    s.solver_iterations = step_tissue(scene, state, before, loads, s.stages).iterations;
    s.model_force_n = state.tissue_wrench.force;
    for (const StructureLoad& load : loads) s.area_m2 += load.area_m2;
    s.force_n = tool.judge(s.model_force_n);
    s.torque_nm = state.tissue_wrench.torque;
    s.state = tool.state();
    s.elapsed_s = monotonic_seconds() - began_s;
    s.step_s = thread_seconds() - start;
    if (settings.realtime) {
      const double end = monotonic_seconds();
      s.late_s = std::max(0.0, end - due - h);
      if (end - due > kMissedS) ++result.deadline_misses;
    }
    s.proxy_m = tool.proxy().position;
    s.proxy_rotation = tool.proxy().rotation;
    s.stiffness_n_m = state.felt.feel(tool.proxy(), state.tissue_wrench);
    for (int c = 0; c < state.contacts.count; ++c) s.contacts += state.contacts.constraints[c].multiplier > 0 ? 1 : 0;
    double sum = s.model_force_n.sum() + s.torque_nm.sum();
    for (std::size_t i = 0; i < result.final_nodes.size(); ++i) {
      result.final_nodes[i] = scene.model.rest[i] + state.tissue.displacement[i];
      sum += result.final_nodes[i].sum();
    }
    s.finite = std::isfinite(sum) && std::abs(sum) < 1e12;
    if (s.finite && settings.measure_tissue) {
      s.volume_change = volume_of(result.final_nodes, s.inverted) / rest_volume - 1;
      const Penetration in = deepest_penetration(scene, tool_surface, state.proxy.pose, result.final_nodes);
      s.penetration_m = in.deepest;
      s.vertex_penetration_m = in.vertex;
    }
    if (s.state == HapticState::limited) result.time_limited_s += h;
    if (s.state == HapticState::lost) result.time_lost_s += h;
    result.limit_entered |= s.state == HapticState::limited;
    result.steps.push_back(s);
    if (!s.finite) {
      result.finite = false;
      break;
    }
    if (each) each(s, result.final_nodes);
  }
  if (settings.realtime) result.achieved_hz = static_cast<double>(result.steps.size()) / (monotonic_seconds() - began);
  for (std::size_t i = 0; result.finite && i < result.final_nodes.size(); ++i)
    result.residual_m = std::max(result.residual_m, (result.final_nodes[i] - scene.model.rest[i]).norm());
  return result;
}

}  // namespace vallecula::engine
