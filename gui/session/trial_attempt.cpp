#include "gui/session/trial_attempt.h"

#include <chrono>
#include <stdexcept>
#include <system_error>

#include "gui/session/fault_report.h"
#include "gui/session/files.h"
#include "gui/session/log_conversion.h"
#include "gui/session/placed_tool.h"
#include "gui/session/trial_clock.h"
#include "gui/session/trial_results.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

constexpr auto kRecorderPeriod = std::chrono::milliseconds(5);  ///< the ring holds 8 s
/// A device or a picture that is away for longer ends the trial; a person may hold it up for as long as they like.
constexpr double kLongestPauseS = 600.0;
constexpr std::int64_t kChunkTicks = 10;  ///< not in real time: ticks between two looks at the stop flag

}  // namespace

TrialAttempt::TrialAttempt(const AttemptFrame& frame, std::shared_ptr<const engine::Scene> scene,
                           engine::HapticPort& port, curricula::LogHeader header, curricula::OpenTrial registered)
    : frame_(frame),
      runner_(std::move(scene), port),
      header_(std::move(header)),
      registered_(std::move(registered)),
      highest_(header_) {}

TrialAttempt::~TrialAttempt() {
  halt();
  join();
  if (!writer_) return;
  if (recorded_ == 0) {
    discard_log();
    return;
  }
  if (failure_) return;  // what could be written stays, as in fail()
  try {
    close_log(false, "interrupted");
    keep_fault(frame_.results.fault_csv());
  } catch (const std::exception&) {
    // Nothing can be said from here; what was written whole is recovered from the .part file.
  }
}

void TrialAttempt::start(std::unique_ptr<TrialAttempt> before) {
  if (started()) throw std::logic_error("this trial has been started already");
  before_ = std::move(before);
  worker_ = std::thread([this] {
    try {
      work();
    } catch (...) {
      const std::lock_guard<std::mutex> lock(failure_mutex_);
      failure_ = std::current_exception();
    }
    ended_ = true;
  });
}

void TrialAttempt::work() {
  if (before_) before_->keep_after_reset();
  before_.reset();
  if (stop_asked_) return;
  open();
  {
    const std::lock_guard<std::recursive_mutex> lock(gate_);
    if (stop_asked_) return;
    frame_.dual_task.begin(frame_.answers_itself);
    if (frame_.realtime) runner_.start();
    begun_ = true;
  }
  frame_.realtime ? record_in_real_time() : run_at_full_speed();
}

/// The log, and its place among the records: no tick runs before both are there.
void TrialAttempt::open() {
  // First, since it holds the folder: what another trial is about to leave there is not taken for an older one's.
  writer_ = std::make_unique<curricula::TrialLogWriter>(frame_.results.log(), header_);
  frame_.results.remove_older_trial();
  if (!frame_.tool_ply.empty()) write_file_whole(frame_.results.tool(), frame_.tool_ply);
  row_.begin(registered_);
}

void TrialAttempt::halt() {
  stop_asked_ = true;
  const std::lock_guard<std::recursive_mutex> lock(gate_);
  runner_.stop();
}

void TrialAttempt::join() {
  if (worker_.joinable()) worker_.join();
}

std::string TrialAttempt::problem() const {
  const std::lock_guard<std::mutex> lock(failure_mutex_);
  if (!failure_) return "";
  try {
    std::rethrow_exception(failure_);
  } catch (const std::exception& error) {
    return error.what();
  }
}

PeaksSoFar TrialAttempt::peaks() const {
  PeaksSoFar so_far;
  so_far.tongue_n = tongue_peak_n_;
  so_far.gum_n = gum_peak_n_;
  return so_far;
}

void TrialAttempt::record(const engine::TickRecord& tick) {
  if (tick.tick != recorded_) {
    throw std::runtime_error("ticks " + std::to_string(recorded_) + " to " + std::to_string(tick.tick - 1) +
                             " were lost because the disk did not keep up; choose a faster disk for the results");
  }
  const curricula::LogTick logged = to_log(tick);
  writer_->append(logged);
  ++recorded_;
  highest_.take(logged);
  tongue_peak_n_ = highest_.tongue_n;
  gum_peak_n_ = highest_.gum_n;
  if (loop_fault_ == 0) loop_fault_ = tick.faults & kLoopFaults;
  if (ended_by_.empty()) follow(logged, tick);
}

/// What the tick means for the trial's clock, and whether it is the last.
void TrialAttempt::follow(const curricula::LogTick& logged, const engine::TickRecord& tick) {
  bool script_over = false, held = false, unseen = false;
  std::string pause_fault;
  {
    const std::lock_guard<std::recursive_mutex> lock(gate_);
    if (!stop_asked_) {
      pause_fault = frame_.hands.pause_fault();
      held = frame_.hands.held();
      unseen = frame_.hands.frozen_by(Holder::picture);
      script_over = frame_.hands.finished(tick.time_s);
    }
  }
  if (!curricula::paused(logged)) {
    pause_began_ = tick.tick;
    away_ = 0;
  } else {
    // A record of a pause does not say which fault it was.
    if (pause_began_ == tick.tick - 1) pause_faults_.push_back(pause_fault);
    ++paused_;
    if (!held) ++away_;
  }
  const double trial_s = tick.time_s - kServoPeriodS * static_cast<double>(paused_);
  for (const curricula::LogEvent& event : frame_.dual_task.advance(tick.tick, trial_s)) writer_->append(event);
  if (script_over) {
    ended_by_ = "finished";
  } else if (trial_s >= frame_.scenario.max_attempt_s) {
    ended_by_ = "the scenario's time was over";
  } else if (kServoPeriodS * static_cast<double>(away_) > kLongestPauseS) {
    ended_by_ = unseen ? "no picture came any more" : "the device did not come back";
  }
}

