// The tool as the scene holds it: joined to the device pose by a 6-DoF virtual coupling, pushed by the tissue, stopped by
// rigid anatomy.
#pragma once

#include <algorithm>

#include "engine/contact/rigid_field.h"
#include "engine/contact/tool_field.h"
#include "engine/tick_record.h"

namespace vallecula::engine {

struct ProxySettings {
  double step_s = 0.001;
  double mass_kg = 0.08;               ///< virtual
  double inertia_kg_m2 = 7e-5;         ///< virtual, about the blade tip, the same about every axis
  double stiffness_n_m = 1200.0;       ///< of the coupling
  double rotation_nm_rad = 8.0;
  double force_limit_n = 7.9;          ///< of the device: bounds what the coupling can turn with
};

struct ProxyState {
  Pose pose;
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
};

/// Force and torque about the blade tip, world axes.
struct Wrench {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};

/// Stiffness of what presses on the tool, over a move (m, rad) about the blade tip, world axes.
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// Contacts of the tool with rigid anatomy in one tick.
struct RigidContacts {
  Wrench wrench;                                         ///< on the tool
  std::array<StructureLoad, kLoadedStructures> loads{};  ///< by Structure
};

/// What the contacts ask of the bodies that moving parts of the anatomy belong to (TissueState::body_load).
struct BodyLoads {
  std::vector<Vec3>& load;
  std::vector<double>& stiffness;
};

/// Which of the tool's sample points need not be looked at yet: a point seen at some distance from rigid anatomy cannot touch
/// it before tool and anatomy have travelled that far.
struct RigidScan {
  explicit RigidScan(std::size_t samples) : next_check(samples, 0.0), depth(samples, 0.0) {}
  /// As before the first look, with the tool at `pose`.
  void begin_anew(const Pose& pose) noexcept {
    travel = 0.0;
    std::fill(next_check.begin(), next_check.end(), 0.0);
    std::fill(depth.begin(), depth.end(), 0.0);
    last = pose;
    parts = PartPoses{};
  }
  double travel = 0.0;             ///< of the tool's fastest point and the moving parts' since the scan began, m
  std::vector<double> next_check;  ///< per sample, as travel
  /// Per sample: how deep it is in gum, palate or tooth, m, as far as it can have come since it met them. A point that
  /// comes through lip or cheek, which do not resist, is met by the gum where it is, not by all that lies above it.
  std::vector<double> depth;
  Pose last;                       ///< of the tool, when travel was added to,
  PartPoses parts;                 ///< and of the anatomy
};

/// Rotation vector (axis times angle, rad) that turns `from` into `to`, world axes.
Vec3 rotation_between(const Quat& from, const Quat& to);

/// Force of the virtual coupling on the proxy: stiffness times the way to the device pose; `scale` in (0, 1].
Wrench coupling_wrench(const ProxySettings& settings, const Pose& proxy, const Pose& device, double scale);

/// One implicit step of the proxy: (M/h^2 + B/h + K) dx = M v/h + coupling + tissue + rigid contact, where K holds the
/// coupling's, the tissue's and the rigid contacts' stiffness. `tissue` is the last tick's force of the tissue on the tool and
/// `tissue_stiffness` what it would change by if the tool moved within a tick: taken as a mere load, a blade wedged between
/// tissue and gum chattered at the tick's rate. `device_velocity` (m/s, rad/s): the damper works against the hand, so that
/// moving freely costs no force. Moving parts of the anatomy are taken to go on as they do. `force_limit`: the coupling pulls with no more than this (N). Returns the rigid contacts at
/// the new pose.
RigidContacts move_proxy(const ProxySettings& settings, const RigidField& rigid, const PartPoses& parts,
                         const ToolField& tool, RigidScan& scan, const Pose& device, const Wrench& device_velocity, double coupling_scale, double force_limit,
                         const Wrench& tissue, const Mat6& tissue_stiffness, ProxyState& proxy) noexcept;

/// Rigid contacts of a proxy that is held still.
RigidContacts rigid_contacts(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, RigidScan& scan,
                             const Pose& pose) noexcept;

/// Loads the bodies of the moving parts with what the proxy presses on them with (added to `bodies`): their share of the
/// contact springs, which the tissue's step takes implicitly with the proxy standing where it is.
void press_parts(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, RigidScan& scan,
                 const ProxyState& proxy, double step_s, const BodyLoads& bodies) noexcept;

}  // namespace vallecula::engine
