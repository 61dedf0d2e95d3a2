#include "gui/session/trial_session.h"

#include <chrono>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "curricula/trial_log.h"
#include "engine/haptics/runner.h"
#include "gui/session/device_choice.h"
#include "gui/session/fault_report.h"
#include "gui/session/files.h"
#include "gui/session/log_conversion.h"
#include "gui/session/log_paths.h"
#include "gui/session/placed_tool.h"
#include "gui/session/results_folder.h"
#include "gui/session/scene_from_package.h"
#include "gui/session/trial_header.h"
#include "gui/session/trial_record.h"
#include "gui/session/trial_results.h"
#include "gui/session/two_hands.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

constexpr auto kRecorderPeriod = std::chrono::milliseconds(5);  ///< the ring holds 8 s
constexpr double kPeriodS = 0.001;                        ///< of the servo
constexpr double kLongestPauseS = 600.0;                  ///< a device that is away for longer ends the trial
constexpr std::int64_t kChunkTicks = 10;  ///< not in real time: ticks between two looks at the stop flag

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
    throw std::runtime_error("scenario '" + written.id + "' has no variation that a seed could draw from; leave the seed out");
  return curricula::attempt_of(written, setup.mode, setup.attempt_seed, setup.taken);
}

bool is_of_person(const device::HapticDevice& device) {
  const std::string kind = device.info().kind;
  return kind != "scripted" && kind != "recorded";
}

}  // namespace

struct TrialSession::Impl {
  explicit Impl(const TrialSetup& setup);
  ~Impl();

  void make_runner();
  std::string keep_fault(const fs::path& file) const;
  void start();
  void stop();
  void record(const engine::TickRecord& tick);
  void record_in_real_time();
  void run_at_full_speed();
  void discard_log();
  void close_log(const curricula::LogFooter& footer);
  [[noreturn]] void fail();
  void keep_log_of_reset();
  long long add_record(const curricula::TrialLog& log, const curricula::Score& score, const fs::path& file);
  curricula::LogHeader header() const;
  curricula::LogFooter footer(bool complete, const std::string& how) const;
  bool by_person() const;
  long long trainee() const;
  TrialOutcome finish(const std::string& how);

  TrialSetup setup;
  pipeline::PatientPackage package;
  curricula::Curriculum curriculum;
  curricula::Scenario scenario;
  DualTask dual_task;
  engine::SceneDescription description;
  std::shared_ptr<const engine::Scene> scene;
  std::string package_sha256;
  std::string tool_ply;  ///< of a tool of its own: the bytes of its file; else empty
  ResultsFolder results;
  std::unique_ptr<TwoHands> hands;
  std::unique_ptr<engine::Runner> runner;
  std::unique_ptr<curricula::TrialLogWriter> writer;
  TrialRecord record_row;
  std::vector<std::string> notices;  ///< of what was cut off before
  std::thread worker;  ///< real time: empties the ring; else: runs the scene as well

  std::atomic<bool> stop_asked{false};
  std::atomic<bool> ended{false};
  std::atomic<std::uint32_t> loop_fault{0};  ///< of the first tick that had one
  std::atomic<std::int64_t> paused{0};       ///< ticks in which a device that a hand needs could not be used
  // Below: the worker's until it is joined.
  std::int64_t recorded = 0;
  std::int64_t pause_began = 0;  ///< tick of the last one that was not paused
  std::vector<std::string> pause_faults;  ///< as in the log's footer
  std::string ended_by;
  std::exception_ptr failure;
};

TrialSession::Impl::Impl(const TrialSetup& given)
    : setup(given),
      package(pipeline::read_package(given.patient)),
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
  scene = engine::build_scene(description);
  make_runner();
}

TrialSession::Impl::~Impl() {
  stop();
  if (!writer) return;
  if (recorded == 0) {
    discard_log();
    return;
  }
  if (failure) return;  // what could be written stays, as in fail()
  try {
    close_log(footer(false, "interrupted"));
    keep_fault(results.fault_csv());
  } catch (const std::exception&) {
    // Nothing can be said from here; what was written whole is recovered from the .part file.
  }
}

/// Writes the ticks that led to a fault of the runner that was stopped; the sentence that tells of it, or nothing.
std::string TrialSession::Impl::keep_fault(const fs::path& file) const {
  const std::vector<engine::TickRecord> ticks = runner->ticks_before_fault();
  if (ticks.empty()) return "";
  write_file_whole(file, fault_csv(ticks));
  return fault_sentence(ticks, file.filename().string());
}

bool TrialSession::Impl::by_person() const { return is_of_person(hands->device()); }

/// What scripts and records do, with one hand or both, is nobody's trial.
long long TrialSession::Impl::trainee() const {
  device::HapticDevice* second = hands->second_device();
  return by_person() && (second == nullptr || is_of_person(*second)) ? setup.trainee_id : 0;
}

