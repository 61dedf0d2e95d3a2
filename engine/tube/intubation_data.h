// The second half of the procedure, built: rods, passage and infant from their description, fixed in a trial.
#pragma once

#include <optional>
#include <vector>

#include "engine/scene.h"
#include "engine/tube/intubation.h"
#include "engine/tube/passage.h"

namespace vallecula::engine {

constexpr int kTubeSides = 6;

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
  IntubationRecord at_start;  ///< what there is to record before the first step: infant, cords, secretions
  /// The rod's surface as the sight meets it: kTubeSides points about each node, in their order.
  std::vector<std::array<int, 3>> sleeve;

 private:
  TubeDesign catheter_;  ///< where there is one
  TubeOutside tube_outside_, catheter_outside_;
  std::array<std::optional<Rod>, 3> rods_;
  double larynx_share_ = 0.0;
};

/// The assistant's press, N, that moves the larynx by `way_m` where nothing but its body's springs holds it; 0 where it
/// cannot move.
double press_for(const IntubationDescription& description, const std::vector<SprungBody>& bodies, double way_m);

}  // namespace vallecula::engine
