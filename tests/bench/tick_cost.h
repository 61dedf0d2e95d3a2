// What the benches of the drivers share: ticks at 1 kHz, and what they cost.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "device/haptic_device.h"

namespace vallecula::device {

using Clock = std::chrono::steady_clock;

inline double microseconds(Clock::duration d) { return std::chrono::duration<double, std::micro>(d).count(); }

/// One line; `cost_us` (not empty) is sorted.
inline void tell(const char* what, std::vector<double>& cost_us) {
  std::sort(cost_us.begin(), cost_us.end());
  const auto at = [&](double share) {
    return cost_us[static_cast<std::size_t>(share * static_cast<double>(cost_us.size() - 1))];
  };
  std::printf("%-34s median %6.2f us   p99 %6.2f us   p99.9 %6.2f us   max %7.2f us\n", what, at(0.5), at(0.99),
              at(0.999), cost_us.back());
}

/// `ticks` ticks at 1 kHz, for a driver with a thread of its own must have something new to say. `between` is called
/// before each with its number, unmeasured.
template <class Between>
void measure(const char* what, HapticDevice& device, int ticks, Between between) {
  std::vector<double> cost(static_cast<std::size_t>(ticks));
  auto next = Clock::now();
  for (int i = 0; i < ticks; ++i) {
    between(i);
    const auto begin = Clock::now();
    const DeviceReading reading = device.read(0.001 * i);
    device.write({0.1 * reading.position_m[0], 0.0, 0.5});
    cost[static_cast<std::size_t>(i)] = microseconds(Clock::now() - begin);
    next += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(next);
  }
  tell(what, cost);
}
inline void measure(const char* what, HapticDevice& device, int ticks) {
  measure(what, device, ticks, [](int) {});
}

}  // namespace vallecula::device
