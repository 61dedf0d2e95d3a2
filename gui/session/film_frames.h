// Pictures' worth of snapshots, computed one after the other on one thread and shown from any.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "engine/snapshot.h"

namespace vallecula::gui {

constexpr double kFilmRateHz = 30.0;  ///< where it fits

struct FilmPlan {
  std::int64_t every_ticks = 1;  ///< frame i shows the end of tick i * every_ticks
  std::size_t frames = 0;
  std::size_t bytes = 0;  ///< of all of them
};
/// As many frames as fit, at kFilmRateHz or less; one at least where there is a tick.
FilmPlan plan_film(std::size_t ticks, double period_s, std::size_t bytes_per_frame, std::size_t most_bytes);

/// What a snapshot takes in memory.
std::size_t bytes_of(const engine::Snapshot& snapshot);

class FilmFrames {
 public:
  explicit FilmFrames(std::size_t count = 0) : frames_(count) {}

  // --- the computing thread ------------------------------------------------------------------------------------------
  bool full() const { return computed() == frames_.size(); }
  engine::Snapshot& next() { return frames_[computed()]; }
  void publish() { computed_.fetch_add(1, std::memory_order_release); }

  // --- any thread ----------------------------------------------------------------------------------------------------
  std::size_t computed() const { return computed_.load(std::memory_order_acquire); }  ///< from the first on
  /// Null while it has not been computed. It stays as it is.
  const engine::Snapshot* at(std::size_t index) const { return index < computed() ? &frames_[index] : nullptr; }

 private:
  std::vector<engine::Snapshot> frames_;
  std::atomic<std::size_t> computed_{0};
};

}  // namespace vallecula::gui
