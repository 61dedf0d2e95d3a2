#include "gui/session/replay_trial.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gui/session/replay.h"
#include "gui/session/scripted_hands.h"

namespace vallecula::gui {

namespace {

constexpr std::size_t kPathEvery = 20;  // ticks: 20 ms

std::array<float, 3> millimetres(const std::array<double, 3>& m) {
  return {static_cast<float>(1e3 * m[0]), static_cast<float>(1e3 * m[1]), static_cast<float>(1e3 * m[2])};
}

TipPath path_of(const curricula::TrialLog& log) {
  TipPath path;
  for (std::size_t i = 0; i < log.ticks.size(); i += kPathEvery) {
    const curricula::LogTick& tick = log.ticks[i];
    if (tick.step_used < 0) continue;  // no step yet: no tool yet
    path.time_s.push_back(tick.time_s);
    path.tip_mm.push_back(millimetres(tick.proxy_pose.position_m));
    path.tongue_n.push_back(static_cast<float>(load_n(tick, curricula::kTongue)));
  }
  return path;
}

TipPath expert_path_on(const pipeline::PatientPackage& package, const curricula::Scenario& scenario) {
  TipPath path;
  try {
    const device::Trajectory plan = scripted_hand("expert", package, scenario);
    for (double at_s = 0.0; at_s <= plan.end_s(); at_s += 0.05) {
      path.time_s.push_back(at_s);
      path.tip_mm.push_back(millimetres(plan.at(at_s).position_m));
    }
  } catch (const std::exception&) {
    return {};  // a patient without the landmarks a plan needs has no expert's way to show
  }
  return path;
}

std::vector<PeaksSoFar> peaks_of(const curricula::TrialLog& log) {
  std::vector<PeaksSoFar> peaks;
  PeaksSoFar now(log.header);
  for (std::size_t i = 0; i < log.ticks.size(); ++i) {
    now.take(log.ticks[i]);
    if ((i + 1) % kPeaksEvery == 0 || i + 1 == log.ticks.size()) peaks.push_back(now);
  }
  return peaks;
}

}  // namespace

const curricula::LogTick& ReplayTrial::tick_at(double time_s) const {
  const double index = (time_s - log->ticks.front().time_s) / log->header.servo_period_s + 0.5;
  return log->ticks[static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(log->ticks.size() - 1)))];
}

std::string replay_refusal(const curricula::Scenario& scenario, bool instructor) {
  return instructor || curricula::rules_of(scenario.attempt.mode).replay
             ? std::string()
             : "This trial was an assessment: it is not replayed, so that nobody practises on what is assessed.";
}

std::shared_ptr<ReplayTrial> open_replay(const std::filesystem::path& trial, const std::filesystem::path& patient,
                                         const std::function<void(const std::string&, double)>& progress,
                                         bool instructor) {
  progress("Reading the trial", 0.0);
  auto opened = std::make_shared<ReplayTrial>();
  opened->log_file = std::filesystem::is_directory(trial) ? trial / "trial.vtrial" : trial;
  opened->log = std::make_shared<const curricula::TrialLog>(curricula::read_trial_log(trial));
  if (opened->log->ticks.empty())
    throw std::runtime_error(trial.string() + ": this log has no tick, so there is nothing to replay");
  opened->scenario = curricula::parse_scenario(opened->log->header.scenario_yaml, trial.string());
  const std::string refusal = replay_refusal(opened->scenario, instructor);
  if (!refusal.empty()) throw std::runtime_error(trial.string() + ": " + refusal);
  progress("Looking for the patient", 0.2);
  RecordedScene scene = recorded_scene(*opened->log, trial, patient);
  opened->scene = std::move(scene.description);
  opened->notices = std::move(scene.notices);
  progress("Scoring", 0.45);
  opened->score = curricula::score_trial(*opened->log, opened->scenario);
  opened->points = curricula::points_of(opened->score, opened->scenario);
  opened->events = replay_events(*opened->log, opened->scenario, opened->score);
  opened->path = path_of(*opened->log);
  opened->expert_path = expert_path_on(scene.package, opened->scenario);
  opened->peaks = peaks_of(*opened->log);
  progress("Building the scene", 0.6);
  opened->film = std::make_unique<ReplayFilm>(opened->log, opened->scene);
  progress("Light and colour", 0.75);
  opened->heat = std::make_unique<ContactHeat>(*opened->film, scene.package.tongue, opened->scene.tool);
  opened->look = make_patient_look(std::move(scene.package), {}, Seen::all_round, scene.package_folder);
  progress("Ready", 1.0);
  return opened;
}

}  // namespace vallecula::gui
