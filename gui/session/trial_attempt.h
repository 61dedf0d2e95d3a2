// One attempt of a trial: its loop, its log and its record, from the first tick to the last. What goes to the disk and
// to the records is done on a thread of its own, in this order: what an earlier attempt left, the log, the record, the
// ticks.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/score/score.h"
#include "curricula/trial_log.h"
#include "engine/haptics/runner.h"
#include "gui/session/dual_task.h"
#include "gui/session/peaks_so_far.h"
#include "gui/session/picture_watch.h"
#include "gui/session/results_folder.h"
#include "gui/session/trial_record.h"
#include "gui/session/two_hands.h"

namespace vallecula::gui {

/// What all attempts of a session share; must outlive them.
struct AttemptFrame {
  const curricula::Scenario& scenario;
  const ResultsFolder& results;
  const std::string& tool_ply;             ///< of a tool of its own: the bytes of its file; else empty
  const std::filesystem::path& final_out;  ///< as TrialSetup's
  TwoHands& hands;
  DualTask& dual_task;
  const PictureWatch& picture;
  bool realtime;
  bool answers_itself;  ///< its script answers what is asked beside the hands
};

class TrialAttempt {
 public:
  /// Ready to start. `registered`: what the records are told of it, without times; `header`: its log's.
  TrialAttempt(const AttemptFrame& frame, std::shared_ptr<const engine::Scene> scene, engine::HapticPort& port,
               curricula::LogHeader header, curricula::OpenTrial registered);
  /// Keeps the log of an attempt that was neither finished nor followed as interrupted.
  ~TrialAttempt();
  TrialAttempt(const TrialAttempt&) = delete;
  TrialAttempt& operator=(const TrialAttempt&) = delete;

  // --- the thread that made it ---------------------------------------------------------------------------------------
  /// Returns at once. `before`: the attempt that was reset for this one, halted; kept and scored before all else.
  void start(std::unique_ptr<TrialAttempt> before);
  bool started() const { return worker_.joinable() || writer_; }
  /// No tick comes after it and the hands are nobody's any more; waits for neither disk nor records.
  void halt();
  engine::Runner& runner() { return runner_; }
  /// Halts, waits for what is to be written, closes the log, scores it from the file, writes the results, adds the
  /// record. Throws what went wrong, now or before.
  struct Kept {
    curricula::Score score;
    std::string fault;
    long long record_id = 0;
  };
  Kept finish(const std::string& how);

  // --- any thread ----------------------------------------------------------------------------------------------------
  bool ended() const { return ended_; }
  bool begun() const { return begun_; }  ///< the first tick may come
  std::string problem() const;
  std::uint32_t loop_fault() const { return loop_fault_; }
  std::int64_t paused_ticks() const { return paused_; }
  PeaksSoFar peaks() const;

 private:
  void work();
  void open();
  void keep_after_reset();
  void record(const engine::TickRecord& tick);
  void follow(const curricula::LogTick& logged, const engine::TickRecord& tick);
  void record_in_real_time();
  void hold_what_is_not_seen();
  void run_at_full_speed();
  void join();
  std::string keep_fault(const std::filesystem::path& file) const;
  void discard_log();
  void close_log(bool complete, const std::string& how);
  [[noreturn]] void fail();
  long long add_record(const curricula::TrialLog& log, const curricula::Score& score,
                       const std::filesystem::path& file);

  const AttemptFrame frame_;
  engine::Runner runner_;
  const curricula::LogHeader header_;
  const curricula::OpenTrial registered_;
  std::unique_ptr<TrialAttempt> before_;
  std::thread worker_;
  /// Held while the loop is begun, while it runs at full speed, and while the hands are asked: once halted,
  /// nobody does.
  std::recursive_mutex gate_;

  std::atomic<bool> stop_asked_{false}, ended_{false}, begun_{false};
  std::atomic<std::uint32_t> loop_fault_{0};  ///< of the first tick that had one
  std::atomic<std::int64_t> paused_{0};       ///< ticks in which a device that a hand needs could not be used
  std::atomic<float> tongue_peak_n_{0.0f}, gum_peak_n_{0.0f};
  mutable std::mutex failure_mutex_;
  // Below: the worker's until it is joined.
  std::unique_ptr<curricula::TrialLogWriter> writer_;
  TrialRecord row_;
  std::int64_t recorded_ = 0;
  PeaksSoFar highest_;
  std::int64_t pause_began_ = -1;          ///< tick of the last one that was not paused
  std::int64_t away_ = 0;                  ///< ticks of the present pause in which nobody held it: a device is away
  std::vector<std::string> pause_faults_;  ///< as in the log's footer
  std::string ended_by_;
  std::exception_ptr failure_;  ///< under failure_mutex_
};

}  // namespace vallecula::gui
