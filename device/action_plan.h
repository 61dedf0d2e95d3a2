// What a script asks for besides its hands' ways: keys held down by time, as bits that mean nothing here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vallecula::device {

struct TimedActions {
  double time_s = 0.0;
  std::uint32_t bits = 0;  ///< held from here to the next one
};

class ActionPlan {
 public:
  ActionPlan() = default;
  /// Throws DeviceError unless times are finite and increase strictly.
  explicit ActionPlan(std::vector<TimedActions> changes);

  /// What is held at a time: 0 before the first change. Allocates nothing.
  std::uint32_t at(double time_s) const noexcept;
  const std::vector<TimedActions>& changes() const noexcept { return changes_; }

 private:
  std::vector<TimedActions> changes_;
};

/// The words of a file's actions column, from the bit 1 << kFirstActionBit on: "breath", "suction", "press", "stylet-out",
/// "catheter", "eye-right", "eye-left", "eye-up", "eye-down", "extend". The application gives these bits their meaning.
constexpr int kFirstActionBit = 16, kActionWords = 10;
/// Bits of words joined by +; "" and "-" are none. Throws DeviceError that names what words there are.
std::uint32_t actions_of(const std::string& words);

}  // namespace vallecula::device
