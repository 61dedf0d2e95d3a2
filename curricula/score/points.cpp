#include "curricula/score/points.h"

#include <utility>

namespace vallecula::curricula {
namespace {

/// The pass field that a criterion judges; empty for one that no field sets (that the trial is complete).
std::string mark_of(const std::string& criterion) {
  for (const auto& [name, mark] :
       {std::pair{"outcome", "outcomes"}, std::pair{"glottis_visible_max_percent", "glottis_visible_percent"},
        std::pair{"time_over_force_limit_s", "time_over_device_limit_s"}})
    if (criterion == name) return mark;
  for (const char* same : {"peak_tongue_force_n", "peak_gum_force_n", "attempt_time_s", "time_over_target_s",
                           "lowest_spo2_percent", "lowest_heart_per_min", "tube_force_n", "time_to_pass_s", "attempts",
                           "co2_confirmed", "depth_neutral", "oesophagus_in_time",
                           "no_severe_desaturation", "right_blade", "right_tube"})
    if (criterion == same) return criterion;
  return "";
}

}  // namespace

std::string source_of(const Scenario& scenario, const std::string& mark) {
  const auto found = scenario.rubric.find(mark);
  return (found == scenario.rubric.end() ? "no source given" : found->second.source) + "; not validated";
}

std::vector<MarkPoints> points_of(const Score& score, const Scenario& scenario) {
  if (score.at_vallecula) return {};  // half of a trial earns no whole score
  std::vector<MarkPoints> all;
  const bool judged = score.complete && score.attempt_begun;  // whoever did nothing has kept every limit
  double weights = 0.0;
  for (const Criterion& c : score.criteria) {
    const std::string mark = mark_of(c.name);
    if (mark.empty()) continue;
    const auto found = scenario.rubric.find(mark);
    const double weight = found == scenario.rubric.end() ? PassMark{}.weight : found->second.weight;
    weights += weight;
    all.push_back({mark, weight, judged && c.met ? weight : 0.0, c.at_s, c.sentence, source_of(scenario, mark)});
  }
  if (!(weights > 0.0)) return {};
  for (MarkPoints& points : all) {
    points.of *= 100.0 / weights;
    points.earned *= 100.0 / weights;
  }
  return all;
}

}  // namespace vallecula::curricula
