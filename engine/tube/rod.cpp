#include "engine/tube/rod.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/tube/banded_solver.h"

namespace vallecula::engine {

namespace {

constexpr int kMostIterations = 5;             // Newton's; two do unless contacts or friction change
constexpr double kConverged = 1e-8;            // m, and a hundred times as many rad
constexpr double kFastest = 5.0;               // m/s: whatever the hand does, nodes move no faster
constexpr double kMostTurn = 0.5;              // rad an iteration
constexpr double kMostPull = 0.03;             // m: the grip's spring pulls no harder than at this length
constexpr double kMostContactForce = 200;      // N
constexpr double kMostContactStiffness = 1e6;  // N/m
constexpr double kStickSpeed = 1e-4;           // m/s: below it friction is a damper, above it mu times the normal force

using System = BandedSystem<kTubeNodes + kTubeSegments>;  // x0, w0, x1, w1, ... x39
constexpr int place_of(int node) { return 2 * node; }
constexpr int turn_of(int segment) { return 2 * segment + 1; }

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// The nearer of the two quaternions of a turn.
Quat nearer(Quat q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return q;
}

/// Turn across a joint. Twice its vector is the measure of strain: 2 sin(angle / 2), which needs no trigonometry and
/// has no singularity; 0.3 % below the angle itself at a bend of 15 mm radius.
Quat turn_across(const RodState& s, int joint) { return nearer(s.rotation[joint].conjugate() * s.rotation[joint + 1]); }

/// Way of the rod's end to the hand, and the turn to it (2 sin(angle / 2) about its axis).
Vec3 grip_way(const RodState& s) { return no_longer_than(s.grip.position - s.position.back(), kMostPull); }
Quat grip_turn(const RodState& s) { return nearer(s.grip.rotation * s.rotation.back().conjugate()); }

bool usable(const RodContact& c) noexcept {
  return c.node >= 0 && c.node < kTubeSegments && c.weight >= 0 && c.weight <= 1 && std::isfinite(c.depth_m) &&
         std::abs(c.normal.squaredNorm() - 1) < 1e-3 && c.stiffness_n_m >= 0 &&
         c.stiffness_n_m <= kMostContactStiffness && c.friction >= 0 && std::isfinite(c.friction) &&
         c.surface_velocity.allFinite();
}

/// What the spring presses with at the start of the step: at the end of the last one.
double pressed(const RodContact& c) { return std::min(c.stiffness_n_m * c.depth_m, kMostContactForce); }

/// What a step begins from, and what of it is worked out once.
struct Start {
  std::array<Vec3, kTubeNodes> position;
  std::array<Quat, kTubeJoints> turn;
  double dt;
};

/// The contact's point since the start of the step, and over the surface it touches.
Vec3 way_of(const RodContact& c, const RodState& s, const Start& start) {
  const int i = c.node;
  return (1 - c.weight) * (s.position[i] - start.position[i]) + c.weight * (s.position[i + 1] - start.position[i + 1]);
}
Vec3 slip_of(const RodContact& c, const Vec3& velocity) {
  const Vec3 over = velocity - c.surface_velocity;
  return over - over.dot(c.normal) * c.normal;
}

/// Friction as a damper: mu N over the speed, N of the last tick.
double friction_damping(const RodContact& c, const Vec3& slip) {
  return c.friction * std::max(0.0, pressed(c)) / std::max(slip.norm(), kStickSpeed);
}

double normal_force(const RodContact& c, const Vec3& way, double dt) {
  return std::max(0.0, pressed(c) - c.stiffness_n_m * c.normal.dot(way - dt * c.surface_velocity));
}

void add_stretching(const Rod& rod, const RodState& s, System& a) {
  const double k = rod.description().stretching_n, l = rod.segment_m();
  for (int j = 0; j < kTubeSegments; ++j) {
    const Vec3 d = s.position[j + 1] - s.position[j];
    const Vec3 t = s.rotation[j] * Vec3::UnitX();
    // E = k/(2l) |d - l t|^2. Where the rod is pushed together the geometric part of its second derivative is negative
    // and left out: the matrix stays definite, and when a rod buckles is the forces' affair.
    const Vec3 pull = k / l * (d - l * t);
    a.right[place_of(j)] += pull;
    a.right[place_of(j + 1)] -= pull;
    a.right[turn_of(j)] += k * t.cross(d);
    a.diagonal[place_of(j)].diagonal().array() += k / l;
    a.diagonal[place_of(j + 1)].diagonal().array() += k / l;
    a.second[place_of(j)].diagonal().array() -= k / l;
    a.diagonal[turn_of(j)] += k * std::max(l, d.dot(t)) * (Mat3::Identity() - t * t.transpose());
    const Mat3 mixed = k * cross_matrix(t);
    a.next[place_of(j)] += mixed;  // row w, column x_j: the transpose of -mixed
    a.next[turn_of(j)] += mixed;
  }
}

void add_bending(const Rod& rod, const RodState& s, const Start& start, System& a) {
  const RodDescription& d = rod.description();
  const double damp = d.damping_s / start.dt;
  for (int i = 0; i < kTubeJoints; ++i) {
    const Quat turn = turn_across(s, i);
    const Vec3 strain = 2 * turn.vec();
    const Vec3 before = (turn.dot(start.turn[i]) < 0 ? -2 : 2) * start.turn[i].vec();
    const RodSection& section = d.section[i];
    const Vec3 stiffness = Vec3(section.twisting_n_m2, section.bending_n_m2, section.bending_n_m2) / rod.segment_m();
    const Vec3 moment = stiffness.cwiseProduct(strain - rod.natural_turn(i) + damp * (strain - before));
    // d strain = (w - [v]) R^T (w_after - w_before)
    const Mat3 change =
        (turn.w() * Mat3::Identity() - cross_matrix(turn.vec())) * s.rotation[i].toRotationMatrix().transpose();
    const Vec3 torque = change.transpose() * moment;
    a.right[turn_of(i)] += torque;
    a.right[turn_of(i + 1)] -= torque;
    const Mat3 block = (1 + damp) * change.transpose() * stiffness.asDiagonal() * change;
    a.diagonal[turn_of(i)] += block;
    a.diagonal[turn_of(i + 1)] += block;
    a.second[turn_of(i)] -= block;
  }
}

/// `velocity`: of the nodes as far as it is known, for friction's damper.
void add_contacts(const RodState& s, const Start& start, const RodContact* contacts, int count,
                  const std::array<Vec3, kTubeNodes>& velocity, System& a) {
  for (int n = 0; n < count; ++n) {
    const RodContact& c = contacts[n];
    if (!usable(c)) continue;
    const int i = c.node;
    const double share[2] = {1 - c.weight, c.weight};
    const Vec3 way = way_of(c, s, start);
    const double push = normal_force(c, way, start.dt);
    const double grip = friction_damping(c, slip_of(c, share[0] * velocity[i] + share[1] * velocity[i + 1])) / start.dt;
    if (push == 0 && grip == 0) continue;
    const Vec3 force = push * c.normal - grip * start.dt * slip_of(c, way / start.dt);
    const Mat3 along = c.normal * c.normal.transpose();
    Mat3 block = grip * (Mat3::Identity() - along);
    if (push > 0) block += c.stiffness_n_m * along;
    for (int e = 0; e < 2; ++e) {
      a.right[place_of(i + e)] += share[e] * force;
      a.diagonal[place_of(i + e)] += share[e] * share[e] * block;
    }
    a.second[place_of(i)] += share[0] * share[1] * block;
  }
}

void add_inertia_and_grip(const Rod& rod, const RodState& s, const Start& start, System& a) {
  const RodDescription& d = rod.description();
  const double h = start.dt;
  for (int i = 0; i < kTubeNodes; ++i) {
    const double m = rod.node_mass_kg(i) / (h * h);
    const Vec3 ballistic = start.position[i] + h * s.velocity[i] + h * h * d.gravity_m_s2;
    a.right[place_of(i)] += m * (ballistic - s.position[i]);
    a.diagonal[place_of(i)].diagonal().array() += m;
  }
  // Frames carry no momentum; a part in a million of the bending stiffness keeps a folded joint solvable.
  for (int j = 0; j < kTubeSegments; ++j)
    a.diagonal[turn_of(j)].diagonal().array() +=
        1e-6 * d.section[std::min(j, kTubeJoints - 1)].bending_n_m2 / rod.segment_m();
  a.right[place_of(kTubeNodes - 1)] += d.grip_n_m * grip_way(s);
  a.diagonal[place_of(kTubeNodes - 1)].diagonal().array() += d.grip_n_m;
  a.right[turn_of(kTubeSegments - 1)] += d.grip_nm_rad * 2 * grip_turn(s).vec();
  a.diagonal[turn_of(kTubeSegments - 1)].diagonal().array() += d.grip_nm_rad;
}

/// Moves the state by the solution; returns how far at most.
double apply(const System& a, const Start& start, RodState& s) {
  double most = 0.0;
  for (int i = 0; i < kTubeNodes; ++i) {
    const Vec3& move = a.right[place_of(i)];
    most = std::max(most, move.squaredNorm());
    s.position[i] = start.position[i] + no_longer_than(s.position[i] + move - start.position[i], kFastest * start.dt);
  }
  most = std::sqrt(most);
  for (int j = 0; j < kTubeSegments; ++j) {
    const Vec3 turn = no_longer_than(a.right[turn_of(j)], kMostTurn);
    most = std::max(most, turn.norm() / 100);
    s.rotation[j] = Quat(1, turn.x() / 2, turn.y() / 2, turn.z() / 2) * s.rotation[j];
    s.rotation[j].normalize();
  }
  return most;
}

bool finite(const RodState& s) {
  double sum = 0.0;
  for (int i = 0; i < kTubeNodes; ++i) sum += s.position[i].sum() + s.velocity[i].sum();
  for (int j = 0; j < kTubeSegments; ++j) sum += s.rotation[j].coeffs().sum();
  return std::isfinite(sum);
}

void read_contacts(const RodState& s, const Start& start, RodContact* contacts, int count, RodStep& result) {
  for (int n = 0; n < count; ++n) {
    RodContact& c = contacts[n];
    c.force.setZero();
    if (!usable(c)) {
      result.faults |= kRodFaultContact;
      continue;
    }
    const Vec3 way = way_of(c, s, start), slip = slip_of(c, way / start.dt);
    c.force = normal_force(c, way, start.dt) * c.normal - friction_damping(c, slip) * slip;
  }
}

void require(double value, bool above_zero, const std::string& what) {
  if (std::isfinite(value) && (above_zero ? value > 0 : value >= 0)) return;
  throw std::invalid_argument("tube: " + what + " is " + std::to_string(value) + "; it must be " +
                              (above_zero ? "above 0" : "0 or above"));
}

}  // namespace

Rod::Rod(const RodDescription& d) : description_(d), segment_(d.length_m / kTubeSegments) {
  require(d.length_m, true, "its length, m,");
  require(d.outer_radius_m, true, "its outer radius, m,");
  require(d.mass_kg_m, true, "its mass per length, kg/m,");
  require(d.stretching_n, true, "its stretching stiffness, N,");
  require(d.damping_s, false, "its damping, s,");
  require(d.grip_n_m, true, "the grip's stiffness, N/m,");
  require(d.grip_nm_rad, true, "the grip's turning stiffness, N m/rad,");
  if (!d.gravity_m_s2.allFinite()) throw std::invalid_argument("tube: gravity is not finite");
  if (!(d.outer_radius_m < d.length_m / 4))
    throw std::invalid_argument("tube: an outer radius of " + std::to_string(1e3 * d.outer_radius_m) +
                                " mm does not make a rod of a length of " + std::to_string(1e3 * d.length_m) + " mm");
  for (int i = 0; i < kTubeJoints; ++i) {
    const RodSection& section = d.section[static_cast<std::size_t>(i)];
    const std::string at = " at joint " + std::to_string(i);
    require(section.bending_n_m2, true, "the bending stiffness" + at + ", N m^2,");
    require(section.twisting_n_m2, true, "the twisting stiffness" + at + ", N m^2,");
    const double angle = section.natural_curvature_per_m * segment_;
    if (!(std::abs(angle) < M_PI / 2))
      throw std::invalid_argument("tube: the natural curvature" + at + " is " +
                                  std::to_string(section.natural_curvature_per_m) + " 1/m; less than " +
                                  std::to_string(M_PI / 2 / segment_) + " fits its segments");
    natural_[static_cast<std::size_t>(i)] = Vec3(0, -2 * std::sin(angle / 2), 0);
  }
}

double Rod::node_mass_kg(int node) const noexcept {
  const double whole = description_.mass_kg_m * segment_;
  return node == 0 || node == kTubeNodes - 1 ? whole / 2 : whole;
}

void RodState::set_rest(const Rod& rod, const Pose& hand) noexcept {
  grip = hand;
  velocity.fill(Vec3::Zero());
  position.back() = hand.position;
  rotation.back() = hand.rotation.normalized();
  for (int j = kTubeSegments - 1; j >= 0; --j) {
    position[j] = position[j + 1] - rod.segment_m() * (rotation[j] * Vec3::UnitX());
    if (j == 0) break;
    const Vec3 half = rod.natural_turn(j - 1) / 2;
    const Quat turn(std::sqrt(1 - half.squaredNorm()), half.x(), half.y(), half.z());
    rotation[j - 1] = (rotation[j] * turn.conjugate()).normalized();
  }
}

RodStep step(const Rod& rod, RodState& state, const Pose& grip, RodContact* contacts, int contact_count,
             double dt_s) noexcept {
  RodStep result;
  if (engine::usable(grip))
    state.grip = grip;
  else
    result.faults |= kRodFaultGrip;
  Start start;
  start.dt = dt_s >= 1e-5 ? std::min(dt_s, 0.01) : 1e-5;
  start.position = state.position;
  for (int i = 0; i < kTubeJoints; ++i) start.turn[i] = turn_across(state, i);

  System system;
  std::array<Vec3, kTubeNodes> velocity = state.velocity;
  for (int n = 0; n < kMostIterations; ++n) {
    system.clear();
    add_inertia_and_grip(rod, state, start, system);
    add_stretching(rod, state, system);
    add_bending(rod, state, start, system);
    add_contacts(state, start, contacts, contact_count, velocity, system);
    system.solve();
    const double moved = apply(system, start, state);
    for (int i = 0; i < kTubeNodes; ++i) velocity[i] = (state.position[i] - start.position[i]) / start.dt;
    if (moved < kConverged) break;
  }
  state.velocity = velocity;
  if (!finite(state)) {
    state.set_rest(rod, state.grip);
    result.faults |= kRodFaultState;
    for (int n = 0; n < contact_count; ++n) contacts[n].force.setZero();
    return result;
  }
  read_contacts(state, start, contacts, contact_count, result);
  result.on_hand.force = -rod.description().grip_n_m * grip_way(state);
  result.on_hand.torque = -rod.description().grip_nm_rad * 2 * grip_turn(state).vec();
  return result;
}

double energy(const Rod& rod, const RodState& s) noexcept {
  const RodDescription& d = rod.description();
  double sum = 0.0;
  for (int i = 0; i < kTubeNodes; ++i)
    sum += rod.node_mass_kg(i) * (s.velocity[i].squaredNorm() / 2 - d.gravity_m_s2.dot(s.position[i]));
  for (int j = 0; j < kTubeSegments; ++j) {
    const Vec3 strain = (s.position[j + 1] - s.position[j]) / rod.segment_m() - s.rotation[j] * Vec3::UnitX();
    sum += d.stretching_n * rod.segment_m() * strain.squaredNorm() / 2;
  }
  for (int i = 0; i < kTubeJoints; ++i) {
    const Vec3 strain = 2 * turn_across(s, i).vec() - rod.natural_turn(i);
    const RodSection& section = d.section[i];
    sum += (section.twisting_n_m2 * strain.x() * strain.x() + section.bending_n_m2 * strain.tail<2>().squaredNorm()) /
           (2 * rod.segment_m());
  }
  return sum + d.grip_n_m * grip_way(s).squaredNorm() / 2 + d.grip_nm_rad * 4 * (1 - grip_turn(s).w());
}

Pose frame_at(const Rod& rod, const RodState& s, double from_tip_m) noexcept {
  const double at = from_tip_m > 0 ? std::min(from_tip_m / rod.segment_m(), double(kTubeSegments)) : 0.0;
  const int j = std::min(static_cast<int>(at), kTubeSegments - 1);
  Pose frame;
  frame.position = s.position[j] + (at - j) * (s.position[j + 1] - s.position[j]);
  frame.rotation = s.rotation[j];
  return frame;
}

}  // namespace vallecula::engine
