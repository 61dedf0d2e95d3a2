// From YAML to a curriculum: the schema's rules first, then those no schema can say.
#include "curricula/scenario.h"

#include <algorithm>
#include <set>

#include "curricula/read_modules.h"
#include "curricula/read_scenario.h"
#include "curricula/schema/migrate.h"
#include "curricula/schema/read_value.h"
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

/// Writes the curriculum's word on each pass mark into a scenario that says nothing about it, likewise.
void settle_rubric(YAML::Node& scenario, const YAML::Node& for_all) {
  for (const std::string& mark : marks_of(scenario)) {
    const YAML::Node& given = scenario;
    const YAML::Node own = given["rubric"];
    if (for_all && for_all[mark] && !(own && own[mark])) scenario["rubric"][mark] = YAML::Clone(for_all[mark]);
  }
}

/// The schema of the document, 1 or 2. Throws CurriculumError for one of the future.
int schema_of(const YAML::Node& document, const Validator& newest) {
  const YAML::Node given = document.IsMap() ? document["schema"] : YAML::Node();
  double version = 2.0;
  if (given && yaml_number(given, version) && version > 2.0)
    newest.fail(given, "schema", "1 or 2; a newer Vallecula wrote this file: update the program");
  return version == 1.0 ? 1 : 2;
}

/// Checked, and of the newest schema whatever the file's.
YAML::Node checked_document(const std::filesystem::path& file, int& schema) {
  YAML::Node document = parse_safely(read_yaml_file(file), file.string());
  const Validator newest(curriculum_schema_2(), file.string());
  schema = schema_of(document, newest);
  if (schema == 1) {
    Validator(curriculum_schema_1(), file.string()).check(document, "curriculum", "");
    migrate_1_to_2(document);
  }
  newest.check(document, "curriculum", "");
  return document;
}

/// Of a document that its schema lets pass. With `problems` a scenario's mistake is put there and the next one read,
/// else thrown.
Curriculum read_curriculum(const YAML::Node& document, const Validator& rules, std::vector<Problem>* problems) {
  Curriculum curriculum;
  const auto one = [problems](const auto& reading) {
    try {
      reading();
    } catch (const CurriculumError& error) {
      if (problems == nullptr) throw;
      problems->push_back(error.problem());
    }
  };
  read(document["id"], curriculum.id);
  read(document["title"], curriculum.title);
  read(document["goals"], curriculum.goals);
  std::vector<WeightRow> blades, tubes;
  one([&] { blades = read_rows(document["blades_by_weight"], rules, "blades_by_weight", "blade"); });
  one([&] { tubes = read_rows(document["tubes_by_weight"], rules, "tubes_by_weight", "tube"); });
  std::set<std::string> ids;
  const YAML::Node scenarios = document["scenarios"];
  for (std::size_t i = 0; i < scenarios.size(); ++i) one([&] {
      const std::string path = "scenarios[" + std::to_string(i) + "].";
      YAML::Node node = scenarios[i];
      if (node["attempt"]) rules.fail(node["attempt"], path + "attempt", "none: a trial writes it into its log");
      settle_sizes(node, blades, tubes, rules, path);
      settle_rubric(node, document["rubric"]);
      Scenario scenario = read_scenario(node, rules, path);
      if (!ids.insert(scenario.id).second)
        rules.fail(node["id"], path + "id", "an id no other scenario of the file has");
      scenario.yaml = YAML::Dump(node) + "\n";
      curriculum.scenarios.push_back(std::move(scenario));
    });
  // A module's scenarios are looked for among all: one that is wrong in itself would be missed in its module as well.
  if (problems == nullptr || problems->empty())
    one([&] { curriculum.modules = read_modules(document, curriculum.scenarios, rules); });
  return curriculum;
}

}  // namespace

const Scenario* Curriculum::find(const std::string& id) const {
  const auto found = std::find_if(scenarios.begin(), scenarios.end(), [&](const Scenario& s) { return s.id == id; });
  return found == scenarios.end() ? nullptr : &*found;
}

const Module* Curriculum::module_of(const std::string& scenario_id) const {
  const auto found = std::find_if(modules.begin(), modules.end(), [&](const Module& module) {
    return std::find(module.scenarios.begin(), module.scenarios.end(), scenario_id) != module.scenarios.end();
  });
  return found == modules.end() ? nullptr : &*found;
}

Curriculum load_curriculum(const std::filesystem::path& file) {
  int schema = 0;
  const YAML::Node document = checked_document(file, schema);
  Curriculum curriculum = read_curriculum(document, Validator(curriculum_schema_2(), file.string()), nullptr);
  curriculum.schema = schema;
  curriculum.file = file;
  return curriculum;
}

std::vector<Problem> problems_of(const std::string& text) {
  try {
    YAML::Node document = parse_safely(text, "the text");
    const Validator newest(curriculum_schema_2(), "the text");
    const bool old = schema_of(document, newest) == 1;
    const Validator first(old ? curriculum_schema_1() : curriculum_schema_2(), "the text");
    std::vector<Problem> problems = first.problems(document, "curriculum");
    if (problems.empty() && old) {
      migrate_1_to_2(document);
      problems = newest.problems(document, "curriculum");
    }
    if (problems.empty()) read_curriculum(document, newest, &problems);
    return problems;
  } catch (const CurriculumError& error) {
    return {error.problem()};
  }
}

Scenario parse_scenario(const std::string& yaml, const std::string& name_for_errors) {
  const YAML::Node node = parse_safely(yaml, name_for_errors);
  const Validator rules(curriculum_schema_2(), name_for_errors);
  rules.check(node, "scenario", "");
  if (!node["blade"]) rules.fail_missing(node, "blade", kBlades);
  if (const YAML::Node intubation = node["intubation"]; intubation && !intubation["tube"])
    rules.fail_missing(intubation, "intubation.tube", kTubes);
  Scenario scenario = read_scenario(node, rules, "");
  scenario.yaml = yaml;
  return scenario;
}

}  // namespace vallecula::curricula