void TrialSession::Impl::make_runner() {
  runner.reset();
  runner = std::make_unique<engine::Runner>(scene, hands->begin());
}

curricula::LogHeader TrialSession::Impl::header() const {
  curricula::LogHeader header = header_of(package, scenario, description);
  header.package_path = path_for_log(setup.patient, results.folder());
  header.package_sha256 = package_sha256;
  header.curriculum_path = path_for_log(setup.curriculum, results.folder());
  if (!tool_ply.empty()) header.tool_sha256 = sha256_of_bytes(tool_ply);
  header.device_kind = hands->kind();
  header.servo_period_s = kPeriodS;
  header.realtime = setup.realtime;
  header.settings.merge(hands->settings());
  return header;
}

curricula::LogFooter TrialSession::Impl::footer(bool complete, const std::string& how) const {
  const engine::TimingReport timing = runner->timing();
  curricula::LogFooter footer;
  footer.complete = complete;
  footer.ended = ended_by.empty() ? how : ended_by;
  if (setup.realtime) footer.loop_rate_hz = timing.loop_rate_hz;  // else there is no servo whose rate could be told
  footer.deadline_misses = timing.deadline_misses;
  footer.overruns = timing.overruns;
  footer.real_time_setup = timing.priority;
  footer.pause_faults = pause_faults;
  return footer;
}

void TrialSession::Impl::start() {
  if (worker.joinable() || writer) throw std::logic_error("this trial has been started already");
  // First, since it holds the folder: what another trial is about to leave there is not taken for an older one's.
  writer = std::make_unique<curricula::TrialLogWriter>(results.log(), header());
  results.remove_older_trial();
  if (!tool_ply.empty()) write_file_whole(results.tool(), tool_ply);
  record_row.begin({"", "", curriculum.id, scenario.id, hands->kind(), results.log(), trainee(),
                    curriculum.module_of(scenario.id)->id});
  recorded = 0;
  ended_by.clear();
  failure = nullptr;
  ended = false;
  stop_asked = false;
  loop_fault = 0;
  paused = 0;
  pause_began = -1;
  pause_faults.clear();
  dual_task.begin(answers_distractions(setup.device));
  if (setup.realtime) runner->start();
  worker = std::thread([this] {
    try {
      setup.realtime ? record_in_real_time() : run_at_full_speed();
    } catch (...) {
      failure = std::current_exception();
    }
    ended = true;
  });
}

void TrialSession::Impl::stop() {
  stop_asked = true;
  if (worker.joinable()) worker.join();
  if (runner) runner->stop();
  if (hands) hands->let_go();
}

void TrialSession::Impl::record(const engine::TickRecord& tick) {
  if (tick.tick != recorded) {
    throw std::runtime_error("ticks " + std::to_string(recorded) + " to " + std::to_string(tick.tick - 1) +
                             " were lost because the disk did not keep up; choose a faster disk for the results");
  }
  const curricula::LogTick logged = to_log(tick);
  writer->append(logged);
  ++recorded;
  if (loop_fault == 0) loop_fault = tick.faults & kLoopFaults;
  if (!ended_by.empty()) return;
  if (!curricula::paused(logged)) {
    pause_began = tick.tick;
  } else {
    // A record of a pause does not say which fault it was.
    if (pause_began == tick.tick - 1)
      pause_faults.push_back(hands->pause_fault());
    ++paused;
  }
  const double trial_s = tick.time_s - kPeriodS * static_cast<double>(paused);
  for (const curricula::LogEvent& event : dual_task.advance(tick.tick, trial_s)) writer->append(event);
  if (hands->finished(tick.time_s)) {
    ended_by = "finished";
  } else if (trial_s >= scenario.max_attempt_s) {
    ended_by = "the scenario's time was over";
  } else if (kPeriodS * static_cast<double>(tick.tick - pause_began) > kLongestPauseS) {
    ended_by = "the device did not come back";
  }
}

void TrialSession::Impl::record_in_real_time() {
  engine::TickRecord tick;
  while (!stop_asked && ended_by.empty()) {
    while (runner->pop(tick)) record(tick);
    std::this_thread::sleep_for(kRecorderPeriod);
  }
  runner->stop();
  while (runner->pop(tick)) record(tick);
}

void TrialSession::Impl::run_at_full_speed() {
  while (!stop_asked && ended_by.empty()) {
    runner->run(kChunkTicks, [this](const engine::TickRecord& tick) { record(tick); });
  }
}

void TrialSession::Impl::discard_log() {
  writer.reset();
  record_row.abandon();
  std::error_code ignored;
  fs::remove(results.unfinished_log(), ignored);
  if (!tool_ply.empty()) fs::remove(results.tool(), ignored);
}

