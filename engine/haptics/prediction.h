// What the coupling gives while a step is late. Coupling, tool and hand are known without the tissue, so they go on as
// in the step; rigid anatomy goes on as it was near the tool, and the tissue with the stiffness it was last felt to
// have.
#pragma once

#include "engine/haptics/coupling.h"

namespace vallecula::engine {

/// The tissue's stiffness as the tool felt it over the last steps: change of its force over the way, both along the
/// force. That of the step's matrices is the stiffness within one tick: it holds the tissue's inertia and is several
/// times as stiff.
class ContactStiffness {
 public:
  /// One more step: the tool's pose and the tissue's force on it. Returns N/m, 0 without a contact.
  double feel(const Pose& tool, const Wrench& tissue) noexcept;

 private:
  static constexpr int kWindow = 4;  // steps over which changes are taken
  std::array<Pose, kWindow> tools_;
  std::array<Wrench, kWindow> forces_;
  int felt_ = 0;
  double work_ = 0.0, way_ = 0.0;  // sums of the least squares, the older ones fading
};

/// Adds the tissue, which presses with `tissue` and is `stiffness_n_m` stiff along it; a force too small to be a
/// contact is none.
void add_tissue(const Wrench& tissue, double stiffness_n_m, PushingSprings& springs) noexcept;

/// After a step, all that is needed to go on without the next one.
struct CouplingState {
  HandState hand;
  ProxyState proxy;        ///< its pull is what the hand feels, reversed
  PushingSprings springs;  ///< of tissue and rigid anatomy on the tool
  bool held = false;       ///< the proxy stands
};

/// How late ticks are predicted. All but `contact` are there to be measured against.
enum class Prediction : std::uint8_t {
  hold,     ///< the last force
  spring,   ///< the proxy stands, the coupling's spring follows the hand
  contact,  ///< the proxy goes on against what touched it
};

/// One tick of the coupling with the hand at `device`.
void advance(const ProxySettings& settings, Prediction prediction, const Pose& device,
             CouplingState& coupling) noexcept;

}  // namespace vallecula::engine
