// Hands the newest value from one writer thread to one reader thread; wait-free on both sides, never half a value.
#pragma once

#include <atomic>
#include <cstdint>

namespace vallecula::device {

/// Three slots: the writer owns one, the reader owns one, the third is exchanged. Values in between may be skipped.
template <class T>
class LatestValue {
 public:
  explicit LatestValue(const T& initial) : slots_{initial, initial, initial} {}

  /// Writer thread only.
  void publish(const T& value) noexcept {
    slots_[write_] = value;
    write_ = shared_.exchange(static_cast<std::uint8_t>(write_ | kNew), std::memory_order_acq_rel) & kSlot;
  }

  /// Reader thread only. The reference holds until the next call.
  const T& newest() noexcept {
    if (shared_.load(std::memory_order_relaxed) & kNew) {
      read_ = shared_.exchange(read_, std::memory_order_acq_rel) & kSlot;
    }
    return slots_[read_];
  }

 private:
  static constexpr std::uint8_t kSlot = 3, kNew = 4;
  T slots_[3];
  std::uint8_t write_ = 0;
  std::atomic<std::uint8_t> shared_{1};
  std::uint8_t read_ = 2;
};

}  // namespace vallecula::device
