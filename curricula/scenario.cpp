// From YAML to a curriculum: the schema's rules first, then those no schema can say.
#include "curricula/scenario.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "curricula/schema/safe_yaml.h"
#include "curricula/schema/schema_text.h"
#include "curricula/schema/validator.h"

namespace vallecula::curricula {
namespace {

struct BladeRow {
  double below_kg;
  std::string blade;
};

double number(const YAML::Node& node) {
  double value = 0.0;
  yaml_number(node, value);  // the validator has let it pass already
  return value;
}

std::string limit_text(double value, const char* unit) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return std::string(digits.data(), end) + " " + unit;
}

Scenario read_scenario(const YAML::Node& node, const Validator& rules, const std::string& path) {
  Scenario s;
  s.id = node["id"].Scalar();
  s.title = node["title"].Scalar();
  s.briefing = node["briefing"].Scalar();
  s.debriefing = node["debriefing"].Scalar();
  s.manikin.weight_kg = number(node["manikin"]["weight_kg"]);
  s.manikin.seed = static_cast<unsigned>(number(node["manikin"]["seed"]));
  s.blade = node["blade"].Scalar();
  if (const YAML::Node young = node["tongue_young_pa"]) s.tongue_young_pa = number(young);
  s.sight_percent = number(node["sight_percent"]);
  s.max_attempt_s = number(node["max_attempt_s"]);
  const YAML::Node targets = node["targets"], pass = node["pass"];
  s.targets.tongue_force_n = number(targets["tongue_force_n"]);
  s.targets.gum_force_n = number(targets["gum_force_n"]);
  s.pass.peak_tongue_force_n = number(pass["peak_tongue_force_n"]);
  s.pass.peak_gum_force_n = number(pass["peak_gum_force_n"]);
  s.pass.glottis_visible_percent = number(pass["glottis_visible_percent"]);
  s.pass.attempt_time_s = number(pass["attempt_time_s"]);
  s.pass.time_over_target_s = number(pass["time_over_target_s"]);
  s.pass.time_over_device_limit_s = number(pass["time_over_device_limit_s"]);

  const auto at_most = [&](const YAML::Node& what, const std::string& name, double limit, const char* limit_name,
                           const char* unit) {
    if (number(what) > limit) {
      rules.fail(what, path + name, "at most " + std::string(limit_name) + " = " + limit_text(limit, unit));
    }
  };
  at_most(targets["tongue_force_n"], "targets.tongue_force_n", s.pass.peak_tongue_force_n, "pass.peak_tongue_force_n",
          "N");
  at_most(targets["gum_force_n"], "targets.gum_force_n", s.pass.peak_gum_force_n, "pass.peak_gum_force_n", "N");
  at_most(node["sight_percent"], "sight_percent", s.pass.glottis_visible_percent, "pass.glottis_visible_percent",
          "percent");
  at_most(pass["attempt_time_s"], "pass.attempt_time_s", s.max_attempt_s, "max_attempt_s", "s");
  return s;
}

std::vector<BladeRow> read_blades(const YAML::Node& table, const Validator& rules) {
  std::vector<BladeRow> rows;
  for (std::size_t i = 0; table && i < table.size(); ++i) {
    const BladeRow row{number(table[i]["below_kg"]), table[i]["blade"].Scalar()};
    if (!rows.empty() && row.below_kg <= rows.back().below_kg) {
      rules.fail(table[i]["below_kg"], "blades_by_weight[" + std::to_string(i) + "].below_kg",
                 "more than the row before, " + limit_text(rows.back().below_kg, "kg"));
    }
    rows.push_back(row);
  }
  return rows;
}

/// Writes the table's blade into a scenario that names none, so that its own text says everything.
void settle_blade(YAML::Node& scenario, const std::vector<BladeRow>& blades, const Validator& rules,
                  const std::string& path) {
  const YAML::Node& given = scenario;  // only the constant look-up leaves a missing field missing
  if (given["blade"]) return;
  const double weight_kg = number(given["manikin"]["weight_kg"]);
  const auto row =
      std::find_if(blades.begin(), blades.end(), [&](const BladeRow& r) { return weight_kg < r.below_kg; });
  if (row == blades.end()) {
    rules.fail_missing(
        scenario, path + "blade",
        "one of miller-00, miller-0, miller-1, miller-2, miller-3, or a row of blades_by_weight above " + limit_text(weight_kg, "kg"));
  }
  scenario["blade"] = row->blade;
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
  const std::vector<BladeRow> blades = read_blades(document["blades_by_weight"], rules);
  std::set<std::string> ids;
  const YAML::Node scenarios = document["scenarios"];
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const std::string path = "scenarios[" + std::to_string(i) + "].";
    YAML::Node node = scenarios[i];
    settle_blade(node, blades, rules, path);
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
  if (!node["blade"]) rules.fail_missing(node, "blade", "one of miller-00, miller-0, miller-1, miller-2, miller-3");
  Scenario scenario = read_scenario(node, rules, "");
  scenario.yaml = yaml;
  return scenario;
}

}  // namespace vallecula::curricula
