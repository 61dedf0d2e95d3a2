// The reports on paper: of one trial, and of one trainee.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "curricula/export/trial_table.h"
#include "curricula/trial_log.h"

namespace vallecula::gui {

/// Both are written whole and need a QGuiApplication; they throw std::runtime_error naming the file. A name stands on
/// them only where it is given.

/// From the log alone: summary, reasons, points with the marks' sources, figures, attempts, charts.
void write_trial_pdf(const std::filesystem::path& file, const curricula::TrialLog& log, const std::string& name);

/// `trials` of one trainee in the order they were recorded, at least one: by scenario and device kind (never pooled) the
/// learning curve with its cumulative sum, by the rule of the course where this user has it (find_curricula), then all
/// trials.
void write_trainee_pdf(const std::filesystem::path& file, long long trainee_id, const std::string& name,
                       const std::vector<curricula::ExportTrial>& trials);

}  // namespace vallecula::gui
