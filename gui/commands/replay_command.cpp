// `vallecula replay`: what a trial log holds, or (--verify) the whole trial computed anew and compared to the last bit.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "curricula/score/score.h"
#include "gui/commands/commands.h"
#include "gui/commands/score_table.h"
#include "gui/session/placed_tool.h"
#include "gui/session/replay.h"

namespace vallecula::gui {

namespace {

int print_summary(const curricula::TrialLog& log, const std::string& name) {
  const curricula::LogHeader& header = log.header;
  const curricula::Scenario scenario = curricula::parse_scenario(header.scenario_yaml, name);
  tool_of_trial(header, name);  // a trial whose tool is missing or another is not whole
  const double seconds = static_cast<double>(log.ticks.size()) * header.servo_period_s;
  std::cout << "trial of scenario " << header.scenario_id << " on " << header.package_name << ", device "
            << header.device_kind << ", " << log.ticks.size() << " ticks (" << seconds << " s"
            << (header.realtime ? "" : ", not in real time") << "), "
            << (log.footer.complete ? log.footer.ended : "cut off") << "\n"
            << "recorded by vallecula " << header.software_version << ", build " << header.build_hash.substr(0, 12)
            << ", kernels " << header.instruction_set << "\n";
  if (!header.tool_sha256.empty())
    std::cout << "done with a tool of its own, " << kToolFile << ", sha256 " << header.tool_sha256.substr(0, 12)
              << "\n";
  print_score(std::cout, curricula::score_trial(log, scenario), scenario);
  std::cout << "`vallecula replay " << name << " --verify` computes it anew and compares every bit\n";
  return 0;
}

int verify(const curricula::TrialLog& log, const std::string& name, const std::string& patient) {
  const RecordedScene scene = recorded_scene(log, name, patient);
  for (const std::string& notice : scene.notices) spdlog::warn("{}: {}", name, notice);
  const bool show_progress = isatty(STDERR_FILENO) != 0;
  const Verification result = verify_trial(log, scene.description, [show_progress](double share) {
    if (show_progress) std::fprintf(stderr, "\rreplaying: %3.0f %%", 100.0 * share);
  });
  if (show_progress) std::fputs("\r                    \r", stderr);
  if (!result.difference.field.empty()) {
    char text[512];
    std::snprintf(text, sizeof text,
                  "%s: differs first at tick %lld (%.3f s) in %s: recorded %.17g, recomputed %.17g%s", name.c_str(),
                  static_cast<long long>(result.tick), result.time_s, result.difference.field.c_str(),
                  result.difference.recorded, result.difference.recomputed,
                  scene.notices.empty() ? "; the log was changed, or the engine is not deterministic"
                                        : "; replay it with the build that recorded it");
    throw std::runtime_error(text);
  }
  if (!log.footer.complete) {
    throw std::runtime_error(name + ": this log was cut off; its " + std::to_string(result.ticks) +
                             " ticks are bit-identical, but what followed is lost");
  }
  std::cout << "verified: all recorded quantities of " << result.ticks << " ticks are bit-identical\n";
  return 0;
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("replay", "Say what a trial log holds, or verify it by computing it anew");
  struct Options {
    std::string trial, patient;
    bool verify = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("TRIAL", options->trial, "Folder of the trial, or its trial.vtrial")->required();
  command->add_flag("--verify", options->verify, "Compute the trial anew; exit 0 only when every bit is the same");
  command->add_option("--patient", options->patient, "Where the patient package is now, if it was moved");
  command->callback([options, &exit_code] {
    const curricula::TrialLog log = curricula::read_trial_log(options->trial);
    exit_code = options->verify ? verify(log, options->trial, options->patient) : print_summary(log, options->trial);
  });
}

}  // namespace vallecula::gui
