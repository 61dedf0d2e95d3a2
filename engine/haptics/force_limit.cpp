#include "engine/haptics/force_limit.h"

#include <algorithm>

namespace vallecula::engine {

double trial_force(const Vec3& coupling_force, const Vec3& model_force) {
  constexpr double kHeld = 0.05;  // N; below it the scene holds nothing to press against
  const double held = model_force.norm();
  if (held < kHeld) return coupling_force.norm();
  return std::max(0.0, -coupling_force.dot(model_force) / held);
}

void judge_limit(const HapticSettings& settings, double step_s, double trial_n, bool device_valid,
                 LimitState& limit) noexcept {
  const auto enter = [&limit](HapticState state) {
    limit.state = state;
    limit.time_in_state_s = 0.0;
  };
  limit.time_in_state_s += step_s;
  const bool below = trial_n < kLeaveShare * settings.device_limit_n;
  if (!device_valid && limit.state != HapticState::lost) {
    enter(HapticState::lost);
    return;
  }
  switch (limit.state) {
    case HapticState::tracking:
      if (trial_n > settings.device_limit_n) enter(HapticState::limited);
      break;
    case HapticState::limited:
      if (below) {
        enter(HapticState::recovering);
        limit.coupling_scale = 1.0;  // the bond was never lost: it goes on at full strength
      } else if (limit.time_in_state_s > settings.limit_time_s) {
        enter(HapticState::lost);
      }
      break;
    case HapticState::lost:
      if (device_valid && below) {
        enter(HapticState::recovering);
        limit.coupling_scale = kWeakestCoupling;
      }
      break;
    case HapticState::recovering:
      if (trial_n > settings.device_limit_n) {
        enter(HapticState::limited);
        break;
      }
      limit.coupling_scale = std::min(1.0, limit.coupling_scale + step_s / kRecoveryTime);
      // Back to tracking once the bond is whole and the proxy has come within the limit's reach of the hand.
      if (limit.coupling_scale >= 1.0 && below) enter(HapticState::tracking);
      break;
  }
}

Vec3 rate_bound(const HapticSettings& settings, double step_s, const Vec3& wanted, const Vec3& last) noexcept {
  const Vec3 change = wanted - last;
  const double most = settings.force_rate_n_s * step_s, size = change.norm();
  return size > most ? Vec3(last + change * (most / size)) : wanted;
}

Vec3 displayed_force(const HapticSettings& settings, double step_s, const LimitState& limit, const Vec3& coupling_force,
                     bool usable, const Vec3& last) noexcept {
  if (!usable || !coupling_force.allFinite() || !last.allFinite()) return Vec3::Zero();
  Vec3 wanted = -coupling_force;
  if (limit.state == HapticState::lost) wanted.setZero();
  const double strength = wanted.norm();
  if (strength > settings.device_limit_n) wanted *= settings.device_limit_n / strength;
  return rate_bound(settings, step_s, wanted, last);
}

}  // namespace vallecula::engine
