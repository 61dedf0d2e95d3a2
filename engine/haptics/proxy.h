// The tool against rigid anatomy, which stops it.
#pragma once

#include <algorithm>

#include "engine/contact/rigid_field.h"
#include "engine/contact/tool_field.h"
#include "engine/haptics/coupling.h"
#include "engine/tick_record.h"

namespace vallecula::engine {

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

/// Which of the tool's sample points need not be looked at yet: a point seen at some distance from rigid anatomy cannot
/// touch it before tool and anatomy have travelled that far.
struct RigidScan {
  static constexpr double kNotMet = 1e9;  ///< m: by nothing that resists, however deep it is
  explicit RigidScan(std::size_t samples) : next_check(samples, 0.0), met(samples), pressed_in(samples) {
    begin_anew(Pose{});
  }
  /// As before the first look, with the tool at `pose`.
  void begin_anew(const Pose& pose) noexcept {
    travel = 0.0;
    std::fill(next_check.begin(), next_check.end(), 0.0);
    for (auto& of : met) of.fill(kNotMet);
    for (auto& of : pressed_in) of.fill(kNothing);
    near.clear();
    last = pose;
    parts = PartPoses{};
  }
  double travel = 0.0;             ///< of the tool's fastest point and the moving parts' since the scan began, m
  std::vector<double> next_check;  ///< per sample, as travel
  /// Per sample, for what stands still and for each moving part: how deep below the surface it was when gum, palate or
  /// tooth met it, m; they resist what it goes deeper. 0 for a point that came from outside; one that comes through lip
  /// or cheek, which do not resist, is met where it is. Drawn out to there it is free, and met anew. So the resistance
  /// has a potential: no way round gives energy.
  std::vector<std::array<double, 1 + kMostRigidParts>> met;
  /// Likewise: the structure it is pressed into, or kNothing. It stays in that where it slides on beneath the border of
  /// something that does not resist, or the blade would sink deeper at each crossing.
  std::vector<std::array<std::uint8_t, 1 + kMostRigidParts>> pressed_in;
  static constexpr std::uint8_t kNothing = 255;
  PushingSprings near;  ///< the points that touch or soon will, with the tool where it was last looked at
  Pose last;            ///< of the tool, when travel was added to,
  PartPoses parts;      ///< and of the anatomy
};

/// One step of the proxy against the hand, rigid anatomy and what is soft. `soft` is the last tick's force of tissue and
/// lips on the tool and `soft_stiffness` what it would change by if the tool moved within a tick: taken as a mere load, a
/// blade wedged between tissue and gum chattered at the tick's rate. Moving parts of the anatomy are taken to go on as they
/// do. Returns the rigid contacts at the new pose.
RigidContacts move_proxy(const ProxySettings& settings, const RigidField& rigid, const PartPoses& parts,
                         const ToolField& tool, RigidScan& scan, const HandState& hand, const Wrench& soft,
                         const Mat6& soft_stiffness, ProxyState& proxy) noexcept;

/// Rigid contacts of a proxy that is held still.
RigidContacts rigid_contacts(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, double step_s,
                             RigidScan& scan, const Pose& pose) noexcept;

/// Loads the bodies of the moving parts with what the proxy presses on them with (added to `bodies`): their share of the
/// contact springs, which the tissue's step takes implicitly with the proxy standing where it is.
void press_parts(const RigidField& rigid, const PartPoses& parts, const ToolField& tool, RigidScan& scan,
                 const ProxyState& proxy, double step_s, const BodyLoads& bodies) noexcept;

}  // namespace vallecula::engine
