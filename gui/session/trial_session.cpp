#include "gui/session/trial_session.h"

#include <cmath>
#include <stdexcept>

#include "curricula/trial_log.h"
#include "device/drivers/mouse_device.h"
#include "engine/haptics/snapshots.h"
#include "gui/session/device_choice.h"
#include "gui/session/fault_report.h"
#include "gui/session/files.h"
#include "gui/session/hands_port.h"
#include "gui/session/log_paths.h"
#include "gui/session/picture_watch.h"
#include "gui/session/placed_tool.h"
#include "gui/session/results_folder.h"
#include "gui/session/scene_from_package.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/trial_attempt.h"
#include "gui/session/trial_clock.h"
#include "gui/session/trial_header.h"
#include "gui/session/two_hands.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

curricula::Curriculum curriculum_with(const fs::path& file, const std::string& scenario) {
  curricula::Curriculum curriculum = curricula::load_curriculum(file);
  if (curriculum.find(scenario) == nullptr) {
    std::string known;
    for (const auto& one : curriculum.scenarios) known += (known.empty() ? "" : ", ") + one.id;
    throw std::runtime_error(file.string() + ": has no scenario '" + scenario + "'; it has " + known +
                             " (--curriculum FILE names another course; `vallecula curriculum list` shows them)");
  }
  return curriculum;
}

/// As written, where nothing was asked for beyond practice of that.
curricula::Scenario scenario_of(const TrialSetup& setup, const curricula::Scenario& written) {
  const bool chosen = !setup.taken.blade.empty() || !setup.taken.tube.empty();
  if (setup.mode == curricula::Mode::practice && setup.attempt_seed == 0 && !chosen) return written;
  if (setup.attempt_seed != 0 && !written.variation)
    throw std::runtime_error("scenario '" + written.id +
                             "' has no variation that a seed could draw from; leave the seed out");
  return curricula::attempt_of(written, setup.mode, setup.attempt_seed, setup.taken);
}

bool is_of_person(const device::HapticDevice& device) {
  const std::string kind = device.info().kind;
  return kind != "scripted" && kind != "recorded";
}

}  // namespace

struct TrialSession::Impl {
  explicit Impl(const TrialSetup& setup);

  void make_attempt(bool at_vallecula);
  void reset(bool at_vallecula, const std::function<void()>& between);
  void must_be_practice(const char* what) const;
  curricula::LogHeader header(std::int64_t lead_in_ticks) const;
  bool by_person() const;
  long long trainee() const;
  TrialOutcome finish(const std::string& how);

  TrialSetup setup;
  std::shared_ptr<const pipeline::PatientPackage> read;
  const pipeline::PatientPackage& package;
  curricula::Curriculum curriculum;
  curricula::Scenario scenario;
  DualTask dual_task;
  engine::SceneDescription description;
  std::shared_ptr<const engine::Scene> scene;
  std::string package_sha256;
  std::string tool_ply;  ///< of a tool of its own: the bytes of its file; else empty
  ResultsFolder results;
  std::unique_ptr<TwoHands> hands;
  PictureWatch picture;
  bool needs_eyes = false;  ///< a person has one of the hands
  std::unique_ptr<TrialAttempt> attempt;
  engine::Snapshot at_start;
  std::vector<std::string> notices;  ///< of what was cut off before
};

