// The checklist for somebody who watches a trial that is not over yet.
#pragma once

#include <vector>

#include "curricula/score/checklist.h"

namespace vallecula::curricula {

/// The items that a trial of this scenario will have at least, none of them judged: what may be ticked meanwhile.
std::vector<ChecklistItem> checklist_to_watch(const Scenario& scenario);

}  // namespace vallecula::curricula