/// A log that cannot be closed is left as it is on the disk.
void TrialSession::Impl::close_log(const curricula::LogFooter& footer) {
  const auto closing = std::move(writer);
  closing->close(footer);
}

/// What was written whole before the failure stays on the disk; tidy_records keeps it when a program starts next.
void TrialSession::Impl::fail() {
  if (recorded == 0) discard_log();
  writer.reset();
  std::rethrow_exception(failure);
}

long long TrialSession::Impl::add_record(const curricula::TrialLog& log, const curricula::Score& score,
                                         const fs::path& file) {
  // A record must still find its trial when the folder has been put in place.
  const fs::path folder = setup.final_out.empty() ? results.folder() : fs::absolute(setup.final_out);
  return record_row.add(log, scenario, score, file, folder / file.filename());
}

// A reset begins anew; it does not undo what was done: the attempt stays, scored, beside the next one.
void TrialSession::Impl::keep_log_of_reset() {
  if (writer && failure) fail();
  if (!writer || recorded == 0) {
    discard_log();
    return;
  }
  close_log(footer(true, "reset"));
  fs::path kept;
  for (int n = 1; kept.empty() || fs::exists(kept); ++n)
    kept = results.folder() / ("before-reset-" + std::to_string(n) + ".vtrial");
  keep_fault(fs::path(kept).replace_extension(".fault.csv"));
  fs::rename(results.log(), kept);
  record_row.moved(kept);
  // Its own, since tool.ply goes with the next trial in this folder. Moved last: a log without one takes tool.ply.
  if (!tool_ply.empty()) fs::rename(results.tool(), own_tool_file(kept));
  const curricula::TrialLog log = curricula::read_trial_log(kept);
  add_record(log, curricula::score_trial(log, scenario), kept);
}

TrialOutcome TrialSession::Impl::finish(const std::string& how) {
  if (!writer) throw std::logic_error("this trial was not started, or is finished already");
  stop();
  if (failure) fail();
  if (recorded == 0) {
    discard_log();
    throw std::runtime_error("the trial ended before its first tick; nothing was recorded");
  }
  close_log(footer(true, how));

  // Scored from the file, so that `vallecula score` can only say the same.
  const curricula::TrialLog log = curricula::read_trial_log(results.log());
  TrialOutcome outcome{curricula::score_trial(log, scenario), results.log(), results.score_json(), results.report(),
                       results.force_plot(), keep_fault(results.fault_csv()),
                       curricula::rules_of(scenario.attempt.mode).replay, by_person()};
  write_results(results.folder(), log, scenario, outcome.score);

  outcome.record_id = add_record(log, outcome.score, outcome.log);
  return outcome;
}

TrialSession::TrialSession(const TrialSetup& setup) : impl_(std::make_unique<Impl>(setup)) {}
TrialSession::~TrialSession() = default;

const pipeline::PatientPackage& TrialSession::package() const { return impl_->package; }
const curricula::Scenario& TrialSession::scenario() const { return impl_->scenario; }
const engine::SceneDescription& TrialSession::scene() const { return impl_->description; }
const std::vector<std::string>& TrialSession::notices() const { return impl_->notices; }
device::HapticDevice& TrialSession::device() { return impl_->hands->device(); }
device::HapticDevice* TrialSession::second_device() { return impl_->hands->second_device(); }
DualTask& TrialSession::dual_task() { return impl_->dual_task; }
bool TrialSession::by_person() const { return impl_->by_person(); }
HandActions& TrialSession::actions() { return impl_->hands->actions(); }
bool TrialSession::takes_turns() const { return impl_->hands->takes_turns(); }
Tool TrialSession::in_hand() const { return impl_->hands->in_hand(); }
void TrialSession::start() { impl_->start(); }
std::string TrialSession::pause() const { return impl_->hands->pause(); }
void TrialSession::confirm() { impl_->hands->confirm(); }
double TrialSession::paused_s() const { return kPeriodS * static_cast<double>(impl_->paused); }
std::string TrialSession::fault() const { return fault_words(impl_->loop_fault); }
bool TrialSession::finished() const { return impl_->ended; }
const engine::Snapshot& TrialSession::latest() { return impl_->runner->latest(); }
TrialOutcome TrialSession::finish(const std::string& how) { return impl_->finish(how); }

void TrialSession::reset(const std::function<void()>& between) {
  const bool running = impl_->writer != nullptr;
  impl_->stop();
  impl_->keep_log_of_reset();
  impl_->runner.reset();
  impl_->hands->renew_scripts();
  if (between) between();
  impl_->make_runner();
  if (running) impl_->start();
}

}  // namespace vallecula::gui
