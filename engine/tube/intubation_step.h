// The second half of the procedure as it is stepped with the scene: the second hand and what it holds, cords,
// secretions, the assistant's press, breaths, the infant.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/haptics/coupling.h"
#include "engine/scene.h"
#include "engine/tube/intubation.h"
#include "engine/tube/intubation_record.h"
#include "engine/tube/passage.h"

namespace vallecula::engine {

class Scene;
struct SceneState;
struct StepInput;
struct StepResult;

/// The description, checked, with what a step needs of it.
class Intubation {
 public:
  /// Throws std::invalid_argument with the number at fault, or with what contradicts what.
  Intubation(const IntubationDescription& description, const std::vector<SprungBody>& bodies);

  bool has(InHand what) const noexcept { return rods_[static_cast<std::size_t>(what)].has_value(); }
  const Rod& rod(InHand what) const noexcept { return *rods_[static_cast<std::size_t>(what)]; }
  /// Of what is held; the tube's, with and without its stylet.
  const TubeDesign& design(InHand what) const noexcept {
    return what == InHand::catheter ? catheter_ : description.tube;
  }
  /// Of the larynx body's way, and of what is pressed on it there: the cords'.
  double larynx_share() const noexcept { return larynx_share_; }

  /// The same, as walls and surfaces meet it.
  const TubeOutside& outside(InHand what) const noexcept {
    return what == InHand::catheter ? catheter_outside_ : tube_outside_;
  }

  IntubationDescription description;
  Infant infant;
  Passage passage;
  /// The rod's surface as the sight meets it: kTubeSides points about each node, in their order.
  std::vector<std::array<int, 3>> sleeve;

 private:
  TubeDesign catheter_;  ///< where there is one
  TubeOutside tube_outside_, catheter_outside_;
  std::array<std::optional<Rod>, 3> rods_;
  double larynx_share_ = 0.0;
};

constexpr int kTubeSides = 6;

/// Point `i` of the rod's surface (Intubation::sleeve), m.
inline Vec3 sleeve_point(const RodState& rod, double radius_m, int i) noexcept {
  // cos, sin of the sixths of a turn.
  constexpr double kCos[] = {1, 0.5, -0.5, -1, -0.5, 0.5}, kSin[] = {0, 1, 1, 0, -1, -1};
  constexpr double kHalfRootThree = 0.8660254037844386;
  const int node = i / kTubeSides, k = i % kTubeSides;
  const Quat& frame = rod.rotation[static_cast<std::size_t>(std::min(node, kTubeSegments - 1))];
  return rod.position[static_cast<std::size_t>(node)] +
         frame * Vec3(0, radius_m * kCos[k], radius_m * kHalfRootThree * kSin[k]);
}

/// The assistant's press, N, that moves the larynx by `way_m` where nothing but its body's springs holds it; 0 where it
/// cannot move.
double press_for(const IntubationDescription& description, const std::vector<SprungBody>& bodies, double way_m);

struct IntubationState {
  explicit IntubationState(const Intubation& intubation, std::size_t bodies);

  InHand in_hand;
  bool stylet_in;
  RodState rod;
  PassageState passage;
  TubeContacts contacts;        ///< of the last step
  bool placed = false;          ///< the first good pose has placed what the second hand holds
  bool returning = false;       ///< the hand was lost: the grip goes back to it slowly
  std::uint32_t actions = 0;    ///< of the last step
  double until_breath_s = 0.0;  ///< while they are asked for
  GlottisState glottis;
  InfantState infant;
  double breath_phase = 0.0;  ///< of the infant's own breathing, after the last step
  double secretions_m3;
  double press = 0.0;  ///< share of the assistant's force, 0..1

  // Of the last step; the next takes them in.
  Wrench on_blade;  ///< by the tube, about the blade's tip
  Mat6 on_blade_stiffness = Mat6::Zero();
  std::vector<Vec3> body_load;  ///< as TissueState's
  std::vector<double> body_load_stiffness;
};

/// Advances it by one step of the scene, after tissue and blade have moved. `result`: what the step has found so far;
/// its record of the intubation is filled. No allocation, lock, I/O or exception. What becomes non-finite is put back
/// to its start, and named.
void step_intubation(const Scene& scene, SceneState& state, const StepInput& input, StepResult& result) noexcept;

}  // namespace vallecula::engine
