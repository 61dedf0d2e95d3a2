// Practice and assessment: what is different between them.
#pragma once

namespace vallecula::curricula {

enum class Mode { practice, assessment };

struct ModeRules {
  bool assistance = true;           ///< the scenario's helps on the screen may show
  bool replay = true;               ///< of this trial
  bool variation = true;            ///< an attempt may have a seed of its own; without: everybody gets what is written
  bool self_rating_before = false;  ///< the trainee rates the own trial before the score is shown
};

constexpr ModeRules rules_of(Mode mode) {
  return mode == Mode::practice ? ModeRules{} : ModeRules{false, false, false, true};
}

/// The word in curricula and logs.
constexpr const char* name_of(Mode mode) { return mode == Mode::practice ? "practice" : "assessment"; }

}  // namespace vallecula::curricula