void TrialAttempt::record_in_real_time() {
  engine::TickRecord tick;
  while (!stop_asked_ && ended_by_.empty()) {
    while (runner_.pop(tick)) record(tick);
    hold_what_is_not_seen();
    std::this_thread::sleep_for(kRecorderPeriod);
  }
  {
    const std::lock_guard<std::recursive_mutex> lock(gate_);
    runner_.stop();
  }
  while (runner_.pop(tick)) record(tick);
}

/// From this thread, since the window's may be what waits for the picture.
void TrialAttempt::hold_what_is_not_seen() {
  if (!frame_.picture.stands()) return;
  const std::lock_guard<std::recursive_mutex> lock(gate_);
  if (stop_asked_ || frame_.hands.frozen_by(Holder::picture)) return;
  if (frame_.picture.stands()) frame_.hands.freeze(Holder::picture, true);  // still: the lock may have been waited for
}

void TrialAttempt::run_at_full_speed() {
  while (ended_by_.empty()) {
    const std::lock_guard<std::recursive_mutex> lock(gate_);
    if (stop_asked_) return;
    runner_.run(kChunkTicks, [this](const engine::TickRecord& tick) { record(tick); });
  }
}

/// Writes the ticks that led to a fault of the runner that was stopped; the sentence that tells of it, or nothing.
std::string TrialAttempt::keep_fault(const fs::path& file) const {
  const std::vector<engine::TickRecord> ticks = runner_.ticks_before_fault();
  if (ticks.empty()) return "";
  write_file_whole(file, fault_csv(ticks));
  return fault_sentence(ticks, file.filename().string());
}

void TrialAttempt::discard_log() {
  writer_.reset();
  row_.abandon();
  std::error_code ignored;
  fs::remove(frame_.results.unfinished_log(), ignored);
  if (!frame_.tool_ply.empty()) fs::remove(frame_.results.tool(), ignored);
}

/// A log that cannot be closed is left as it is on the disk.
void TrialAttempt::close_log(bool complete, const std::string& how) {
  const engine::TimingReport timing = runner_.timing();
  curricula::LogFooter footer;
  footer.complete = complete;
  footer.ended = ended_by_.empty() ? how : ended_by_;
  if (frame_.realtime) footer.loop_rate_hz = timing.loop_rate_hz;  // else there is no servo whose rate could be told
  footer.deadline_misses = timing.deadline_misses;
  footer.overruns = timing.overruns;
  footer.real_time_setup = timing.priority;
  footer.pause_faults = pause_faults_;
  const auto closing = std::move(writer_);
  closing->close(footer);
}

/// What was written whole before the failure stays on the disk; tidy_records keeps it when a program starts next.
void TrialAttempt::fail() {
  if (writer_ && recorded_ == 0) discard_log();
  writer_.reset();
  std::rethrow_exception(failure_);
}

long long TrialAttempt::add_record(const curricula::TrialLog& log, const curricula::Score& score,
                                   const fs::path& file) {
  // A record must still find its trial when the folder has been put in place.
  const fs::path folder = frame_.final_out.empty() ? frame_.results.folder() : fs::absolute(frame_.final_out);
  return row_.add(log, frame_.scenario, score, file, folder / file.filename());
}

// A reset begins anew; it does not undo what was done: the attempt stays, scored, beside the next one.
void TrialAttempt::keep_after_reset() {
  join();
  if (failure_) fail();
  if (!writer_) return;
  if (recorded_ == 0) {
    discard_log();
    return;
  }
  close_log(true, curricula::kEndedByReset);
  fs::path kept;
  for (int n = 1; kept.empty() || fs::exists(kept); ++n)
    kept = frame_.results.folder() / ("before-reset-" + std::to_string(n) + ".vtrial");
  keep_fault(fs::path(kept).replace_extension(".fault.csv"));
  fs::rename(frame_.results.log(), kept);
  row_.moved(kept);
  // Its own, since tool.ply goes with the next trial in this folder. Moved last: a log without one takes tool.ply.
  if (!frame_.tool_ply.empty()) fs::rename(frame_.results.tool(), own_tool_file(kept));
  const curricula::TrialLog log = curricula::read_trial_log(kept);
  add_record(log, curricula::score_trial(log, frame_.scenario), kept);
}

TrialAttempt::Kept TrialAttempt::finish(const std::string& how) {
  halt();
  join();
  if (failure_) fail();
  if (!writer_ || recorded_ == 0) {
    if (writer_) discard_log();
    throw std::runtime_error("the trial ended before its first tick; nothing was recorded");
  }
  close_log(true, how);
  // Scored from the file, so that `vallecula score` can only say the same.
  const curricula::TrialLog log = curricula::read_trial_log(frame_.results.log());
  Kept kept{curricula::score_trial(log, frame_.scenario), keep_fault(frame_.results.fault_csv()), 0};
  write_results(frame_.results.folder(), log, frame_.scenario, kept.score);
  kept.record_id = add_record(log, kept.score, frame_.results.log());
  return kept;
}

}  // namespace vallecula::gui