TrialSession::Impl::Impl(const TrialSetup& given)
    : setup(given),
      read(given.package ? given.package
                         : std::make_shared<const pipeline::PatientPackage>(pipeline::read_package(given.patient))),
      package(*read),
      curriculum(curriculum_with(given.curriculum, given.scenario)),
      scenario(scenario_of(given, *curriculum.find(given.scenario))),
      dual_task(scenario.distractions),
      description(scene_from_package(package, scenario)),
      package_sha256(sha256_of_file(given.patient / "patient.yaml")),
      results(given.out) {
  if (setup.tool) {
    use_own_tool(*setup.tool, description);
    tool_ply = tool_to_ply(*setup.tool);
  }
  const HandsSetup held{setup.device, setup.second, setup.own_device, setup.own_second_device};
  hands = std::make_unique<TwoHands>(held, package, scenario, description);
  for (const Tidied& told : tidy_records()) notices.push_back(told.whole());
  scene = setup.build_scene ? setup.build_scene(description) : engine::build_scene(description);
  setup.build_scene = {};  // what it holds of its caller is not kept
  engine::StepInput begins;
  begins.device = pose_of(starting_pose(package, scenario));
  if (description.intubation) begins.second = pose_of(starting_tube_pose(package, *description.intubation));
  at_start = engine::snapshot_at_start(*scene, begins);
  make_attempt(false);
}

bool TrialSession::Impl::by_person() const { return is_of_person(hands->device()); }

/// What scripts and records do, with one hand or both, is nobody's trial.
long long TrialSession::Impl::trainee() const {
  device::HapticDevice* second = hands->second_device();
  return by_person() && (second == nullptr || is_of_person(*second)) ? setup.trainee_id : 0;
}

void TrialSession::Impl::make_attempt(bool at_vallecula) {
  attempt.reset();
  picture.begin_anew();
  device::HapticDevice* second = hands->second_device();
  needs_eyes = by_person() || (second != nullptr && is_of_person(*second));
  engine::HapticPort& port = hands->begin();
  std::int64_t lead_in_ticks = 0;
  if (at_vallecula) {
    device::Trajectory way = way_to_vallecula(package);
    const device::Keyframe there = way.at(way.end_s());
    lead_in_ticks = std::llround((way.end_s() - way.start_s()) / kServoPeriodS);
    hands->lead_in(std::move(way), lead_in_ticks);
    // What turns and lifts about the tool's own axes has them from the start.
    if (auto* mouse = dynamic_cast<device::MouseDevice*>(&hands->device()))
      mouse->place(there.position_m, there.rotation_wxyz);
  }
  attempt = std::make_unique<TrialAttempt>(
      AttemptFrame{scenario, results, tool_ply, setup.final_out, *hands, dual_task, picture, setup.realtime,
                   answers_distractions(setup.device)},
      scene, port, header(lead_in_ticks),
      curricula::OpenTrial{"", "", curriculum.id, scenario.id, hands->kind(), results.log(), trainee(),
                           curriculum.module_of(scenario.id)->id});
}

curricula::LogHeader TrialSession::Impl::header(std::int64_t lead_in_ticks) const {
  curricula::LogHeader header = header_of(package, scenario, description);
  header.package_path = path_for_log(setup.patient, results.folder());
  header.package_sha256 = package_sha256;
  header.curriculum_path = path_for_log(setup.curriculum, results.folder());
  if (!tool_ply.empty()) header.tool_sha256 = sha256_of_bytes(tool_ply);
  header.device_kind = hands->kind();
  header.servo_period_s = kServoPeriodS;
  header.realtime = setup.realtime;
  header.settings.merge(hands->settings());
  if (lead_in_ticks > 0) header.settings[curricula::kLeadInTicks] = static_cast<double>(lead_in_ticks);
  return header;
}

void TrialSession::Impl::must_be_practice(const char* what) const {
  if (scenario.attempt.mode == curricula::Mode::assessment)
    throw std::runtime_error(std::string("an assessment ") + what + "; practise the scenario for that");
}

void TrialSession::Impl::reset(bool at_vallecula, const std::function<void()>& between) {
  const bool running = attempt->started();
  attempt->halt();
  hands->let_go();
  if (hands->frozen_by(Holder::picture)) hands->freeze(Holder::picture, false);  // the old attempt's
  std::unique_ptr<TrialAttempt> before = std::move(attempt);
  if (!running) before.reset();
  hands->renew_scripts();
  if (between) between();
  make_attempt(at_vallecula);
  if (running) attempt->start(std::move(before));
}

