#include "engine/posture.h"

#include <algorithm>
#include <cmath>

#include "engine/tube/intubation_record.h"

namespace vallecula::engine {

namespace {

double towards(double target, double most, double from) noexcept {
  return std::isfinite(from) ? std::clamp(from + std::clamp(target - from, -most, most), -1.0, 1.0) : 0.0;
}

}  // namespace

void step(PostureState& s, std::uint32_t actions, double dt_s) noexcept {
  const double dt = std::isfinite(dt_s) ? std::max(0.0, dt_s) : 0.0;
  const auto asked = [actions](Action action) { return (actions & action) != 0 ? 1.0 : 0.0; };
  s.right = towards(asked(kActionEyeRight) - asked(kActionEyeLeft), dt / kEyeMoveTime, s.right);
  s.up = towards(asked(kActionEyeUp) - asked(kActionEyeDown), dt / kEyeMoveTime, s.up);
  s.extension = towards(asked(kActionExtend), dt / kExtensionTime, s.extension);
}

double eased(double share) noexcept {
  const double x = std::abs(share);
  return std::copysign(x * x * (3.0 - 2.0 * x), share);
}

}  // namespace vallecula::engine
