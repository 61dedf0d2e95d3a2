// What changes in a scene, and one step of it. The state is all there is: equal states and equal inputs give equal steps,
// bit for bit.
#pragma once

#include "engine/contact/tissue_contact.h"
#include "engine/haptics/force_limit.h"
#include "engine/haptics/prediction.h"
#include "engine/posture.h"
#include "engine/scene_data.h"
#include "engine/tick_record.h"
#include "engine/tissue/implicit_step.h"
#include "engine/tissue/tissue_state.h"
#include "engine/tube/intubation_step.h"

namespace vallecula::engine {

struct StepInput {
  Pose device;
  bool valid = true;
  Pose second;               ///< of the second hand; read where the scene has an intubation
  bool second_valid = true;
  std::uint32_t actions = 0; ///< bits of Action
};

/// Can both hands be used now? In a scene with an intubation a trial stands still while not: blade and tube stay where
/// they are, actions are not heard, neither hand feels anything, and both tools come back to their hands slowly.
inline bool hands_there(const StepInput& input) noexcept { return input.valid && input.second_valid; }

/// One step's result, as plain numbers.
struct StepResult {
  std::int64_t step = -1;
  Pose device_pose;                        ///< the input, made finite and clamped
  Pose proxy_pose;
  LimitState limit;
  Vec3 model_force_n = Vec3::Zero(), model_torque_nm = Vec3::Zero();
  std::array<StructureLoad, kLoadedStructures> loads{};
  CouplingState coupling;                  ///< what the hand feels, and how to go on without the next step
  double glottis_visible = 0.0;            ///< as of the last sight evaluation
  std::uint32_t faults = kFaultNone;
  IntubationRecord intubation;             ///< where the scene has one
};

struct SceneState {
  explicit SceneState(const Scene& scene);

  TissueState tissue;
  ContactState contacts;
  TriangleScratch triangles;   ///< where the scene tests triangles
  ProxyState proxy;
  RigidScan rigid_scan;
  PartPoses parts;             ///< of the rigid anatomy, as the tissue's bodies have taken them
  LipState lips;
  LimitState limit;
  Wrench tissue_wrench;        ///< of the last step, on the tool
  Mat6 tissue_stiffness = Mat6::Zero();  ///< of the contacts that pushed in it: how the tissue resists a move within a tick
  ContactStiffness felt;       ///< how stiff the tissue was in the last steps
  HandState hand;              ///< last good device pose and its velocity
  bool placed = false;         ///< the first good pose has placed the proxy
  Pose free_pose;              ///< of the proxy when it last touched nothing: where it begins anew after a fault
  PostureState posture;        ///< of the operator's head and the infant's
  LineOfSight::Scratch sight;
  double glottis_visible = 0.0;
  std::int64_t step = 0;       ///< steps taken
  std::optional<IntubationState> intubation;  ///< where the scene has one
};

constexpr std::int64_t kSightEverySteps = 20;

/// Where the operator's eye is, from SightDescription::eye, m.
Vec3 eye_offset(const Scene& scene, const SceneState& state) noexcept;

/// A usable pose as the scene takes it: a unit rotation, no farther than 1 m from the tissue.
Pose within_reach(const Scene& scene, const Pose& pose) noexcept;

/// The tissue's part of a step, with the tool brought from `before` to state.proxy.pose: contacts, response, and the
/// tissue's force on the tool (state.tissue_wrench) with its split in `loads`. Adds the stages' times to `times`.
/// `tube`, if there is one: its contacts as press_tissue left them, which are solved along (soft_contacts.h).
StepStatistics step_tissue(const Scene& scene, SceneState& state, const Pose& before,
                           std::array<StructureLoad, kLoadedStructures>& loads, StageTimes& times,
                           SoftContactState* tube = nullptr) noexcept;

/// Advances the scene by one step. No allocation, lock, I/O or exception; a non-finite tissue is put back to rest and
/// reported as kFaultTissue, with no force.
StepResult step(const Scene& scene, SceneState& state, const StepInput& input) noexcept;

}  // namespace vallecula::engine
