// The tool against rigid anatomy, which stops it.
#pragma once

#include <algorithm>

#include "engine/contact/signed_distance_grid.h"
#include "engine/contact/tool_field.h"
#include "engine/haptics/coupling.h"
#include "engine/tick_record.h"

namespace vallecula::engine {

/// Contacts of the tool with rigid anatomy in one tick.
struct RigidContacts {
  Wrench wrench;                                         ///< on the tool
  std::array<StructureLoad, kLoadedStructures> loads{};  ///< by Structure
};

/// Which of the tool's sample points need not be looked at yet: a point seen at some distance from rigid anatomy, which
/// stands still, cannot touch it before the tool has travelled that far.
struct RigidScan {
  static constexpr double kNotMet = 1e9;  ///< m: by nothing that resists, however deep it is
  explicit RigidScan(std::size_t samples) : next_check(samples, 0.0), met(samples, kNotMet) {}
  /// As before the first look, with the tool at `pose`.
  void begin_anew(const Pose& pose) noexcept {
    travel = 0.0;
    std::fill(next_check.begin(), next_check.end(), 0.0);
    std::fill(met.begin(), met.end(), kNotMet);
    near.clear();
    last = pose;
  }
  double travel = 0.0;             ///< of the tool's fastest point since the scan began, m
  std::vector<double> next_check;  ///< per sample, as travel
  /// Per sample: how deep below the surface it was when gum, palate or tooth met it, m; they resist what it goes
  /// deeper. 0 for a point that came from outside; one that comes through lip or cheek, which do not resist, is met
  /// where it is. Drawn out to there it is free, and met anew. So the resistance has a potential: no way round gives
  /// energy.
  std::vector<double> met;
  PushingSprings near;  ///< the points that touch or soon will, with the tool where it was last looked at
  Pose last;            ///< of the tool, when travel was added to
};

/// One step of the proxy against the hand, rigid anatomy and the tissue. `tissue` is the last tick's force of the
/// tissue on the tool and `tissue_stiffness` what it would change by if the tool moved within a tick: taken as a mere
/// load, a blade wedged between tissue and gum chattered at the tick's rate. Returns the rigid contacts at the new
/// pose.
RigidContacts move_proxy(const ProxySettings& settings, const SignedDistanceGrid& rigid, const ToolField& tool,
                         RigidScan& scan, const HandState& hand, const Wrench& tissue, const Mat6& tissue_stiffness,
                         ProxyState& proxy) noexcept;

/// Rigid contacts of a proxy that is held still.
RigidContacts rigid_contacts(const SignedDistanceGrid& rigid, const ToolField& tool, RigidScan& scan,
                             const Pose& pose) noexcept;

}  // namespace vallecula::engine
