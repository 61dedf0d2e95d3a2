// `vallecula replay`: what a trial log holds, or (--window) the trial to be looked at, or (--verify) the whole trial computed anew and compared to the last bit,
// or (--prediction) how well the forces of late steps are predicted on it.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <QJsonDocument>
#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "curricula/score/score.h"
#include "gui/commands/commands.h"
#include "gui/commands/number_options.h"
#include "gui/commands/score_table.h"
#include "gui/session/files.h"
#include "gui/session/placed_tool.h"
#include "gui/session/prediction_report.h"
#include "gui/session/replay.h"

namespace vallecula::gui {

namespace {

struct ReplayOptions {
  std::string trial, patient, json;
  double at_s = -1.0;
  bool verify = false, prediction = false, window = false;
};

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
    std::cout << "done with a tool of its own, " << tool_file_of_trial(name).filename().string() << ", sha256 "
              << header.tool_sha256.substr(0, 12) << "\n";
  print_score(std::cout, curricula::score_trial(log, scenario), scenario);
  std::cout << "`vallecula replay " << name << " --verify` computes it anew and compares every bit\n";
  return 0;
}

RecordedScene scene_of(const curricula::TrialLog& log, const ReplayOptions& options) {
  RecordedScene scene = recorded_scene(log, options.trial, options.patient);
  for (const std::string& notice : scene.notices) spdlog::warn("{}: {}", options.trial, notice);
  return scene;
}

/// Work that says how far it is, where somebody looks.
template <class Work>
auto with_progress(const char* what, Work work) {
  const bool shown = isatty(STDERR_FILENO) != 0;
  auto result = work([shown, what](double share) {
    if (shown) std::fprintf(stderr, "\r%s: %3.0f %%", what, 100.0 * share);
  });
  if (shown) std::fputs("\r                    \r", stderr);
  return result;
}

int measure(const curricula::TrialLog& log, const ReplayOptions& options) {
  const RecordedScene scene = scene_of(log, options);
  const engine::PredictionMeasurement measured = with_progress(
      "predicting", [&](const auto& progress) { return measure_prediction(log, scene.description, progress); });
  if (!options.json.empty()) {
    const QJsonObject json = prediction_report_json(measured, static_cast<std::int64_t>(log.ticks.size()));
    write_file_whole(options.json, QJsonDocument(json).toJson(QJsonDocument::Indented).toStdString());
  }
  std::printf(
      "force predicted when steps are late, against the full step's; peak %.2f N; rms / p99 / largest error, N\n"
      "%-10s%24s%24s%24s\n",
      measured.peak_force_n(), "steps late", "as the trainer does", "spring alone", "force held");
  for (const int withheld : engine::kWithheldSteps) {
    std::printf("%-10d", withheld);
    for (const auto kind : {engine::Prediction::contact, engine::Prediction::spring, engine::Prediction::hold}) {
      const engine::ForceError error = measured.error(kind, withheld);
      std::printf("%8.4f /%6.3f /%6.3f", error.rms_n, error.p99_n, error.max_n);
    }
    std::printf("\n");
  }
  std::printf("%s\n", energy_line(measured.energy()).c_str());
  return 0;
}

int verify(const curricula::TrialLog& log, const ReplayOptions& options) {
  const std::string& name = options.trial;
  const RecordedScene scene = scene_of(log, options);
  const Verification result =
      with_progress("replaying", [&](const auto& progress) { return verify_trial(log, scene.description, progress); });
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
  std::cout << "verified: all recorded quantities of " << result.ticks << " ticks are bit-identical\n"
            << energy_line(result.energy) << "\n";
  return 0;
}

}  // namespace

void add_replay_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "replay",
      "Say what a trial log holds, verify it by computing it anew, look at it in the window, or measure on it how late "
      "steps are predicted");
  auto options = std::make_shared<ReplayOptions>();
  command->add_option("TRIAL", options->trial, "Folder of the trial, or its trial.vtrial")->required();
  auto* verified =
      command->add_flag("--verify", options->verify, "Compute the trial anew; exit 0 only when every bit is the same");
  auto* prediction = command
                         ->add_flag("--prediction", options->prediction,
                                    "How well forces of late steps are predicted along this trial's hand")
                         ->excludes(verified);
  command->add_option("--json", options->json, "Write the figures of --prediction here")->needs(prediction);
  command->add_option("--patient", options->patient, "Where the patient package is now, if it was moved");
  auto* window = command->add_flag("--window", options->window, "Look at it in the window, at any second")
                     ->excludes(verified)
                     ->excludes(prediction);
  command->add_option("--at", options->at_s, "With --window: the second of the trial to begin at (s)")
      ->needs(window)
      ->check(number_within(0.0, 86400.0));
  command->callback([options, &exit_code] {
    if (options->window) {
      exit_code = run_window_replay(options->trial, options->at_s, options->patient);
      return;
    }
    const curricula::TrialLog log = curricula::read_trial_log(options->trial);
    exit_code = options->verify       ? verify(log, *options)
                : options->prediction ? measure(log, *options)
                                      : print_summary(log, options->trial);
  });
}

}  // namespace vallecula::gui
