// The parts of report and terminal table that only a trial with an intubation has.
#pragma once

#include <vector>

#include "gui/report/figure_row.h"

namespace vallecula::gui {

// All need score.intubation.

/// One sentence for a person: passed or not, where the tube lies, and what it cost the infant.
std::string intubation_sentence(const curricula::Score& score, const curricula::Scenario& scenario);
std::vector<Row> intubation_rows(const curricula::Score& score, const curricula::Scenario& scenario);
/// A table with a line for each attempt; nothing where there was none.
std::string attempts_html(const curricula::Score& score);

}  // namespace vallecula::gui
