// What a person asks for by keys while the hands are busy: set by the window, read by the servo; wait-free.
#pragma once

#include <atomic>
#include <cstdint>

#include "engine/tube/intubation_record.h"

namespace vallecula::gui {

class HandActions {
 public:
  /// A bit of engine::Action, as its key goes down and up.
  void hold(engine::Action action, bool down) noexcept {
    if (down)
      bits_.fetch_or(action, std::memory_order_relaxed);
    else
      bits_.fetch_and(~static_cast<std::uint32_t>(action), std::memory_order_relaxed);
  }
  bool held(engine::Action action) const noexcept { return (bits() & action) != 0; }
  std::uint32_t bits() const noexcept { return bits_.load(std::memory_order_relaxed); }
  /// The one device takes the other tool; no effect where each hand has its own.
  void change_hand() noexcept { changes_.fetch_add(1, std::memory_order_relaxed); }
  std::uint32_t changes() const noexcept { return changes_.load(std::memory_order_relaxed); }
  /// The one who steers the blade takes hold of it anew, where it is, with the device as it stands from now on: asked
  /// for once the device has been put there.
  void take_hold() noexcept { holds_.fetch_add(1, std::memory_order_release); }
  std::uint32_t holds() const noexcept { return holds_.load(std::memory_order_acquire); }
  /// A new attempt begins with nothing held.
  void release_all() noexcept { bits_.store(0, std::memory_order_relaxed); }

 private:
  std::atomic<std::uint32_t> bits_{0}, changes_{0}, holds_{0};
};

}  // namespace vallecula::gui
