// Where the blade was: by the patient's landmarks at rest.
#pragma once

#include <optional>
#include <vector>

#include "curricula/trial_log.h"

namespace vallecula::curricula {

struct Stay;

/// The midline is the plane through both gum midlines and the vallecula; its left is the patient's (LPS). All of the
/// blade's tip as the scene held it, within the attempts, less pauses. Nothing where there was no attempt or the log lacks
/// usable landmarks.
struct BladeFigures {
  std::optional<double> entry_left_m;     ///< from the midline as it first enters the mouth; negative: the right
  std::optional<double> to_vallecula_m;   ///< its least distance from the vallecula
  double to_vallecula_at_s = -1.0;
  std::optional<double> left_m;           ///< from the midline then
  bool vallecula_reached = false;         ///< within kReachedShare of the way from the gums to the vallecula
  double vallecula_reached_at_s = -1.0;   ///< the first time
  double past_vallecula_m = 0.0;          ///< farthest beyond it along that way; 0: never beyond
  double past_vallecula_at_s = -1.0;
};

/// Assumed: 6 mm in a term infant, for the landmark is the fold's depth and a blade is some millimetres thick.
constexpr double kReachedShare = 0.15;

BladeFigures measure_blade(const TrialLog& log, const std::vector<Stay>& attempts);

}  // namespace vallecula::curricula
