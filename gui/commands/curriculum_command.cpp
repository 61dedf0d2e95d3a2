// `vallecula curriculum`: check a file, list what there is, print the rules, draw an attempt.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "curricula/schema/reference_table.h"
#include "curricula/schema/schema_text.h"
#include "curricula/score/points.h"
#include "gui/commands/commands.h"
#include "gui/commands/number_options.h"
#include "gui/session/curricula_files.h"

namespace vallecula::gui {

namespace fs = std::filesystem;
using curricula::Curriculum;
using curricula::Scenario;

namespace {

const Scenario& scenario_in(const Curriculum& curriculum, const std::string& id) {
  const Scenario* found = curriculum.find(id);
  if (found != nullptr) return *found;
  std::string known;
  for (const Scenario& one : curriculum.scenarios) known += (known.empty() ? "" : ", ") + one.id;
  throw std::runtime_error(curriculum.file.string() + ": has no scenario '" + id + "'; it has " + known);
}

int check(const std::string& file) {
  const Curriculum curriculum = curricula::load_curriculum(file);
  std::cout << file << ": " << curriculum.title << " (" << curriculum.id << "), schema " << curriculum.schema << ", "
            << curriculum.modules.size() << (curriculum.modules.size() == 1 ? " module, " : " modules, ")
            << curriculum.scenarios.size() << " scenarios, valid\n";
  for (const Scenario& scenario : curriculum.scenarios)
    std::cout << "  " << scenario.id << ": " << scenario.title << "\n";
  return 0;
}

QString text(const std::string& value) { return QString::fromStdString(value); }

QJsonArray list_of(const std::vector<std::string>& values) {
  QJsonArray list;
  for (const std::string& value : values) list.append(text(value));
  return list;
}

QJsonObject json_of(const Curriculum& curriculum) {
  QJsonArray modules;
  for (const curricula::Module& module : curriculum.modules) {
    QJsonArray scenarios;
    for (const std::string& id : module.scenarios) {
      const Scenario& scenario = *curriculum.find(id);
      QJsonObject marks;
      for (const auto& [mark, worth] : scenario.rubric)
        marks[text(mark)] = QJsonObject{{"weight", worth.weight}, {"source", text(source_of(scenario, mark))}};
      scenarios.append(QJsonObject{{"id", text(id)},
                                   {"title", text(scenario.title)},
                                   {"after", list_of(scenario.after)},
                                   {"varies", scenario.variation.has_value()},
                                   {"pass_marks", marks}});
    }
    QJsonArray modes;
    for (const curricula::Mode mode : module.modes) modes.append(curricula::name_of(mode));
    modules.append(QJsonObject{{"id", text(module.id)},
                               {"title", text(module.title)},
                               {"goal", text(module.goal.in("en"))},
                               {"after", list_of(module.after)},
                               {"modes", modes},
                               {"mastery", module.mastery.by_cusum ? "cusum" : "consecutive"},
                               {"mastery_source", text(module.mastery.source)},
                               {"scenarios", scenarios}});
  }
  return {{"id", text(curriculum.id)},
          {"title", text(curriculum.title)},
          {"file", text(curriculum.file.filename().string())},
          {"shipped", is_shipped(curriculum.file)},
          {"schema", curriculum.schema},
          {"modules", modules}};
}

std::string words(const curricula::MasteryRule& rule) {
  const std::string within =
      ", each within " + std::to_string(rule.attempts) + (rule.attempts == 1 ? " attempt" : " attempts");
  std::string text = rule.by_cusum
                         ? "CUSUM at " + std::to_string(std::lround(100.0 * (1.0 - rule.cusum.acceptable_failure))) +
                               " % success" + within
                         : std::to_string(rule.passes) + " passes running in each scenario" + within;
  if (rule.assessments_only) text += ", assessments only";
  return text + " (" + rule.source + ")";
}

std::string after(const std::vector<std::string>& modules) {
  std::string text;
  for (const std::string& id : modules) text += (text.empty() ? ", after " : " and ") + id;
  return text;
}

/// Which of the two folders a course is in; nothing of another one, which whoever asks has named.
const char* folder_of(const fs::path& file) {
  return is_shipped(file) ? ", shipped" : file.parent_path() == own_curricula_folder() ? ", one of your own" : "";
}

void print(const Curriculum& curriculum, bool marks) {
  std::cout << curriculum.id << ": " << curriculum.title << " (" << curriculum.file.filename().string()
            << folder_of(curriculum.file) << ")\n";
  for (const curricula::Text& goal : curriculum.goals) std::cout << "  goal: " << goal.in("en") << "\n";
  for (const curricula::Module& module : curriculum.modules) {
    std::cout << "  " << module.id << ": " << module.title << after(module.after) << "\n"
              << "    mastered by " << words(module.mastery) << "\n";
    for (const std::string& id : module.scenarios) {
      const Scenario& scenario = *curriculum.find(id);
      std::cout << "    " << id << ": " << scenario.title << after(scenario.after) << "\n";
      if (!marks) continue;
      for (const auto& [mark, worth] : scenario.rubric)
        std::cout << "      " << mark << ", weight " << worth.weight << ": " << source_of(scenario, mark) << "\n";
    }
  }
}

int list(const std::string& file, bool json, bool marks) {
  std::vector<fs::path> files{file};
  if (file.empty()) {
    files = curriculum_files();
  }
  QJsonArray all;
  for (const fs::path& one : files) {
    const Curriculum curriculum = curricula::load_curriculum(one);
    if (json)
      all.append(json_of(curriculum));
    else
      print(curriculum, marks);
  }
  if (json) std::cout << QJsonDocument(all).toJson().toStdString();
  return 0;
}

}  // namespace

void add_curriculum_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("curriculum", "Work with curriculum files");
  command->require_subcommand(1);
  struct Options {
    std::string file, scenario;
    std::uint32_t seed = 0;
    bool json = false, marks = false, assessment = false;
  };
  auto options = std::make_shared<Options>();

