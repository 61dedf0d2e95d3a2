// `vallecula score`: the score anew from the log, by nothing but the log.
#include <iostream>
#include <memory>
#include <stdexcept>

#include "curricula/score/score.h"
#include "gui/commands/commands.h"
#include "gui/commands/score_table.h"
#include "gui/session/files.h"

namespace vallecula::gui {

void add_score_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("score", "Recompute a trial's score from its log");
  struct Options {
    std::string trial, out;
    bool json = false, partial = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("TRIAL", options->trial, "Folder of the trial, or its trial.vtrial")->required();
  command->add_flag("--json", options->json, "Print JSON instead of a table");
  command->add_option("--out", options->out, "Write the JSON to this file too");
  command->add_flag("--partial", options->partial, "Score what there is of a log that was cut off");
  command->callback([options, &exit_code] {
    const curricula::TrialLog log = curricula::read_trial_log(options->trial);
    if (!log.footer.complete && !options->partial) {
      throw std::runtime_error(options->trial + ": this log was cut off after " + std::to_string(log.ticks.size()) +
                               " ticks, so its score is not the trial's; --partial scores what there is");
    }
    const curricula::Scenario scenario = curricula::parse_scenario(log.header.scenario_yaml, options->trial);
    const curricula::Score score = curricula::score_trial(log, scenario);
    const std::string json = curricula::score_to_json(score, log, scenario) + "\n";
    if (!options->out.empty()) write_file_whole(options->out, json);
    if (options->json) {
      std::cout << json;
    } else {
      print_score(std::cout, score, scenario);
    }
    exit_code = 0;
  });
}

}  // namespace vallecula::gui
