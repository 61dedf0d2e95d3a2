// The tracheal tube as an elastic rod: a chain of nodes from the tip to the hand's grip, with a frame on each segment,
// stepped implicitly with a direct solve, so that its stiffness is beam theory's whatever the step or the iterations.
// Strains are those of the staggered Cosserat rod (Kugelstadt and Schoemer 2016), the solve that of Deul et al. 2018's
// direct one, as a plain banded factorisation.
#pragma once

#include "engine/haptics/coupling.h"

namespace vallecula::engine {

constexpr int kTubeNodes = 40;
constexpr int kTubeSegments = kTubeNodes - 1;
constexpr int kTubeJoints = kTubeNodes - 2;  ///< joint i bends between segments i and i + 1, at node i + 1

/// One joint's section: how stiff it is and how it is bent when nothing acts.
struct RodSection {
  double bending_n_m2 = 4e-4;            ///< E I, the same about every axis across the rod
  double twisting_n_m2 = 2.8e-4;         ///< G J
  double natural_curvature_per_m = 0.0;  ///< towards +z of the frames on the way to the tip; 0: straight
};

/// What a rod is. The frames' +x runs along it from the tip to the grip, +z to its concave side.
struct RodDescription {
  double length_m = 0.14;  ///< tip to the last node; the hand clamps the last segment, so the rod is free to its middle
  double outer_radius_m = 0.00245;
  double mass_kg_m = 0.0116;  ///< per length
  /// Along the rod and in shear. Softer than steel and far stiffer than a PVC tube (277 N): a push of 10 N stretches it
  /// by 0.5 %, so the marks stay where they are and the solve well conditioned.
  double stretching_n = 2000.0;
  double damping_s = 0.01;   ///< Kelvin and Voigt's: bending moment per strain rate over that per strain
  double grip_n_m = 2000.0;  ///< the hand's stiffness against moving (assumed)
  double grip_nm_rad = 2.0;  ///< and against turning (assumed)
  Vec3 gravity_m_s2 = Vec3::Zero();
  std::array<RodSection, kTubeJoints> section{};
};

/// A point of the rod's axis pressed against something: a spring that only pushes, and Coulomb friction, which below
/// 0.1 mm/s is a damper (what sticks creeps by less) and has no memory. A point first given when it is already deep is
/// pushed at once with all of its spring: give points from where they just touch.
struct RodContact {
  int node = 0;                 ///< the point lies between this node and the next
  double weight = 0.0;          ///< share of the next one, 0 to 1
  Vec3 normal = Vec3::UnitZ();  ///< out of what is touched, unit, world
  double depth_m = 0.0;         ///< how far the tube is pressed in at the start of the step; negative: still away
  double stiffness_n_m = 1000.0;
  double friction = 0.0;                 ///< Coulomb's coefficient
  Vec3 surface_velocity = Vec3::Zero();  ///< of what is touched, m/s
  Vec3 force = Vec3::Zero();             ///< after the step: on the tube, N, world
};

/// What a step could not take as it came, bits.
enum RodFault : std::uint32_t {
  kRodFaultNone = 0,
  kRodFaultGrip = 1u << 0,     ///< the hand's pose was not finite or no rotation: the last good one stands
  kRodFaultContact = 1u << 1,  ///< a contact was not finite or named no node: it was left out
  kRodFaultState = 1u << 2,    ///< the rod became non-finite and was put back to rest in the hand
};

/// The description, checked, with what a step needs of it.
class Rod {
 public:
  /// Throws std::invalid_argument naming the value at fault.
  explicit Rod(const RodDescription& description);

  const RodDescription& description() const noexcept { return description_; }
  double segment_m() const noexcept { return segment_; }
  double node_mass_kg(int node) const noexcept;
  /// Turn from the segment before a joint to the one after it when nothing acts, as twice a quaternion's vector.
  const Vec3& natural_turn(int joint) const noexcept { return natural_[static_cast<std::size_t>(joint)]; }

 private:
  RodDescription description_;
  double segment_;
  std::array<Vec3, kTubeJoints> natural_;
};

/// All there is of a rod between two steps. World axes.
struct RodState {
  RodState(const Rod& rod, const Pose& grip) noexcept { set_rest(rod, grip); }
  /// Hangs undeformed and still from the grip. `grip` must be a pose (`usable`).
  void set_rest(const Rod& rod, const Pose& grip) noexcept;

  std::array<Vec3, kTubeNodes> position, velocity;  ///< m, m/s; node 0 is the tip
  std::array<Quat, kTubeSegments> rotation;         ///< frame of the segment from node i to i + 1
  Pose grip;                                        ///< last good one
};

struct RodStep {
  Wrench on_hand;  ///< by the rod, about the grip's position, world
  std::uint32_t faults = kRodFaultNone;
};

/// Advances the rod by `dt_s` (held within 1e-5 and 0.01 s) with the hand at `grip`: its position is the last node's,
/// its axes the last segment's. Leaves each contact's force in it. No allocation, lock, I/O or exception.
RodStep step(const Rod& rod, RodState& state, const Pose& grip, RodContact* contacts, int contact_count,
             double dt_s) noexcept;

/// Kinetic, elastic and gravity's energy, and that of the hand's springs, J.
double energy(const Rod& rod, const RodState& state) noexcept;

/// Frame of the rod `from_tip_m` along it from the tip (held within its length): the axis' point and the segment's
/// axes.
Pose frame_at(const Rod& rod, const RodState& state, double from_tip_m) noexcept;

}  // namespace vallecula::engine
