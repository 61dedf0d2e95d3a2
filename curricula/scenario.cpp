// From YAML to a curriculum: the schema's rules first, then those no schema can say.
#include "curricula/scenario.h"

#include <algorithm>
#include <set>

#include "curricula/read_intubation.h"
#include "curricula/schema/safe_yaml.h"
#include "curricula/schema/schema_text.h"
#include "curricula/schema/validator.h"

namespace vallecula::curricula {
namespace {

/// A size that goes by the infant's weight.
struct WeightRow {
  double below_kg;
  std::string size;
};

Scenario read_scenario(const YAML::Node& node, const Validator& rules, const std::string& path) {
  Scenario s;
  s.id = node["id"].Scalar();
  s.title = node["title"].Scalar();
  s.briefing = node["briefing"].Scalar();
  s.debriefing = node["debriefing"].Scalar();
  s.manikin.weight_kg = checked_number(node["manikin"]["weight_kg"]);
  s.manikin.seed = static_cast<unsigned>(checked_number(node["manikin"]["seed"]));
  s.blade = node["blade"].Scalar();
  if (const YAML::Node young = node["tongue_young_pa"]) s.tongue_young_pa = checked_number(young);
  s.sight_percent = checked_number(node["sight_percent"]);
  s.max_attempt_s = checked_number(node["max_attempt_s"]);
  const YAML::Node targets = node["targets"], pass = node["pass"];
  s.targets.tongue_force_n = checked_number(targets["tongue_force_n"]);
  s.targets.gum_force_n = checked_number(targets["gum_force_n"]);
  s.pass.peak_tongue_force_n = checked_number(pass["peak_tongue_force_n"]);
  s.pass.peak_gum_force_n = checked_number(pass["peak_gum_force_n"]);
  s.pass.glottis_visible_percent = checked_number(pass["glottis_visible_percent"]);
  s.pass.attempt_time_s = checked_number(pass["attempt_time_s"]);
  s.pass.time_over_target_s = checked_number(pass["time_over_target_s"]);
  s.pass.time_over_device_limit_s = checked_number(pass["time_over_device_limit_s"]);

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
  if (const YAML::Node intubation = node["intubation"])
    s.intubation = read_intubation(intubation, rules, path + "intubation.");
  return s;
}

/// The table `name`, whose rows have `field` beside their weight.
std::vector<WeightRow> read_rows(const YAML::Node& table, const Validator& rules, const std::string& name,
                                 const char* field) {
  std::vector<WeightRow> rows;
  for (std::size_t i = 0; table && i < table.size(); ++i) {
    const WeightRow row{checked_number(table[i]["below_kg"]), table[i][field].Scalar()};
    if (!rows.empty() && row.below_kg <= rows.back().below_kg) {
      rules.fail(table[i]["below_kg"], name + "[" + std::to_string(i) + "].below_kg",
                 "more than the row before, " + with_unit(rows.back().below_kg, "kg"));
    }
    rows.push_back(row);
  }
  return rows;
}

constexpr const char* kBlades = "one of miller-00, miller-0, miller-1, miller-2, miller-3";
constexpr const char* kTubes = "one of 2.5, 3.0, 3.5, 4.0";

/// Writes the table's size into a group of fields that names none, so that a scenario's own text says everything.
void settle(YAML::Node group, const char* field, double weight_kg, const std::vector<WeightRow>& rows,
            const Validator& rules, const std::string& path, const std::string& otherwise) {
  const YAML::Node& given = group;  // only the constant look-up leaves a missing field missing
  if (given[field]) return;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const WeightRow& r) { return weight_kg < r.below_kg; });
  if (row == rows.end()) rules.fail_missing(group, path + field, otherwise + with_unit(weight_kg, "kg"));
  group[field] = row->size;
}

void settle_sizes(YAML::Node& scenario, const std::vector<WeightRow>& blades, const std::vector<WeightRow>& tubes,
                  const Validator& rules, const std::string& path) {
  const YAML::Node& given = scenario;
  const double weight_kg = checked_number(given["manikin"]["weight_kg"]);
  settle(scenario, "blade", weight_kg, blades, rules, path,
         kBlades + std::string(", or a row of blades_by_weight above "));
  if (!given["intubation"]) return;
  settle(scenario["intubation"], "tube", weight_kg, tubes, rules, path + "intubation.",
         kTubes + std::string(", or a row of tubes_by_weight above "));
}

}  // namespace

const Scenario* Curriculum::find(const std::string& id) const {
  const auto found = std::find_if(scenarios.begin(), scenarios.end(), [&](const Scenario& s) { return s.id == id; });
  return found == scenarios.end() ? nullptr : &*found;
}

Curriculum load_curriculum(const std::filesystem::path& file) {
  const YAML::Node document = parse_safely(read_yaml_file(file), file.string());
  const Validator rules(curriculum_schema_1(), file.string());
  rules.check(document, "curriculum", "");

  Curriculum curriculum;
  curriculum.id = document["id"].Scalar();
  curriculum.title = document["title"].Scalar();
  curriculum.file = file;
  const auto blades = read_rows(document["blades_by_weight"], rules, "blades_by_weight", "blade");
  const auto tubes = read_rows(document["tubes_by_weight"], rules, "tubes_by_weight", "tube");
  std::set<std::string> ids;
  const YAML::Node scenarios = document["scenarios"];
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const std::string path = "scenarios[" + std::to_string(i) + "].";
    YAML::Node node = scenarios[i];
    settle_sizes(node, blades, tubes, rules, path);
    Scenario scenario = read_scenario(node, rules, path);
    if (!ids.insert(scenario.id).second) rules.fail(node["id"], path + "id", "an id no other scenario of the file has");
    scenario.yaml = YAML::Dump(node) + "\n";
    curriculum.scenarios.push_back(std::move(scenario));
  }
  return curriculum;
}

Scenario parse_scenario(const std::string& yaml, const std::string& name_for_errors) {
  const YAML::Node node = parse_safely(yaml, name_for_errors);
  const Validator rules(curriculum_schema_1(), name_for_errors);
  rules.check(node, "scenario", "");
  if (!node["blade"]) rules.fail_missing(node, "blade", kBlades);
  if (const YAML::Node intubation = node["intubation"]; intubation && !intubation["tube"])
    rules.fail_missing(intubation, "intubation.tube", kTubes);
  Scenario scenario = read_scenario(node, rules, "");
  scenario.yaml = yaml;
  return scenario;
}

}  // namespace vallecula::curricula
