// score.json: the score for programs and for people with an editor.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

#include "curricula/qt_text.h"
#include "curricula/score/figures_json.h"
#include "curricula/score/intubation_json.h"
#include "curricula/score/points.h"
#include "curricula/score/score.h"

namespace vallecula::curricula {
namespace {

QJsonObject use_to_json(const Use& use) {
  return {{"times", use.times},
          {"for_s", number_or_null(use.for_s)},
          {"first_s", number_or_null(use.first_s, use.first_s >= 0.0)}};
}

}  // namespace

QJsonValue number_or_null(double value, bool exists) {
  return exists && std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

std::string score_to_json(const Score& score, const TrialLog& log, const Scenario& scenario) {
  QJsonObject o;
  o["peak_tongue_force_n"] = number_or_null(score.peak_tongue_force_n);
  o["time_to_trachea_visible_s"] =
      number_or_null(score.time_to_trachea_visible_s, score.time_to_trachea_visible_s >= 0.0);
  o["glottis_visible_max_percent"] = number_or_null(score.glottis_visible_max_percent);
  o["peak_gum_force_n"] = number_or_null(score.peak_gum_force_n);
  o["attempt_time_s"] = number_or_null(score.attempt_time_s);
  o["paused_s"] = number_or_null(score.paused_s);
  QJsonArray pauses;
  for (const Pause& pause : score.pauses) {
    QJsonObject one;
    one["at_s"] = number_or_null(pause.at_s);
    one["for_s"] = number_or_null(pause.for_s);
    one["fault"] = pause.fault.empty() ? QJsonValue(QJsonValue::Null) : QJsonValue(text(pause.fault));
    pauses.append(one);
  }
  o["pauses"] = pauses;
  o["time_over_force_limit_s"] = number_or_null(score.time_over_force_limit_s);
  o["time_over_target_s"] = number_or_null(score.time_over_target_s);
  o["loop_rate_hz"] = number_or_null(score.loop_rate_hz, score.loop_rate_hz > 0.0);
  o["deadline_misses"] = static_cast<qint64>(score.deadline_misses);
  o["ticks"] = static_cast<qint64>(score.ticks);
  o["passed"] = score.passed;
  QJsonArray reasons;
  for (const std::string& reason : score.reasons) reasons.append(text(reason));
  o["reasons"] = reasons;
  QJsonArray aside;
  for (const std::string& why : score.set_aside) aside.append(text(why));
  o["set_aside"] = aside;
  o["at_vallecula"] = score.at_vallecula;
  o["no_attempt"] = score.no_attempt;
  o["eye_moves"] = use_to_json(score.eye_moves);
  o["head_extension"] = use_to_json(score.extension);
  o["shown_or_told"] = use_to_json(score.aided);
  o["instructor"] = QJsonObject{{"saturation", use_to_json(score.saturation_driven)},
                                {"heart", use_to_json(score.heart_driven)},
                                {"laryngospasm", use_to_json(score.spasm_driven)}};

  o["time_of_peak_tongue_force_s"] = number_or_null(score.time_of_peak_tongue_force_s, score.peak_tongue_force_n > 0.0);
  o["time_of_peak_gum_force_s"] = number_or_null(score.time_of_peak_gum_force_s, score.peak_gum_force_n > 0.0);
  o["peak_epiglottis_force_n"] = number_or_null(score.peak_force_n[kEpiglottis]);
  o["peak_palate_force_n"] = number_or_null(score.peak_force_n[kPalate]);
  o["peak_teeth_force_n"] = number_or_null(score.peak_force_n[kTeeth]);
  o["peak_larynx_force_n"] = number_or_null(score.peak_force_n[kLarynx]);
  o["peak_displayed_force_n"] = number_or_null(score.peak_displayed_force_n);
  o["attempt_begun"] = score.attempt_begun;
  o["attempt_start_s"] = number_or_null(score.attempt_start_s, score.attempt_begun);
  o["blade_out"] = score.blade_out;
  o["mouth_entries"] = score.mouth_entries;
  o["trial_complete"] = score.complete;
  o["ended"] = text(log.footer.ended);
  o["overruns"] = static_cast<qint64>(score.overruns);
  o["real_time_setup"] = text(score.real_time_setup);
  o["scenario_id"] = text(scenario.id);
  o["scenario_title"] = text(scenario.title);
  o["package_name"] = text(log.header.package_name);
  o["mode"] = name_of(scenario.attempt.mode);
  o["attempt_seed"] = static_cast<qint64>(scenario.attempt.seed);
  o["device_kind"] = text(log.header.device_kind);
  o["device_limit_n"] = number_or_null(log.header.device_limit_n);
  o["realtime"] = log.header.realtime;
  o["software_version"] = text(log.header.software_version);
  QJsonArray criteria;
  for (const Criterion& c : score.criteria) {
    QJsonObject line;
    line["name"] = text(c.name);
    line["unit"] = text(c.unit);
    line["value"] = number_or_null(c.value);
    line["limit"] = number_or_null(c.limit);
    line["at_s"] = number_or_null(c.at_s, c.at_s >= 0.0);
    line["met"] = c.met;
    line["sentence"] = text(c.sentence);
    criteria.append(line);
  }
  o["criteria"] = criteria;
  QJsonArray points;
  double earned = 0.0;
  for (const MarkPoints& mark : points_of(score, scenario)) {
    QJsonObject line;
    line["mark"] = text(mark.mark);
    line["of"] = mark.of;
    line["earned"] = mark.earned;
    line["at_s"] = number_or_null(mark.at_s, mark.at_s >= 0.0);
    line["sentence"] = text(mark.sentence);
    line["source"] = text(mark.source);
    points.append(line);
    earned += mark.earned;
  }
  o["points"] = points;
  o["points_of_100"] = number_or_null(earned, !points.isEmpty());
  add_figures(score, o);
  if (score.intubation) o["intubation"] = intubation_to_json(*score.intubation);
  return QJsonDocument(o).toJson(QJsonDocument::Indented).trimmed().toStdString();
}

}  // namespace vallecula::curricula
