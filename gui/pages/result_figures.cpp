#include "gui/pages/result_figures.h"

#include "gui/report/report.h"
#include "gui/session/keeps_up.h"

namespace vallecula::gui {
namespace {

constexpr double kWorthTellingN = 0.5;  // a lighter touch of the larynx is every laryngoscopy's

std::string seconds(const std::optional<double>& time_s) { return time_s ? number(*time_s, 1) + " s" : "never"; }

std::vector<Row> tube_figures(const curricula::Score& score, const curricula::Scenario& scenario) {
  const curricula::IntubationScore& tube = *score.intubation;
  const curricula::Attempt* decisive = tube.decisive();
  const auto lowest = [&](const std::string& name, const std::optional<double>& value, const std::string& told,
                          const std::string& criterion) {
    return value ? row(score, name, told, criterion, "at least") : no_attempt(name);
  };
  std::vector<Row> rows = {
      {"Tip past the cords", tube.depth_m ? number(1e3 * *tube.depth_m, 0) + " mm" : std::string("not there"),
       tube.depth_m ? number(100.0 * *tube.depth_share(), 0) + " % of the way; good: 33 to 67 %" : std::string(), ""},
      lips_row(tube),
      attempts_row(score),
      lowest("Lowest SpO2", tube.lowest_spo2_percent,
             curricula::told_spo2(tube.lowest_spo2_percent.value_or(0.0)) + " %", "lowest_spo2_percent"),
      lowest("Lowest heart rate", tube.lowest_heart_per_min,
             number(tube.lowest_heart_per_min.value_or(0.0), 0) + " /min", "lowest_heart_per_min"),
  };
  if (!score.at_vallecula) {
    rows.push_back({"Time to view", seconds(decisive != nullptr ? decisive->time_to_view_s : std::nullopt), "", ""});
    rows.push_back(row(score, "Time to pass", seconds(decisive != nullptr ? decisive->time_to_pass_s : std::nullopt),
                       "time_to_pass_s", "at most"));
  }
  rows.push_back(row(score, "CO2 detector",
                     tube.co2_confirmed ? "yellow, breath " + std::to_string(*tube.co2_breaths) : "never yellow",
                     "co2_confirmed", "by breath"));
  rows.push_back(
      tube_force_row(score, scenario, "Peak force at the tube's tip", number(tube.tip_load_n.value, 1) + " N"));
  rows.push_back({"Peak force on the tube's hand", number(tube.hand_force_n.value, 1) + " N", "", ""});
  if (tube.oesophagus_breaths > 0)
    rows.push_back({"In the oesophagus", std::to_string(tube.oesophagus_breaths) + " breaths",
                    tube.recognised_late ? "recognised late" : "", ""});
  return rows;
}

}  // namespace

std::vector<Row> result_figures(const TrialOutcome& outcome, const curricula::Scenario& scenario) {
  const auto& score = outcome.score;
  std::vector<Row> rows;
  if (score.intubation) rows = tube_figures(score, scenario);
  const curricula::PassLimits& pass = scenario.pass;
  rows.push_back(limit_row(score, "Peak force, tongue", number(score.peak_tongue_force_n, 1) + " N",
                           "peak_tongue_force_n", pass.peak_tongue_force_n, "N"));
  rows.push_back(limit_row(score, "Peak force, gum", number(score.peak_gum_force_n, 1) + " N", "peak_gum_force_n",
                           pass.peak_gum_force_n, "N"));
  if (score.peak_force_n[curricula::kLarynx] > kWorthTellingN)
    rows.push_back({"Peak force, larynx", number(score.peak_force_n[curricula::kLarynx], 1) + " N", "", ""});
  rows.push_back(row(score, "Glottis visible, best", number(score.glottis_visible_max_percent, 0) + " %",
                     "glottis_visible_max_percent", "at least"));
  if (!score.intubation && !score.at_vallecula)
    rows.push_back({"Time to sight",
                    score.time_to_trachea_visible_s < 0.0 ? "never" : number(score.time_to_trachea_visible_s, 1) + " s",
                    "from " + number(scenario.sight_percent, 0) + " %", ""});
  rows.push_back(attempt_row(
      score, scenario, score.intubation && score.intubation->attempts.size() > 1 ? "Longest attempt" : "Attempt"));
  rows.push_back(limit_row(score, "Over the target, tongue", number(score.time_over_target_s, 1) + " s", "time_over_target_s",
                           pass.time_over_target_s, "s"));
  rows.push_back(limit_row(score, "Over the device limit", number(score.time_over_force_limit_s, 1) + " s",
                           "time_over_force_limit_s", pass.time_over_device_limit_s, "s"));
  if (!score.pauses.empty()) rows.push_back({"Paused", number(score.paused_s, 1) + " s", pauses_in_words(score), ""});
  const bool fast = keeps_up(score.ticks, score.deadline_misses, score.overruns);
  rows.push_back({"Computer",
                  score.loop_rate_hz <= 0.0 ? "not in real time"
                  : fast                    ? "kept up"
                                            : "too slow",
                  fast ? "" : "forces came late", ""});
  return rows;
}

}  // namespace vallecula::gui
