// `vallecula trial`: one trial, in a window or headless.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "gui/commands/commands.h"
#include "gui/commands/headless_application.h"
#include "gui/commands/interruption.h"
#include "gui/commands/score_table.h"
#include "gui/session/device_choice.h"
#include "gui/session/files.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

struct TrialOptions {
  std::string patient, scenario, curriculum, device, out;
  bool headless = false, as_fast_as_possible = false, json = false;
};

/// ID, or FILE.yaml:ID.
void name_scenario(const TrialOptions& options, TrialSetup& setup) {
  const std::size_t colon = options.scenario.rfind(':');
  if (colon != std::string::npos) {
    if (!options.curriculum.empty())
      throw CLI::ValidationError("--scenario", "names a file, and so does --curriculum; give one of them");
    setup.curriculum = options.scenario.substr(0, colon);
    setup.scenario = options.scenario.substr(colon + 1);
    return;
  }
  setup.curriculum = options.curriculum.empty() ? default_curriculum() : fs::path(options.curriculum);
  setup.scenario = options.scenario;
}

int run_headless(const TrialSetup& setup, bool json) {
  const HeadlessApplication application;
  watch_for_interruption();
  TrialSession session(setup);
  spdlog::info("scene built; {} with {} begins", session.scenario().id, setup.device);
  session.start();
  const bool show_progress = isatty(STDERR_FILENO) != 0;
  while (!session.finished() && !interrupted()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (show_progress) std::fprintf(stderr, "\rtrial: %5.1f s", session.latest().time_s);
  }
  if (show_progress) std::fputs("\r              \r", stderr);
  if (interrupted())
    throw std::runtime_error("the trial was interrupted; what was recorded until then is in " + setup.out.string());
  const TrialOutcome outcome = session.finish("ended");
  if (!outcome.fault.empty()) spdlog::warn("{}", outcome.fault);
  if (json) {
    std::cout << read_file(outcome.score_json);
  } else {
    print_score(std::cout, outcome.score, session.scenario());
    std::cout << "report: " << outcome.report.string() << "\n";
  }
  return 0;
}

}  // namespace

void add_trial_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("trial", "Do one trial, in the window or headless, and score it");
  auto options = std::make_shared<TrialOptions>();
  command->add_option("--patient", options->patient, "Patient package (NAME.patient)")->required();
  command->add_option("--scenario", options->scenario, "Scenario: its id in the curriculum, or FILE.yaml:ID")
      ->required();
  command->add_option("--curriculum", options->curriculum, "Curriculum file (the shipped one if left out)");
  command
      ->add_option(
          "--device", options->device, device_names() + " (t,x,y,z[,qw,qx,qy,qz]; s, m)")
      ->required();
  command->add_flag("--headless", options->headless, "No window");
  command->add_flag("--asap", options->as_fast_as_possible, "Headless only: as fast as it goes instead of 1 kHz");
  command->add_option("--out", options->out, "Folder for trial.vtrial, score.json, report.html, force.png")->required();
  command->add_flag("--json", options->json, "Print the score as JSON (headless)");
  command->callback([options, &exit_code] {
    check_device_name(options->device);
    if (options->as_fast_as_possible && !options->headless) {
      throw CLI::ValidationError("--asap", "works with --headless only: a person needs real time");
    }
    if (options->headless && options->device == "mouse") {
      throw CLI::ValidationError("--device", "a mouse needs the window: leave out --headless");
    }
    TrialSetup setup;
    name_scenario(*options, setup);
    setup.patient = options->patient;
    setup.device = options->device;
    setup.out = options->out;
    setup.realtime = !options->as_fast_as_possible;
    exit_code = options->headless ? run_headless(setup, options->json) : run_window_trial(setup);
  });
}

}  // namespace vallecula::gui
