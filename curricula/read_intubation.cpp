// The intubation of a scenario, and the rules about it that no schema can say: what contradicts what.
#include "curricula/read_intubation.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "curricula/schema/read_value.h"

namespace vallecula::curricula {
namespace {

constexpr std::array<std::pair<Outcome, const char*>, kOutcomes> kOutcomeNames = {{
    {Outcome::good_depth, "good-depth"},
    {Outcome::too_shallow, "too-shallow"},
    {Outcome::too_deep, "too-deep"},
    {Outcome::mainstem, "mainstem"},
    {Outcome::oesophagus, "oesophagus"},
    {Outcome::cricoid_too_narrow, "cricoid-too-narrow"},
    {Outcome::cords_closed, "cords-closed"},
    {Outcome::abandoned, "abandoned"},
    {Outcome::out_of_time, "out-of-time"},
}};

struct CourseRow {
  const char* name;
  InfantCourse course;
  bool premedicated;  ///< where the scenario does not say
};
constexpr std::array<CourseRow, 4> kCourses = {{
    {"premedicated-preterm", InfantCourse::premedicated_preterm, true},
    {"term", InfantCourse::term, false},
    {"preoxygenated", InfantCourse::preoxygenated, true},
    {"delivery-room", InfantCourse::delivery_room, false},
}};

/// The published preterm course holds up to here (Kothari 2021).
constexpr double kPretermWeeks = 32.0;

IntubationPass read_pass(const YAML::Node& node, const Validator& rules, const std::string& path) {
  IntubationPass pass;
  if (!node) return pass;
  if (const YAML::Node outcomes = node["outcomes"]) {
    pass.outcomes.clear();
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const Outcome outcome = *outcome_named(outcomes[i].Scalar());
      if (std::count(pass.outcomes.begin(), pass.outcomes.end(), outcome) != 0)
        rules.fail(outcomes[i], path + "outcomes[" + std::to_string(i) + "]", "each outcome once");
      pass.outcomes.push_back(outcome);
    }
  }
  read(node["lowest_spo2_percent"], pass.lowest_spo2_percent);
  read(node["lowest_heart_per_min"], pass.lowest_heart_per_min);
  read(node["tube_force_n"], pass.tube_force_n);
  read(node["time_to_pass_s"], pass.time_to_pass_s);
  read(node["attempts"], pass.attempts);
  read(node["co2_confirmed"], pass.co2_confirmed);
  read(node["depth_neutral"], pass.depth_neutral);
  read(node["oesophagus_in_time"], pass.oesophagus_in_time);
  read(node["no_severe_desaturation"], pass.no_severe_desaturation);
  return pass;
}

/// Each given field that the others rule out, with what they leave it.
void refuse_contradictions(const YAML::Node& node, const IntubationSpec& spec, const Validator& rules,
                           const std::string& path) {
  const auto refuse = [&](bool wrong, const char* field, const std::string& allowed) {
    if (wrong) rules.fail(node[field], path + field, allowed);
  };
  const std::string course = "in the course " + node["course"].Scalar();
  refuse(spec.course == InfantCourse::premedicated_preterm && spec.gestation_weeks > kPretermWeeks, "gestation_weeks",
         "at most 32 weeks " + course);
  refuse(spec.course == InfantCourse::term && spec.gestation_weeks <= kPretermWeeks, "gestation_weeks",
         "more than 32 weeks " + course);
  refuse(spec.course == InfantCourse::premedicated_preterm && !spec.premedicated, "premedicated", "true " + course);
  refuse(spec.course == InfantCourse::delivery_room && spec.premedicated, "premedicated",
         "false " + course + ": nobody is premedicated there");
  refuse(spec.course == InfantCourse::preoxygenated && spec.added_oxygen_percent > 0.0, "added_oxygen_percent",
         "0 " + course + ": it has pure oxygen already");
  refuse(spec.premedicated && spec.breathes, "breathes",
         "false where the infant is premedicated: a muscle relaxant stops its breathing");
  refuse(spec.secretions_ml > 0.0 && spec.catheter_f == 0, "secretions_ml",
         "0 where catheter_f is 0: nothing is at hand to clear them with");
  const std::string relaxed = " where the infant is premedicated: a muscle relaxant keeps the cords still";
  refuse(spec.premedicated && spec.laryngospasm_s > 0.0, "laryngospasm_s", "0" + relaxed);
  refuse(spec.premedicated && node["cord_closure_s"] && spec.cord_closure_s > 0.0, "cord_closure_s", "0" + relaxed);
  refuse(spec.laryngospasm_from_start && !(spec.laryngospasm_s > 0.0), "laryngospasm_from_start",
         "false where laryngospasm_s is 0");
  refuse(!spec.stylet && node["stylet_mm"], "stylet_mm", "none where stylet is false");
  refuse(spec.stylet && spec.stylet_mm >= std::strtod(spec.tube.c_str(), nullptr),
         node["stylet_mm"] ? "stylet_mm" : "stylet",
         "a stylet thinner than the tube of " + spec.tube + " mm is wide inside (stylet_mm)");
}

}  // namespace

const char* name_of(Outcome outcome) { return kOutcomeNames[static_cast<std::size_t>(outcome)].second; }

std::string words_of(Outcome outcome) {
  std::string words = name_of(outcome);
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

std::optional<Outcome> outcome_named(const std::string& name) {
  for (const auto& [outcome, word] : kOutcomeNames)
    if (name == word) return outcome;
  return std::nullopt;
}

IntubationSpec read_intubation(const YAML::Node& node, const Validator& rules, const std::string& path) {
  IntubationSpec spec;
  spec.tube = node["tube"].Scalar();
  const std::string course_name = node["course"].Scalar();
  const auto& course =
      *std::find_if(kCourses.begin(), kCourses.end(), [&](const CourseRow& row) { return course_name == row.name; });
  spec.course = course.course;
  spec.premedicated = course.premedicated;
  if (spec.course == InfantCourse::preoxygenated) spec.added_oxygen_percent = 0.0;
  read(node["stylet"], spec.stylet);
  read(node["stylet_mm"], spec.stylet_mm);
  read(node["catheter_f"], spec.catheter_f);
  read(node["gestation_weeks"], spec.gestation_weeks);
  read(node["infant_seed"], spec.infant_seed);
  read(node["added_oxygen_percent"], spec.added_oxygen_percent);
  read(node["premedicated"], spec.premedicated);
  if (spec.premedicated) spec.cord_closure_s = 0.0;
  spec.breathes = !spec.premedicated;
  read(node["breathes"], spec.breathes);
  read(node["cord_closure_s"], spec.cord_closure_s);
  read(node["laryngospasm_s"], spec.laryngospasm_s);
  read(node["laryngospasm_from_start"], spec.laryngospasm_from_start);
  read(node["secretions_ml"], spec.secretions_ml);
  read(node["laryngeal_pressure_n"], spec.laryngeal_pressure_n);
  read(node["breaths_to_confirm"], spec.breaths_to_confirm);
  refuse_contradictions(node, spec, rules, path);
  spec.pass = read_pass(node["pass"], rules, path + "pass.");
  // Fewer would fail tubes that lie well, more would ask nothing of whoever waits.
  if (spec.pass.co2_confirmed && (spec.breaths_to_confirm < 5 || spec.breaths_to_confirm > 6))
    rules.fail(node["breaths_to_confirm"], path + "breaths_to_confirm",
               "5 or 6 where pass.co2_confirmed is true: the detector changes colour within these");
  return spec;
}

}  // namespace vallecula::curricula
