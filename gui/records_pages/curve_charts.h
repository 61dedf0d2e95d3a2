// A learning curve's two charts, and the words for a trial in them.
#pragma once

#include <vector>

#include "curricula/score/figures.h"
#include "gui/records_pages/curve_reading.h"
#include "gui/records_pages/trial_chart.h"

namespace vallecula::gui {

QString with_unit(const curricula::Figure& figure);  ///< "Peak tongue force (N)"
std::optional<double> value_of(const curricula::RecordRow& row, const curricula::Figure& figure);
QString result_of(const curricula::RecordRow& row);  ///< "passed", "not passed", "interrupted", "not counted"

/// One point a row. `scenario`: whose lines are drawn; null: it is not known here.
TrialChart::Content learning_chart(const std::vector<curricula::RecordRow>& rows, const curricula::Figure& figure,
                                   const curricula::Scenario* scenario);
/// One point a whole trial, with both lines of the rule.
TrialChart::Content cusum_chart(const CurveReading& reading);

}  // namespace vallecula::gui
