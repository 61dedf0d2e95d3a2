// The device's limit (DESIGN 4.4): tracking -> limited -> lost -> recovering -> tracking, judged on the trial force.
#pragma once

#include "engine/scene.h"

namespace vallecula::engine {

struct LimitState {
  HapticState state = HapticState::tracking;
  double time_in_state_s = 0.0;
  double coupling_scale = 1.0;    ///< grows from kWeakestCoupling to 1 while recovering
};

constexpr double kWeakestCoupling = 0.05;
constexpr double kRecoveryTime = 0.4;     // s over which force and coupling come back
constexpr double kLeaveShare = 0.95;      // of f_max: the limit is left below it

/// The trial force: what the coupling at its full stiffness would press against the scene at the device pose, that is,
/// the part of its pull that works against the force the scene holds. Pulling away from the tissue is no load: without
/// this a hand that comes back from far outside would never be let in again. Without a held force: the whole pull.
double trial_force(const Vec3& coupling_force, const Vec3& model_force);

/// One tick's judgement. `device_valid`: the device can be used now.
void judge_limit(const HapticSettings& settings, double step_s, double trial_n, bool device_valid,
                 LimitState& limit) noexcept;

/// True while the proxy is held at its last admissible pose.
inline bool proxy_held(HapticState state) { return state == HapticState::limited || state == HapticState::lost; }

/// `wanted`, or as far on the way to it from `last` (both finite) as force_rate_n_s lets a tick's force go.
Vec3 rate_bound(const HapticSettings& settings, double step_s, const Vec3& wanted, const Vec3& last) noexcept;

/// The force for the device: the coupling's pull back, clamped to f_max, scaled while recovering, zero when lost, and
/// changing by no more than force_rate_n_s per second except to zero at a fault. `last` is the force shown a tick ago.
Vec3 displayed_force(const HapticSettings& settings, double step_s, const LimitState& limit, const Vec3& coupling_force,
                     bool usable, const Vec3& last) noexcept;

}  // namespace vallecula::engine
