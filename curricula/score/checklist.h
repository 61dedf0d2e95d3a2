// The checklist beside the score: what was done, yes or no, as far as the log can know it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {

struct Score;

struct ChecklistItem {
  enum class Done {
    no,
    yes,
    not_seen  ///< the log cannot know, or it never came to that: left to the instructor
  };
  std::string id;    ///< "vallecula_reached": never changes its meaning
  std::string text;  ///< of what is good: "The tip reached the vallecula"
  Done done = Done::not_seen;
  double at_s = -1.0;  ///< second of the trial that decided; -1: none
  std::string sentence;  ///< why; without a full stop
};

/// "yes", "no", "not seen"
const char* name_of(ChecklistItem::Done done);

/// The items that this scenario has, in the order of the procedure, from a score whose figures are filled in. Dichotomous,
/// for those agree better between raters (kappa 0.64 against 0.58); the technique is that of the field's texts as
/// this program's clinical notes have it, the items are its own and not validated.
std::vector<ChecklistItem> checklist_of(const Score& score, const TrialLog& log, const Scenario& scenario);

/// The global rating beside it is given by a person, never by the program (a checklist and a global rating together:
/// NICAT, alpha 0.79). What 1 to 5 mean; the words are assumed.
constexpr std::array<const char*, 5> kGlobalRatingWords = {"unsafe", "with help at every step", "with help at some steps",
                                                      "alone, with flaws", "alone and well"};

}  // namespace vallecula::curricula
