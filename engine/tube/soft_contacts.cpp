#include "engine/tube/soft_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/response.h"

namespace vallecula::engine {

namespace {

constexpr double kReach = 0.00012;    // m: contacts are set up this far ahead of touch, plus both sides' way in a tick
constexpr double kTouching = 0.0001;  // m: within it a point counts as in contact and keeps its side
constexpr double kLook = 0.003;       // m: parts of the tube farther from a cluster than this are not asked for in it
constexpr double kSameSide = 0.3;     // cosine between the kept side and the way to the axis
// What is met when it is deep already (the tube was changed, or came out of a canal) is met from where it is and
// pressed out by this much more a tick: no blow.
constexpr float kPressOut = 5e-6f;  // m
// Of what a surface node offers in a step (kContactAugmentation for the blade). Tube and tissue solve the spring in
// turns, so it holds the tissue back as a mass of stiffness times h^2 would; softer than this points sink in while they
// are moved.
constexpr float kStiffness = 2.0f;
constexpr float kStickStiffness = 100.0f;  // friction's share of the tissue's system is no stiffer than so many springs
constexpr float kCarriedShare = 0.05f;     // as the blade's contacts (tissue_contact.cpp)
constexpr float kLeak = 0.0025f;

/// A part of the tube's axis and the box of what it fills.
struct Segment {
  Vec3 from, way, low, high;
  double inverse_squared = 0.0;  // of its length, 1/m^2
  double first = 0.0;            // share of it where the tube begins
};

struct Tube {
  std::array<Segment, kTubeSegments> segment;
  int begin = 0;  // the first segment of which there is something
  double radius = 0.0;
  Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
};

Tube outside_part(const Rod& rod, const RodState& state, double outside_from_m) {
  Tube tube;
  tube.radius = rod.description().outer_radius_m;
  // The tip's half ball ends where the tube does.
  const double from = std::max(outside_from_m, std::min(tube.radius, rod.segment_m())) / rod.segment_m();
  tube.begin = static_cast<int>(std::min(from, double(kTubeSegments)));
  for (int j = tube.begin; j < kTubeSegments; ++j) {
    Segment& s = tube.segment[j];
    s.from = state.position[j];
    s.way = state.position[j + 1] - s.from;
    s.first = j == tube.begin ? from - j : 0.0;
    s.inverse_squared = 1.0 / std::max(s.way.squaredNorm(), 1e-18);
    s.low = s.from.cwiseMin(s.from + s.way).array() - tube.radius;
    s.high = s.from.cwiseMax(s.from + s.way).array() + tube.radius;
    tube.low = tube.low.cwiseMin(s.low);
    tube.high = tube.high.cwiseMax(s.high);
  }
  return tube;
}

/// Distance between two boxes, 0 where they overlap.
double distance_of_boxes(const Vec3& low_a, const Vec3& high_a, const Vec3& low_b, const Vec3& high_b) {
  return (low_a - high_b).cwiseMax(low_b - high_a).cwiseMax(0.0).norm();
}

Vec3 node_position(const TissueModel& model, const TissueState& tissue, int node) {
  return model.rest[node] + tissue.displacement[node];
}

Vec3 node_velocity(const TissueModel& model, const TissueState& tissue, int node) {
  const int body = model.anchor[node];
  return body < 0 ? tissue.velocity[node] : model.bodies[body].way_of(model.rest[node], tissue.body_velocity[body]);
}

bool finite(const RodState& tube) {
  double sum = 0.0;
  for (const Vec3& p : tube.position) sum += p.sum();
  return std::isfinite(sum);
}

/// How far any point of the tube moved since the last tick.
double way_of(const RodState& tube, const SoftContactState& state) {
  double most_squared = 0.0;
  for (int i = 0; i < kTubeNodes; ++i)
    most_squared = std::max(most_squared, (tube.position[i] - state.tube[i]).squaredNorm());
  return state.seen ? std::sqrt(most_squared) : 0.0;
}

/// Out of the tissue at a sphere's surface point, of any length: from its centre.
Vec3 outward(const Scene& scene, const TissueState& tissue, const InnerSphere& sphere, const Vec3& surface_point) {
  Vec3 centre = Vec3::Zero();
  const auto& tet = scene.description.soft.tets[sphere.tet];
  for (int k = 0; k < 4; ++k) centre += sphere.weight[k] * node_position(scene.model, tissue, tet[k]);
  return surface_point - centre;
}

/// Is the sphere's surface point in reach of the tube? Fills `contact` if it is, and keeps the point's memory true.
bool meet(const Scene& scene, const TissueState& tissue, const Tube& tube, const int* segments, int segment_count,
          double approach, std::int32_t index, SoftContactState& state, SoftContact& contact) {
  const InnerSphere& sphere = scene.tree.spheres[index];
  SoftContactMemory& memory = state.memory[index];
  Vec3 point = Vec3::Zero();
  const auto& triangle = scene.surface.triangles[sphere.triangle];
  for (int k = 0; k < 3; ++k) point += sphere.surface_weight[k] * node_position(scene.model, tissue, triangle[k]);
  double nearest_squared = 1e18;
  for (int n = 0; n < segment_count; ++n) {
    const Segment& s = tube.segment[segments[n]];
    const double t = std::clamp((point - s.from).dot(s.way) * s.inverse_squared, s.first, 1.0);
    const Vec3 axis = s.from + t * s.way;
    const double squared = (axis - point).squaredNorm();
    if (!(squared < nearest_squared)) continue;
    nearest_squared = squared;
    contact.segment = segments[n];
    contact.weight = t;
    contact.axis = axis;
  }
  if (!(nearest_squared < 1e18)) {  // the point is not finite
    memory = SoftContactMemory{};
    return false;
  }
  const double distance = std::sqrt(nearest_squared), reach = kReach + approach;
  double gap = distance - tube.radius;
  if (!(gap - sphere.standoff <= reach) && !(memory.touching && memory.multiplier > 0)) {
    memory = SoftContactMemory{};
    memory.next_check = state.travel + std::min(gap - sphere.standoff - kReach, kLook);
    return false;
  }
  const Vec3 to_axis = distance > 1e-9 ? ((contact.axis - point) / distance).eval() : memory.side;
  if (!memory.touching) {
    // The far side of a leaf thinner than the tube is no side to be met from.
    if (!(to_axis.dot(outward(scene, tissue, sphere, point)) > 0)) {
      memory = SoftContactMemory{};
      return false;
    }
    memory.side = to_axis;
    memory.let_in = static_cast<float>(std::max(0.0, sphere.standoff - gap - approach));
  } else if (to_axis.dot(memory.side) > kSameSide) {
    memory.side = to_axis;
  } else {
    gap = (contact.axis - point).dot(memory.side) - tube.radius;
  }
  gap -= sphere.standoff;
  memory.let_in = std::max(0.0f, std::min(memory.let_in, static_cast<float>(-gap)) - kPressOut);
  gap += memory.let_in;
  memory.touching = gap < kTouching || memory.multiplier > 0;
  contact.sphere = index;
  contact.gap = gap;
  contact.normal = memory.side;
  return true;
}

float stiffness_of(const Scene& scene, std::int32_t sphere) {
  return kStiffness / kContactAugmentation * scene.contact_stiffness * scene.tube_areas[sphere];
}

/// What a spring is pressed by at the start of the step, m: what it kept of earlier ticks counts as depth.
double pressed_depth(const Scene& scene, const SoftContactState& state, const SoftContact& at) {
  return state.memory[at.sphere].multiplier / stiffness_of(scene, at.sphere) - at.gap;
}

/// Of `count` found the `most` that are pressed deepest, again in the order of the spheres. The others forget what they
/// kept, so that the same ones stay chosen.
void keep_deepest(const Scene& scene, int count, int most, SoftContactState& state) {
  const auto begin = state.found.begin();
  std::nth_element(begin, begin + most, begin + count, [&](const SoftContact& a, const SoftContact& b) {
    const double depth_a = pressed_depth(scene, state, a), depth_b = pressed_depth(scene, state, b);
    return depth_a != depth_b ? depth_a > depth_b : a.sphere < b.sphere;
  });
  for (auto left = begin + most; left != begin + count; ++left) state.memory[left->sphere].multiplier = 0.0f;
  std::sort(begin, begin + most, [](const SoftContact& a, const SoftContact& b) { return a.sphere < b.sphere; });
}

}  // namespace

SoftContactState::SoftContactState(const Scene& scene)
    : memory(scene.tree.spheres.size()),
      found(scene.tree.spheres.size()),
      constraints(kMostSoftContacts),
      cluster_check(scene.tree.clusters.size(), 0.0) {
  tube.fill(Vec3::Zero());
}

void SoftContactState::forget() noexcept {
  std::fill(memory.begin(), memory.end(), SoftContactMemory{});
  std::fill(cluster_check.begin(), cluster_check.end(), 0.0);
  count = left_out = 0;
  travel = nothing_before = 0.0;
  seen = false;
}

int find_soft_contacts(const Scene& scene, const TissueState& tissue, const Rod& rod, const RodState& tube_state,
                       double outside_from_m, double friction, SoftContactState& state, RodContact* out,
                       int capacity) noexcept {
  state.count = state.left_out = 0;
  if (!finite(tube_state) || !std::isfinite(outside_from_m)) {
    state.forget();
    return 0;
  }
  const double approach = way_of(tube_state, state) + tissue.fastest_m;
  const Tube tube = outside_part(rod, tube_state, outside_from_m);
  if (!std::isfinite(approach) || tube.begin == kTubeSegments) {
    state.forget();
    return 0;
  }
  // What came out of a canal lies no farther from what was outside than it is long.
  state.travel += approach + std::max(0.0, state.outside_from_m - outside_from_m);
  state.tube = tube_state.position;
  state.outside_from_m = outside_from_m;
  state.seen = true;
  if (state.travel < state.nothing_before) return 0;
  const SphereTree& tree = scene.tree;

  double all_clear = 1e9;
  int found = 0;
  for (std::size_t n = 0; n < tree.clusters.size(); ++n) {
    if (state.travel < state.cluster_check[n]) {
      all_clear = std::min(all_clear, state.cluster_check[n] - state.travel);
      continue;
    }
    const SphereCluster& cluster = tree.clusters[n];
    Vec3 low = node_position(scene.model, tissue, tree.cluster_nodes[cluster.first_node]), high = low;
    for (int i = 1; i < cluster.node_count; ++i) {
      const Vec3 p = node_position(scene.model, tissue, tree.cluster_nodes[cluster.first_node + i]);
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    // How far the tube is from the cluster, and its segments that can be in reach before the cluster is looked at
    // again.
    double clear = distance_of_boxes(tube.low, tube.high, low, high) - kReach - approach;
    int near[kTubeSegments], near_count = 0;
    if (!(clear > 0)) {
      clear = 1e9;
      for (int j = tube.begin; j < kTubeSegments; ++j) {
        const Segment& s = tube.segment[j];
        const double away = distance_of_boxes(s.low, s.high, low, high) - kReach - approach;
        clear = std::min(clear, away);
        if (!(away > kLook)) near[near_count++] = j;
      }
    }
    if (clear > 0) {
      state.cluster_check[n] = state.travel + clear;
      all_clear = std::min(all_clear, clear);
      for (int s = cluster.first; s < cluster.first + cluster.count; ++s)
        if (state.memory[s].touching) state.memory[s] = SoftContactMemory{};
      continue;
    }
    all_clear = 0.0;
    for (int s = cluster.first; s < cluster.first + cluster.count; ++s) {
      if (scene.tube_areas[s] == 0.0f || state.travel < state.memory[s].next_check) continue;
      if (meet(scene, tissue, tube, near, near_count, approach, s, state, state.found[found])) ++found;
    }
  }
  state.nothing_before = state.travel + all_clear;

  const int most = std::clamp(capacity, 0, kMostSoftContacts);
  if (found > most) {
    keep_deepest(scene, found, most, state);
    state.left_out = found - most;
  }
  state.count = std::min(found, most);
  for (int i = 0; i < state.count; ++i) {
    const SoftContact& at = state.found[i];
    const InnerSphere& sphere = tree.spheres[at.sphere];
    RodContact& c = out[i];
    c = RodContact{};
    c.node = at.segment;
    c.weight = at.weight;
    c.normal = at.normal;
    c.stiffness_n_m = stiffness_of(scene, at.sphere);
    c.depth_m = pressed_depth(scene, state, at);
    c.friction = friction;
    const auto& triangle = scene.surface.triangles[sphere.triangle];
    for (int k = 0; k < 3; ++k)
      c.surface_velocity += sphere.surface_weight[k] * node_velocity(scene.model, tissue, triangle[k]);
  }
  return state.count;
}

void press_tissue(const Scene& scene, const RodState& tube, const RodContact* in, SoftContactState& state) noexcept {
  const double h = scene.model.step_s;
  for (int i = 0; i < state.count; ++i) {
    const SoftContact& at = state.found[i];
    const RodContact& r = in[i];
    const InnerSphere& sphere = scene.tree.spheres[at.sphere];
    ContactConstraint& c = state.constraints[i];
    c = ContactConstraint{};
    for (int k = 0; k < 4; ++k) {
      c.node[k] = scene.surface.triangles[sphere.triangle][std::min(k, 2)];
      c.weight[k] = k < 3 ? static_cast<float>(sphere.surface_weight[k]) : 0.0f;
    }
    const Vec3 axis = (1 - at.weight) * tube.position[at.segment] + at.weight * tube.position[at.segment + 1];
    const Vec3 way = axis - at.axis;
    c.normal = from_vec3(-at.normal);
    c.gap = static_cast<float>(at.gap + at.normal.dot(way));
    c.stiffness = static_cast<float>(r.stiffness_n_m);
    c.multiplier = state.memory[at.sphere].multiplier;
    c.triangle = sphere.triangle;
    c.active = c.multiplier > c.stiffness * c.gap;
    // The rod's friction is a damper on what it slips; the tissue takes the same force, and as it slips by more or less
    // than it was taken to, more or less of it.
    const Vec3 friction = r.force - r.force.dot(at.normal) * at.normal;
    const Vec3 over = way / h - r.surface_velocity, slip = over - over.dot(at.normal) * at.normal;
    const double speed = slip.norm();
    if (!c.active || !(speed > 0) || !(friction.squaredNorm() > 0)) continue;
    c.grip = std::min(static_cast<float>(friction.norm() / speed / h), kStickStiffness * c.stiffness);
    const Vec3 goes_on = h * (r.surface_velocity - r.surface_velocity.dot(at.normal) * at.normal);
    c.slip = from_vec3(friction / double(c.grip) - goes_on);
    c.friction_limit = std::numeric_limits<float>::max();  // the rod's step has kept it
    c.sticks = true;
  }
}

void keep_soft_contacts(SoftContactState& state) noexcept {
  for (int i = 0; i < state.count; ++i) {
    SoftContactMemory& memory = state.memory[state.found[i].sphere];
    memory.multiplier +=
        kCarriedShare * (state.constraints[i].multiplier - memory.multiplier) - kLeak * memory.multiplier;
  }
}

}  // namespace vallecula::engine
