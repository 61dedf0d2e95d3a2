#include "gui/commands/score_table.h"

#include <iomanip>
#include <string>
#include <vector>

#include "gui/report/intubation_report.h"
#include "gui/report/report.h"
#include "gui/report/technique_report.h"

namespace vallecula::gui {

namespace {

void print_rows(std::ostream& out, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    out << "  " << std::left << std::setw(48) << row.name << row.value;
    if (!row.limit.empty()) out << " (" << row.verdict << (row.verdict.empty() ? "" : ": ") << row.limit << ")";
    out << "\n";
  }
}

void print_intubation(std::ostream& out, const curricula::Score& score, const curricula::Scenario& scenario) {
  print_rows(out, intubation_rows(score, scenario));
  int number_of = 0;
  for (const curricula::Attempt& a : score.intubation->attempts) {
    out << "  attempt " << ++number_of << ": " << number(a.start_s, 1) << " to " << number(a.end_s, 1) << " s, "
        << a.breaths_before << " breaths before, saturation from "
        << curricula::told_spo2(a.highest_spo2_before_percent) << " % to "
        << curricula::told_spo2(a.lowest_spo2_percent) << " %" << (a.desaturated ? " (severe desaturation)" : "")
        << ", heart to " << number(a.lowest_heart_per_min, 0) << (a.bradycardia ? " (bradycardia)" : "") << "\n";
  }
}

}  // namespace

void print_score(std::ostream& out, const curricula::Score& score, const curricula::Scenario& scenario) {
  const auto line = [&out](const std::string& name, double value, int digits, const std::string& unit) {
    out << "  " << std::left << std::setw(34) << name << std::right << std::setw(9) << std::fixed
        << std::setprecision(digits) << value << " " << unit << "\n";
  };
  out << summary_sentence(score, scenario) << "\n";
  line("peak tongue force", score.peak_tongue_force_n, 2, "N");
  line("peak gum force", score.peak_gum_force_n, 2, "N");
  line("glottis seen at best", score.glottis_visible_max_percent, 1, "%");
  const auto time_or = [&](const std::string& name, bool exists, double time_s, const std::string& otherwise) {
    if (exists)
      line(name, time_s, 2, "s");
    else
      out << "  " << std::left << std::setw(33) << name << std::right << std::setw(10) << otherwise << "\n";
  };
  const bool whole = !score.at_vallecula;
  time_or("time to glottis in sight", whole && score.time_to_trachea_visible_s >= 0.0, score.time_to_trachea_visible_s,
          whole ? "never" : "not counted");
  time_or("attempt time", whole && score.attempt_begun, score.attempt_time_s, whole ? "no attempt" : "not counted");
  line("time over the training target", score.time_over_target_s, 2, "s");
  line("time over the device limit", score.time_over_force_limit_s, 2, "s");
  if (score.intubation) print_intubation(out, score, scenario);
  print_rows(out, technique_rows(score));
  if (!score.pauses.empty()) line("paused", score.paused_s, 2, "s, " + pauses_in_words(score));
  if (score.loop_rate_hz > 0.0) line("servo loop", score.loop_rate_hz, 1, "Hz");
  line("deadline misses", static_cast<double>(score.deadline_misses), 0,
       "of " + std::to_string(score.ticks) + " ticks");
  line("simulation steps dropped", static_cast<double>(score.overruns), 0,
       "(ticks whose step was not finished in time)");
  if (!score.real_time_setup.empty()) out << "  real-time set-up: " << score.real_time_setup << "\n";
  for (const std::string& reason : score.reasons) out << "  - " << reason << "\n";
  for (const std::string& points : points_lines(score, scenario)) out << "  " << points << "\n";
  for (const curricula::ChecklistItem& one : score.checklist)
    out << "  " << std::left << std::setw(9) << name_of(one.done) << one.text << " (" << one.sentence << ")\n";
}

}  // namespace vallecula::gui
