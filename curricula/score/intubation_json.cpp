#include "curricula/score/intubation_json.h"

#include <QJsonArray>

namespace vallecula::curricula {
namespace {

QJsonValue number_or_null(const std::optional<double>& value) {
  return curricula::number_or_null(value.value_or(0.0), value.has_value());
}

QJsonObject peak_to_json(const Peak& peak) {
  QJsonObject o;
  o["value"] = curricula::number_or_null(peak.value);
  o["at_s"] = curricula::number_or_null(peak.at_s, peak.at_s >= 0.0);
  return o;
}

QJsonObject attempt_to_json(const Attempt& attempt) {
  QJsonObject o;
  o["start_s"] = attempt.start_s;
  o["end_s"] = attempt.end_s;
  o["time_s"] = attempt.time_s;
  o["paused_s"] = attempt.paused_s;
  o["breaths_before"] = attempt.breaths_before;
  o["time_to_view_s"] = number_or_null(attempt.time_to_view_s);
  o["time_to_pass_s"] = number_or_null(attempt.time_to_pass_s);
  o["passed_cords_s"] = number_or_null(attempt.passed_cords_s);
  o["highest_spo2_before_percent"] =
      curricula::number_or_null(attempt.highest_spo2_before_percent, attempt.highest_spo2_before_percent >= 0.0);
  o["lowest_spo2_percent"] = curricula::number_or_null(attempt.lowest_spo2_percent);
  o["lowest_heart_per_min"] = curricula::number_or_null(attempt.lowest_heart_per_min);
  o["desaturated"] = attempt.desaturated;
  o["bradycardia"] = attempt.bradycardia;
  return o;
}

}  // namespace

QJsonObject intubation_to_json(const IntubationScore& score) {
  QJsonObject o;
  o["outcome"] = name_of(score.outcome);
  QJsonArray attempts;
  for (const Attempt& attempt : score.attempts) attempts.append(attempt_to_json(attempt));
  o["attempts"] = attempts;
  const Attempt* decisive = score.decisive();
  o["time_to_view_s"] = number_or_null(decisive ? decisive->time_to_view_s : std::nullopt);
  o["time_to_pass_s"] = number_or_null(decisive ? decisive->time_to_pass_s : std::nullopt);
  o["cords_to_carina_m"] = score.cords_to_carina_m;
  o["depth_m"] = number_or_null(score.depth_m);
  o["depth_error_m"] = number_or_null(score.depth_error_m());
  o["depth_percent"] = curricula::number_or_null(100.0 * score.depth_share().value_or(0.0), score.depth_m.has_value());
  o["depth_neutral_m"] = number_or_null(score.depth_neutral_m);
  o["depth_neutral_percent"] =
      curricula::number_or_null(100.0 * score.depth_neutral_share().value_or(0.0), score.depth_neutral_m.has_value());
  o["at_lips_m"] = number_or_null(score.at_lips_m);
  o["at_lips_by_weight_m"] = score.lips_rule_m;
  o["main_bronchus"] =
      score.bronchus_side < 0 ? QJsonValue(QJsonValue::Null) : QJsonValue(score.bronchus_side == 0 ? "right" : "left");
  o["deepest_m"] = score.deepest_m;
  o["lowest_spo2_percent"] = number_or_null(score.lowest_spo2_percent);
  o["lowest_spo2_at_s"] = curricula::number_or_null(score.lowest_spo2_at_s, score.lowest_spo2_at_s >= 0.0);
  o["lowest_heart_per_min"] = number_or_null(score.lowest_heart_per_min);
  o["lowest_heart_at_s"] = curricula::number_or_null(score.lowest_heart_at_s, score.lowest_heart_at_s >= 0.0);
  o["breaths_given"] = score.breaths_given;
  o["co2_confirmed"] = score.co2_confirmed;
  o["co2_breaths"] = score.co2_breaths ? QJsonValue(*score.co2_breaths) : QJsonValue(QJsonValue::Null);
  o["breaths_in_place"] = score.breaths_in_place;
  o["oesophagus_entries"] = score.oesophagus_entries;
  o["oesophagus_breaths"] = score.oesophagus_breaths;
  o["oesophagus_s"] = score.oesophagus_s;
  o["oesophagus_recognised_late"] = score.recognised_late;
  o["peak_tip_load_n"] = peak_to_json(score.tip_load_n);
  o["tip_against"] = score.tip_against < kTubeLoads
                         ? QJsonValue(name_of(static_cast<LoggedTubeLoad>(score.tip_against)))
                         : QJsonValue(QJsonValue::Null);
  QJsonObject loads;
  for (std::size_t part = 0; part < kTubeLoads; ++part)
    loads[name_of(static_cast<LoggedTubeLoad>(part))] = peak_to_json(score.loads_n[part]);
  o["peak_loads_n"] = loads;
  o["peak_hand_force_n"] = peak_to_json(score.hand_force_n);
  o["peak_displayed_hand_force_n"] = peak_to_json(score.displayed_hand_force_n);
  o["buckled_m"] = score.buckled_m;
  o["secretions_start_ml"] = curricula::number_or_null(score.secretions_start_ml);
  o["secretions_end_ml"] = curricula::number_or_null(score.secretions_end_ml);
  return o;
}

}  // namespace vallecula::curricula
