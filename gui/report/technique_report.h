// How it was done: the report's rows beyond the first figures, the checklist, and where each point went.
#pragma once

#include <string>
#include <vector>

#include "curricula/score/score.h"
#include "gui/report/figure_row.h"

namespace vallecula::gui {

/// View, lift, blade and dual task; what is for researchers only is not among them.
std::vector<Row> technique_rows(const curricula::Score& score);

/// The checklist with the second of each item, and the global rating for a person to give, as HTML.
std::string checklist_html(const curricula::Score& score);

/// Each pass mark with its points, when and why it was met or not, and what it stands on, as HTML; empty without weights.
std::string points_html(const curricula::Score& score, const curricula::Scenario& scenario);

/// The same in lines for a terminal, the first with the sum; none without weights.
std::vector<std::string> points_lines(const curricula::Score& score, const curricula::Scenario& scenario);

}  // namespace vallecula::gui
