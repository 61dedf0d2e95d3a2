// A module's state, in the few words of the start page.
#pragma once

#include <QString>
#include <vector>

#include "curricula/progress/progress.h"

namespace vallecula::gui {

/// "mastered", "open" or "closed".
QString state_of(const curricula::ModuleProgress& progress);

/// How far the module is on its way to mastery: "4 of 8 trials passed, 1 of 3 scenarios done".
QString progress_line(const curricula::Module& module, const curricula::ModuleProgress& progress);

/// When the module counts as mastered, by whose word.
QString mastery_rule(const curricula::Module& module);

/// What has to be mastered before this scenario opens; empty: it is open. `progress`: of each module, in order.
QString why_closed(const curricula::Curriculum& curriculum, const std::vector<curricula::ModuleProgress>& progress,
                   const std::string& scenario_id);

}  // namespace vallecula::gui
