// The figures of a result page, short enough to be read at a glance.
#pragma once

#include <vector>

#include "curricula/scenario.h"
#include "gui/report/figure_row.h"
#include "gui/session/trial_session.h"

namespace vallecula::gui {

/// Of a trial with an intubation these begin with where the tube is and what it cost the infant. The last row is the
/// loop's.
std::vector<Row> result_figures(const TrialOutcome& outcome, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
