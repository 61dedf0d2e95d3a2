#include "device/action_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "device/trajectory.h"

namespace vallecula::device {

namespace {

constexpr std::array<const char*, kActionWords> kWords = {
    "breath", "suction", "press", "stylet-out", "catheter", "eye-right", "eye-left", "eye-up", "eye-down", "extend"};

}  // namespace

ActionPlan::ActionPlan(std::vector<TimedActions> changes) : changes_(std::move(changes)) {
  for (std::size_t i = 0; i < changes_.size(); ++i)
    if (!std::isfinite(changes_[i].time_s) || (i > 0 && !(changes_[i].time_s > changes_[i - 1].time_s)))
      throw DeviceError("actions: change " + std::to_string(i + 1) + " is not later than the one before");
}

std::uint32_t ActionPlan::at(double time_s) const noexcept {
  const auto next = std::upper_bound(changes_.begin(), changes_.end(), time_s,
                                     [](double t, const TimedActions& c) { return t < c.time_s; });
  return next == changes_.begin() ? 0 : (next - 1)->bits;
}

std::uint32_t actions_of(const std::string& words) {
  if (words.empty() || words == "-") return 0;
  std::uint32_t bits = 0;
  for (std::size_t from = 0; from != std::string::npos;) {
    const std::size_t plus = words.find('+', from);
    const std::string word = words.substr(from, plus == std::string::npos ? plus : plus - from);
    const auto known = std::find(kWords.begin(), kWords.end(), word);
    if (known == kWords.end()) {
      std::string all;
      for (const char* one : kWords) all += (all.empty() ? "" : ", ") + std::string(one);
      throw DeviceError("there is no action '" + word.substr(0, 40) + "'; join words with + from " + all +
                        ", or write - for none");
    }
    bits |= 1u << (kFirstActionBit + static_cast<int>(known - kWords.begin()));
    from = plus == std::string::npos ? plus : plus + 1;
  }
  return bits;
}

}  // namespace vallecula::device
