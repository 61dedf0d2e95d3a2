#include "curricula/score/figures_json.h"

#include <QJsonArray>

#include "curricula/qt_text.h"
#include "curricula/score/intubation_json.h"

namespace vallecula::curricula {
namespace {

QJsonValue value_or_null(const std::optional<double>& value) {
  return number_or_null(value.value_or(0.0), value.has_value());
}
QJsonValue second_or_null(double at_s) { return number_or_null(at_s, at_s >= 0.0); }

QJsonObject force_to_json(const ForceFigures& force) {
  const std::optional<Peak>& pressed = force.tongue_pressure_pa;
  return {{"mean_tongue_force_n", value_or_null(force.mean_tongue_n)},
          {"tongue_force_integral_ns", number_or_null(force.tongue_integral_ns)},
          {"tongue_contact_s", force.tongue_contact_s},
          {"peak_tongue_pressure_pa", number_or_null(pressed ? pressed->value : 0.0, pressed.has_value())},
          {"peak_tongue_pressure_at_s", second_or_null(pressed ? pressed->at_s : -1.0)},
          {"lift_share", value_or_null(force.lift_share)},
          {"peak_levered_n", number_or_null(force.levered_n.value)},
          {"peak_levered_at_s", second_or_null(force.levered_n.at_s)},
          {"levered_over_target_s", force.levered_over_target_s},
          {"levered_over_target_at_s", second_or_null(force.levered_over_target_at_s)}};
}

QJsonObject view_to_json(const Score& score) {
  const std::optional<int> grade = cormack_lehane(score.glottis_visible_max_percent);
  return {{"mean_glottis_visible_percent", value_or_null(score.view.mean_percent)},
          {"in_sight_s", score.view.in_sight_s},
          {"time_to_stable_view_s", value_or_null(score.view.time_to_stable_s)},
          {"stable_view_at_s", second_or_null(score.view.stable_at_s)},
          {"cormack_lehane", grade ? QJsonValue(*grade) : QJsonValue(QJsonValue::Null)}};
}

QJsonObject blade_to_json(const BladeFigures& blade) {
  return {{"entry_left_m", value_or_null(blade.entry_left_m)},
          {"to_vallecula_m", value_or_null(blade.to_vallecula_m)},
          {"to_vallecula_at_s", second_or_null(blade.to_vallecula_at_s)},
          {"left_m", value_or_null(blade.left_m)},
          {"vallecula_reached", blade.vallecula_reached},
          {"vallecula_reached_at_s", second_or_null(blade.vallecula_reached_at_s)},
          {"past_vallecula_m", number_or_null(blade.past_vallecula_m)},
          {"past_vallecula_at_s", second_or_null(blade.past_vallecula_at_s)}};
}

const char* name_of(Reaction::Result result) {
  switch (result) {
    case Reaction::Result::right:
      return "right";
    case Reaction::Result::wrong:
      return "wrong";
    case Reaction::Result::missed:
      return "missed";
    case Reaction::Result::open:
      break;
  }
  return "open";
}

QJsonObject dual_task_to_json(const DualTask& task) {
  QJsonArray reactions;
  for (const Reaction& one : task.reactions)
    reactions.append(QJsonObject{{"distraction", one.distraction},
                                 {"shown_at_s", one.shown_at_s},
                                 {"result", name_of(one.result)},
                                 {"reaction_s", value_or_null(one.reaction_s)}});
  return {{"reactions", reactions},
          {"right", task.right},
          {"wrong", task.wrong},
          {"missed", task.missed},
          {"false_answers", task.false_answers},
          {"errors", task.errors()},
          {"mean_reaction_s", value_or_null(task.mean_reaction_s)}};
}

QJsonArray checklist_to_json(const std::vector<ChecklistItem>& checklist) {
  QJsonArray items;
  for (const ChecklistItem& one : checklist)
    items.append(QJsonObject{{"id", text(one.id)},
                             {"text", text(one.text)},
                             {"done", name_of(one.done)},
                             {"at_s", second_or_null(one.at_s)},
                             {"sentence", text(one.sentence)}});
  return items;
}

}  // namespace

void add_figures(const Score& score, QJsonObject& o) {
  o["force"] = force_to_json(score.force);
  o["view"] = view_to_json(score);
  o["blade"] = blade_to_json(score.blade);
  o["motion"] = QJsonObject{{"tip_path_m", number_or_null(score.motion.tip_path_m)}};
  o["for_researchers"] = QJsonObject{{"smoothness_sparc", value_or_null(score.motion.smoothness)},
                                     {"tremor_m", value_or_null(score.motion.tremor_m)}};
  if (score.dual_task) o["dual_task"] = dual_task_to_json(*score.dual_task);
  o["checklist"] = checklist_to_json(score.checklist);
  QJsonArray words;
  for (const char* word : kGlobalRatingWords) words.append(word);
  o["global_rating"] = QJsonObject{{"given", QJsonValue::Null}, {"of", words}};
}

}  // namespace vallecula::curricula
