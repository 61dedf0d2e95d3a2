// Whether whoever steers a trial still sees it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace vallecula::gui {

/// Told of each picture that comes to the screen, and asked by a thread that no drawing keeps waiting. Any thread.
class PictureWatch {
 public:
  /// A hand that has seen nothing for longer steers blind. Shorter ones come with any change of the window.
  static constexpr std::chrono::milliseconds kLongest{2000};
  /// For the first one shaders are made, which takes seconds on a slow computer.
  static constexpr std::chrono::milliseconds kFirst{10000};

  void shown() noexcept { last_ns_.store(now_ns(), std::memory_order_relaxed); }
  /// One is to come, the first.
  void expected() noexcept {
    last_ns_.store(now_ns() + std::chrono::nanoseconds(kFirst - kLongest).count(), std::memory_order_relaxed);
  }
  /// Another attempt begins: it is watched once a picture is expected or has come.
  void begin_anew() noexcept { last_ns_.store(0, std::memory_order_relaxed); }
  /// No picture has come for longer than kLongest. False before one is expected: what nobody draws is not
  /// watched.
  bool stands() const noexcept {
    const std::int64_t last_ns = last_ns_.load(std::memory_order_relaxed);
    return last_ns != 0 && now_ns() - last_ns > std::chrono::nanoseconds(kLongest).count();
  }

 private:
  static std::int64_t now_ns() noexcept {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  std::atomic<std::int64_t> last_ns_{0};  ///< steady clock; 0: none yet
};

}  // namespace vallecula::gui
