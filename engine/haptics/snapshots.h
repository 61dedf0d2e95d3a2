// How a step's outcome reaches those who draw it.
#pragma once

#include <array>
#include <atomic>

#include "engine/snapshot.h"
#include "engine/state.h"

namespace vallecula::engine {

constexpr std::int64_t kResultSlots = 8;  ///< newest results that are kept: step s in slot s % kResultSlots

/// Makes room for the scene's points: fill_snapshot then allocates nothing.
void size_snapshot(const Scene& scene, Snapshot& s);
void fill_snapshot(const Scene& scene, const SceneState& state, const StepResult& result, Snapshot& s) noexcept;
/// The scene after one step of its own with these hands: what is there before a trial begins. Touches no trial's state.
Snapshot snapshot_at_start(const Scene& scene, const StepInput& hands);

/// Wait-free hand-over of the newest snapshot: the writer fills one of three, swaps it with the one in the middle, the
/// reader swaps the middle with its own.
class LatestSnapshot {
 public:
  explicit LatestSnapshot(const Scene& scene) {
    for (Snapshot& s : slots_) size_snapshot(scene, s);
  }
  Snapshot& to_write() { return slots_[writing_]; }
  void publish() { writing_ = middle_.exchange(writing_ | kFresh, std::memory_order_acq_rel) & ~kFresh; }
  const Snapshot& read() {
    if (middle_.load(std::memory_order_acquire) & kFresh)
      reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & ~kFresh;
    return slots_[reading_];
  }

 private:
  static constexpr int kFresh = 4;
  std::array<Snapshot, 3> slots_;
  int writing_ = 0, reading_ = 2;
  std::atomic<int> middle_{1};
};

}  // namespace vallecula::engine