  CLI::App* checking =
      command->add_subcommand("check", "Validate a curriculum; errors name file, line, field and what was expected");
  checking->add_option("FILE", options->file, "Curriculum (YAML)")->required();
  checking->callback([options, &exit_code] { exit_code = check(options->file); });

  CLI::App* listing =
      command->add_subcommand("list", "Modules and scenarios of a curriculum, or of all shipped ones and your own");
  listing->add_option("FILE", options->file, "Curriculum (YAML); left out: all shipped ones and your own");
  listing->add_flag("--marks", options->marks, "With the pass marks' weights and sources");
  listing->add_flag("--json", options->json, "The list as JSON");
  listing->callback([options, &exit_code] { exit_code = list(options->file, options->json, options->marks); });

  CLI::App* editing = command->add_subcommand("edit", "Write a course: opens the window with form, text and problems");
  editing->add_option("FILE", options->file, "Curriculum (YAML); left out: a new one");
  editing->callback([options, &exit_code] { exit_code = run_window_course(options->file); });

  CLI::App* table = command->add_subcommand("table", "All fields of a curriculum as a Markdown table");
  table->callback([&exit_code] {
    std::cout << curricula::reference_table(curricula::curriculum_schema_2());
    exit_code = 0;
  });

  CLI::App* schema = command->add_subcommand("schema", "The rules as JSON Schema, for an editor's help and completion");
  schema->callback([&exit_code] {
    std::cout << curricula::curriculum_schema_2();
    exit_code = 0;
  });

  CLI::App* attempt = command->add_subcommand("attempt", "What one attempt at a scenario is, drawn from its variation");
  attempt->add_option("FILE", options->file, "Curriculum (YAML)")->required();
  attempt->add_option("SCENARIO", options->scenario, "Its id")->required();
  attempt->add_option("--seed", options->seed, "Seed of the attempt; 0 is what is written")
      ->check(whole_number_within(0, kLargestSeed));
  attempt->add_flag("--assessment", options->assessment, "As an assessment: as written, without helps");
  attempt->callback([options, &exit_code] {
    const Curriculum curriculum = curricula::load_curriculum(options->file);
    const auto mode = options->assessment ? curricula::Mode::assessment : curricula::Mode::practice;
    std::cout << curricula::attempt_of(scenario_in(curriculum, options->scenario), mode, options->seed).yaml;
    exit_code = 0;
  });
}

}  // namespace vallecula::gui
