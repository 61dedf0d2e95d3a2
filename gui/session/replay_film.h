// A recorded trial computed anew into pictures' worth of snapshots, so that any second that has been computed can be
// shown at once: the tissue's shape is not in the log.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "curricula/trial_log.h"
#include "engine/haptics/runner.h"
#include "engine/scene.h"
#include "engine/snapshot.h"
#include "gui/session/film_frames.h"

namespace vallecula::gui {

/// At most this much is kept, besides the log; a longer trial or a finer mesh has fewer frames a second.
constexpr std::size_t kFilmBytes = std::size_t{512} << 20;

class ReplayFilm {
 public:
  /// Begins to compute on a thread of its own, as fast as it goes. Throws std::runtime_error for a log without ticks.
  ReplayFilm(std::shared_ptr<const curricula::TrialLog> log, const engine::SceneDescription& description,
             std::size_t most_bytes = kFilmBytes);
  ~ReplayFilm();  ///< stops within a tick
  ReplayFilm(const ReplayFilm&) = delete;
  ReplayFilm& operator=(const ReplayFilm&) = delete;

  const FilmPlan& plan() const { return plan_; }
  double frame_s() const { return static_cast<double>(plan_.every_ticks) * log_->header.servo_period_s; }
  double time_s(std::size_t frame) const;          ///< of the trial
  std::size_t frame_at(double time_s) const;       ///< the last one not later; the first or last one outside
  /// Any thread: null while it has not been computed. Poses, forces, sight and the tube's figures are the recorded ones,
  /// bit for bit; the shapes are computed. It stays as it is.
  const engine::Snapshot* frame(std::size_t index) const;
  std::size_t computed() const { return frames_->computed(); }  ///< frames, from the first on
  bool finished() const { return finished_.load(std::memory_order_acquire); }         ///< whole, or stopped
  /// Computes no further; what there is stays.
  void stop() { stop_ = true; }
  /// Once finished: what is to be said of the film, for a person; empty: every tick came out as recorded, to the bit.
  std::string remark() const;

 private:
  void compute();
  std::shared_ptr<const curricula::TrialLog> log_;
  engine::Replayer replayer_;
  FilmPlan plan_;
  std::optional<FilmFrames> frames_;  ///< sized before the thread begins
  std::atomic<bool> stop_{false}, finished_{false};
  std::string remark_;  ///< written before finished_
  std::thread worker_;
};

}  // namespace vallecula::gui
