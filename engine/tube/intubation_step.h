// The second half of the procedure as it is stepped with the scene: the second hand and what it holds, cords,
// secretions, the assistant's press, breaths, the infant.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/tube/soft_contacts.h"

namespace vallecula::engine {

struct SceneState;
struct StepInput;
struct StepResult;

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

struct IntubationState {
  explicit IntubationState(const Scene& scene);

  InHand in_hand;
  bool stylet_in;
  RodState rod;
  PassageState passage;
  SoftContactState soft;        ///< of the tube with tongue and epiglottis
  TubeContacts contacts;        ///< of the last step
  bool placed = false;          ///< the first good pose has placed what the second hand holds
  bool returning = false;       ///< the hand was lost: the grip goes back to it slowly
  std::uint32_t actions = 0;    ///< of the last step
  double until_breath_s = 0.0;  ///< while they are asked for
  GlottisState glottis;
  InfantState infant;
  InfantSigns signs;     ///< as the last step left them
  bool started = false;  ///< the infant has taken a step
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