TrialOutcome TrialSession::Impl::finish(const std::string& how) {
  if (!attempt || !attempt->started()) throw std::logic_error("this trial was not started, or is finished already");
  attempt->halt();
  hands->let_go();
  const TrialAttempt::Kept kept = attempt->finish(how);
  return {kept.score,
          results.log(),
          results.score_json(),
          results.report(),
          results.force_plot(),
          kept.fault,
          curricula::rules_of(scenario.attempt.mode).replay,
          by_person(),
          kept.record_id};
}

TrialSession::TrialSession(const TrialSetup& setup) : impl_(std::make_unique<Impl>(setup)) {}
TrialSession::~TrialSession() { halt(); }
void TrialSession::halt() {
  if (impl_->attempt) impl_->attempt->halt();
  impl_->hands->let_go();
}

const pipeline::PatientPackage& TrialSession::package() const { return impl_->package; }
const curricula::Scenario& TrialSession::scenario() const { return impl_->scenario; }
const engine::SceneDescription& TrialSession::scene() const { return impl_->description; }
std::shared_ptr<const engine::Scene> TrialSession::built_scene() const { return impl_->scene; }
const std::vector<std::string>& TrialSession::notices() const { return impl_->notices; }
device::HapticDevice& TrialSession::device() { return impl_->hands->device(); }
device::HapticDevice* TrialSession::second_device() { return impl_->hands->second_device(); }
DualTask& TrialSession::dual_task() { return impl_->dual_task; }
bool TrialSession::by_person() const { return impl_->by_person(); }
HandActions& TrialSession::actions() { return impl_->hands->actions(); }
bool TrialSession::takes_turns() const { return impl_->hands->takes_turns(); }
Tool TrialSession::in_hand() const { return impl_->hands->in_hand(); }
bool TrialSession::led_in() const { return impl_->hands->led_in(); }
void TrialSession::start() { impl_->attempt->start(nullptr); }
bool TrialSession::starting() const {
  return impl_->attempt->started() && !impl_->attempt->begun() && !impl_->attempt->ended();
}
std::string TrialSession::problem() const { return impl_->attempt->problem(); }
std::string TrialSession::pause() const { return impl_->hands->pause(); }
void TrialSession::confirm() { impl_->hands->confirm(); }
void TrialSession::freeze(Holder holder, bool on) {
  if (on) impl_->must_be_practice("is not held up");
  impl_->hands->freeze(holder, on);
}
void TrialSession::picture_shown() {
  if (impl_->needs_eyes) impl_->picture.shown();
}
void TrialSession::picture_expected() {
  if (impl_->needs_eyes) impl_->picture.expected();
}
bool TrialSession::frozen() const { return impl_->hands->frozen(); }
bool TrialSession::frozen_by(Holder holder) const { return impl_->hands->frozen_by(holder); }
PeaksSoFar TrialSession::peaks() const { return impl_->attempt->peaks(); }
double TrialSession::paused_s() const { return kServoPeriodS * static_cast<double>(impl_->attempt->paused_ticks()); }
std::string TrialSession::fault() const { return fault_words(impl_->attempt->loop_fault()); }
bool TrialSession::finished() const { return impl_->attempt->ended(); }
const engine::Snapshot& TrialSession::at_start() const { return impl_->at_start; }
const engine::Snapshot& TrialSession::latest() { return impl_->attempt->runner().latest(); }
TrialOutcome TrialSession::finish(const std::string& how) { return impl_->finish(how); }
void TrialSession::reset(const std::function<void()>& between) { impl_->reset(false, between); }

void TrialSession::reset_at_vallecula(const std::function<void()>& between) {
  impl_->must_be_practice("begins in front of the mouth");
  impl_->reset(true, between);
}

}  // namespace vallecula::gui
