#include "curricula/read_scenario.h"

#include <algorithm>
#include <cmath>

#include "curricula/read_intubation.h"
#include "curricula/schema/read_value.h"

namespace vallecula::curricula {
namespace {

/// Weights of newborn infants, kg: 0.65 at 24, 3.1 at 38 weeks (growth chart), along one exponential between and
/// beyond.
double usual_weight(double weeks) { return 0.65 * std::exp(std::log(3.1 / 0.65) / 14.0 * (weeks - 24.0)); }
constexpr double kLightestShare = 0.5,
                 kHeaviestShare = 1.6;  // of the usual weight (assumed): else the trachea fits no infant

/// `weeks` is the gestation that the field `weeks_name` gives the infant of `manikin`.
void refuse_unusual_weight(const YAML::Node& manikin, double weeks, const char* weeks_name, const Validator& rules,
                           const std::string& path) {
  const double usual = usual_weight(weeks), weight = checked_number(manikin["weight_kg"]);
  const double low = std::ceil(100.0 * kLightestShare * usual) / 100.0;
  const double high = std::floor(100.0 * kHeaviestShare * usual) / 100.0;
  if (weight < low || weight > high)
    rules.fail(manikin["weight_kg"], path + "weight_kg",
               "from " + with_unit(low, "kg") + " to " + with_unit(high, "kg") + " at " + with_unit(weeks, "weeks") +
                   " (" + weeks_name + ")");
}

ManikinSpec read_manikin(const YAML::Node& node, const Validator& rules, const std::string& path) {
  ManikinSpec manikin;
  read(node["weight_kg"], manikin.weight_kg);
  read(node["seed"], manikin.seed);
  read(node["gestation_weeks"], manikin.gestation_weeks);
  read(node["mouth_opening"], manikin.mouth_opening);
  read(node["tongue_size"], manikin.tongue_size);
  read(node["larynx_height_mm"], manikin.larynx_height_mm);
  read(node["epiglottis_length"], manikin.epiglottis_length);
  if (manikin.gestation_weeks)
    refuse_unusual_weight(node, *manikin.gestation_weeks, "gestation_weeks", rules, path);
  return manikin;
}

void read_limits(const YAML::Node& node, Scenario& s, const Validator& rules, const std::string& path) {
  const YAML::Node targets = node["targets"], pass = node["pass"];
  read(node["sight_percent"], s.sight_percent);
  read(node["max_attempt_s"], s.max_attempt_s);
  read(targets["tongue_force_n"], s.targets.tongue_force_n);
  read(targets["gum_force_n"], s.targets.gum_force_n);
  read(pass["peak_tongue_force_n"], s.pass.peak_tongue_force_n);
  read(pass["peak_gum_force_n"], s.pass.peak_gum_force_n);
  read(pass["glottis_visible_percent"], s.pass.glottis_visible_percent);
  read(pass["attempt_time_s"], s.pass.attempt_time_s);
  read(pass["time_over_target_s"], s.pass.time_over_target_s);
  read(pass["time_over_device_limit_s"], s.pass.time_over_device_limit_s);

  const auto at_most = [&](const YAML::Node& what, const std::string& name, double limit, const char* limit_name,
                           const char* unit) {
    if (checked_number(what) > limit) {
      rules.fail(what, path + name, "at most " + std::string(limit_name) + " = " + with_unit(limit, unit));
    }
  };
  at_most(targets["tongue_force_n"], "targets.tongue_force_n", s.pass.peak_tongue_force_n, "pass.peak_tongue_force_n",
          "N");
  at_most(targets["gum_force_n"], "targets.gum_force_n", s.pass.peak_gum_force_n, "pass.peak_gum_force_n", "N");
  at_most(node["sight_percent"], "sight_percent", s.pass.glottis_visible_percent, "pass.glottis_visible_percent",
          "percent");
  at_most(pass["attempt_time_s"], "pass.attempt_time_s", s.max_attempt_s, "max_attempt_s", "s");
}

std::map<std::string, PassMark> read_rubric(const YAML::Node& scenario, const Validator& rules,
                                            const std::string& path) {
  std::map<std::string, PassMark> rubric;
  const std::vector<std::string> marks = marks_of(scenario);
  for (const auto& entry : scenario["rubric"]) {
    const std::string name = entry.first.Scalar();
    if (std::find(marks.begin(), marks.end(), name) == marks.end()) {
      std::string known;
      for (const std::string& mark : marks) known += (known.empty() ? "" : ", ") + mark;
      rules.fail(entry.second, path + "rubric." + name, "the pass marks of this scenario, " + known);
    }
    PassMark& mark = rubric[name];
    read(entry.second["weight"], mark.weight);
    read(entry.second["source"], mark.source);
  }
  return rubric;
}

std::vector<Distraction> read_distractions(const YAML::Node& list, double max_attempt_s, const Validator& rules,
                                           const std::string& path) {
  std::vector<Distraction> distractions;
  for (std::size_t i = 0; list && i < list.size(); ++i) {
    const YAML::Node node = list[i];
    const std::string here = path + "distractions[" + std::to_string(i) + "].";
    const std::string kind = node["kind"].Scalar();
    Distraction d;
    d.kind = kind == "question" ? Distraction::Kind::question
             : kind == "alarm"  ? Distraction::Kind::alarm
                                : Distraction::Kind::talk;
    read(node["at_s"], d.at_s);
    read(node["text"], d.text);
    read(node["answers"], d.answers);
    read(node["right_answer"], d.right_answer);
    read(node["time_allowed_s"], d.time_allowed_s);
    const auto only_where = [&](bool wanted, const char* field) {
      if (wanted && !node[field]) rules.fail_missing(node, here + field, "needed where kind is " + kind);
      if (!wanted && node[field]) rules.fail(node[field], here + field, "none where kind is " + kind);
    };
    only_where(d.kind == Distraction::Kind::question, "answers");
    only_where(d.kind == Distraction::Kind::question, "right_answer");
    only_where(d.kind != Distraction::Kind::talk, "time_allowed_s");
    if (d.right_answer > static_cast<int>(d.answers.size()))
      rules.fail(node["right_answer"], here + "right_answer",
                 "from 1 to the number of answers, " + std::to_string(d.answers.size()));
    if (d.at_s + d.time_allowed_s > max_attempt_s)
      rules.fail(node["at_s"], here + "at_s",
                 "so early that it ends with the trial, max_attempt_s = " + with_unit(max_attempt_s, "s"));
    if (!distractions.empty() && d.at_s < distractions.back().at_s)
      rules.fail(node["at_s"], here + "at_s",
                 "not before the one above it, " + with_unit(distractions.back().at_s, "s"));
    distractions.push_back(std::move(d));
  }
  return distractions;
}

Variation read_variation(const YAML::Node& node, const Scenario& s, const Validator& rules, const std::string& path) {
  Variation v;
  const auto range = [&](const char* field, Variation::Range& value, bool possible, const char* needs) {
    const YAML::Node given = node[field];
    if (!given) return;
    if (!possible) rules.fail(given, path + field, std::string("none without ") + needs);
    read(given, value);
    if ((*value)[0] > (*value)[1])
      rules.fail(given[1], path + field + "[1]", "at least the first, " + given[0].Scalar());
  };
  read(node["infants"], v.infants);
  const bool several = v.infants > 1;
  range("mouth_opening", v.mouth_opening, several, "infants: a shape is an infant's");
  range("tongue_size", v.tongue_size, several, "infants: a shape is an infant's");
  range("larynx_height_mm", v.larynx_height_mm, several, "infants: a shape is an infant's");
  range("epiglottis_length", v.epiglottis_length, several, "infants: a shape is an infant's");
  range("tongue_young_pa", v.tongue_young_pa, true, "");
  range("secretions_ml", v.secretions_ml, s.intubation.has_value(), "an intubation");
  if (v.secretions_ml && (*v.secretions_ml)[1] > 0.0 && s.intubation->catheter_f == 0)
    rules.fail(node["secretions_ml"][1], path + "secretions_ml[1]",
               "0 where intubation.catheter_f is 0: nothing is at hand to clear them with");
  range("distraction_delay_s", v.distraction_delay_s, !s.distractions.empty(), "distractions");
  read(node["infant_seed"], v.infant_seed);
  if (v.infant_seed && !s.intubation)
    rules.fail(node["infant_seed"], path + "infant_seed", "false without an intubation");
  if (v.distraction_delay_s)
    for (const Distraction& d : s.distractions)
      if (d.at_s + d.time_allowed_s + (*v.distraction_delay_s)[1] > s.max_attempt_s)
        rules.fail(
            node["distraction_delay_s"][1], path + "distraction_delay_s[1]",
            "so little that every distraction ends with the trial, max_attempt_s = " + with_unit(s.max_attempt_s, "s"));
  return v;
}

/// The list of what is offered, with the right one among them.
std::vector<std::string> read_offered(const YAML::Node& list, const std::string& right, const char* right_name,
                                      const Validator& rules, const std::string& path) {
  std::vector<std::string> offered;
  read(list, offered);
  for (std::size_t i = 0; i < offered.size(); ++i)
    if (std::find(offered.begin(), offered.begin() + static_cast<std::ptrdiff_t>(i), offered[i]) !=
        offered.begin() + static_cast<std::ptrdiff_t>(i))
      rules.fail(list[i], path + "[" + std::to_string(i) + "]", "each once");
  if (!offered.empty() && std::find(offered.begin(), offered.end(), right) == offered.end())
    rules.fail(list, path, "the right one among them, " + std::string(right_name) + " = " + right);
  return offered;
}

/// What was taken in place of the right one, which is remembered.
void take(const YAML::Node& taken, const std::vector<std::string>& offered, std::string& used, std::string& right,
          const Validator& rules, const std::string& path) {
  if (!taken) return;
  if (std::find(offered.begin(), offered.end(), taken.Scalar()) == offered.end())
    rules.fail(taken, path, "one of what the scenario offers");
  right = used;
  used = taken.Scalar();
}

}  // namespace

std::vector<std::string> marks_of(const YAML::Node& scenario) {
  std::vector<std::string> marks;
  for (const auto& entry : scenario["pass"]) marks.push_back(entry.first.Scalar());
  if (scenario["offered_blades"]) marks.emplace_back("right_blade");
  const YAML::Node intubation = scenario["intubation"];
  if (!intubation) return marks;
  if (intubation["offered_tubes"]) marks.emplace_back("right_tube");
  marks.emplace_back("outcomes");  // judged whether it is written or not
  for (const auto& entry : intubation["pass"])
    if (entry.first.Scalar() != "outcomes") marks.push_back(entry.first.Scalar());
  return marks;
}

Scenario read_scenario(const YAML::Node& node, const Validator& rules, const std::string& path) {
  Scenario s;
  read(node["id"], s.id);
  read(node["title"], s.title);
  read(node["briefing"], s.briefing);
  read(node["debriefing"], s.debriefing);
  read(node["after"], s.after);
  s.manikin = read_manikin(node["manikin"], rules, path + "manikin.");
  read(node["blade"], s.blade);
  s.offered_blades = read_offered(node["offered_blades"], s.blade, "blade", rules, path + "offered_blades");
  read(node["tongue_young_pa"], s.tongue_young_pa);
  read_limits(node, s, rules, path);
  if (const YAML::Node intubation = node["intubation"]) {
    s.intubation = read_intubation(intubation, rules, path + "intubation.");
    s.intubation->offered_tubes = read_offered(intubation["offered_tubes"], s.intubation->tube, "tube", rules,
                                               path + "intubation.offered_tubes");
    const auto& weeks = s.manikin.gestation_weeks;
    if (weeks && *weeks != s.intubation->gestation_weeks)
      rules.fail(intubation["gestation_weeks"], path + "intubation.gestation_weeks",
                 "the same as manikin.gestation_weeks = " + with_unit(*weeks, "weeks"));
    refuse_unusual_weight(node["manikin"], s.intubation->gestation_weeks, "intubation.gestation_weeks", rules,
                          path + "manikin.");
  }
  s.rubric = read_rubric(node, rules, path);
  if (const YAML::Node helps = node["assistance"]) {
    read(helps["ghost_path"], s.assistance.ghost_path);
    read(helps["glottis_highlight"], s.assistance.glottis_highlight);
    read(helps["cut_view"], s.assistance.cut_view);
    read(helps["force_bar"], s.assistance.force_bar);
    read(helps["video_view"], s.assistance.video_view);
    read(helps["expert_loop"], s.assistance.expert_loop);
  }
  s.distractions = read_distractions(node["distractions"], s.max_attempt_s, rules, path);
  if (const YAML::Node variation = node["variation"])
    s.variation = read_variation(variation, s, rules, path + "variation.");
  if (const YAML::Node attempt = node["attempt"]) {
    s.attempt.mode = attempt["mode"].Scalar() == "assessment" ? Mode::assessment : Mode::practice;
    read(attempt["seed"], s.attempt.seed);
    take(attempt["blade"], s.offered_blades, s.blade, s.attempt.right_blade, rules, path + "attempt.blade");
    if (s.intubation)
      take(attempt["tube"], s.intubation->offered_tubes, s.intubation->tube, s.attempt.right_tube, rules,
           path + "attempt.tube");
    else if (attempt["tube"])
      rules.fail(attempt["tube"], path + "attempt.tube", "none without an intubation");
  }
  return s;
}

}  // namespace vallecula::curricula
