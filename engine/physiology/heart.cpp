#include "engine/physiology/heart.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

constexpr double kSlowest = 40.0;   // 1/min: an escape rhythm
constexpr double kFastest = 220.0;  // 1/min: no driven heart beats faster (assumed)
// Of what a heart is driven off, a whole breath takes so much back: half of it within seven (assumed).
constexpr double kBackPerBreath = 0.1;
constexpr double kLeastLoad = 0.2;  // N: less is not noticed
// The vagus answers a load's change: one that stays is forgotten after some 10 s (two stages of this time constant
// each, assumed), so that a tube which lies well lets the heart go back to rest within half a minute.
constexpr double kGetsUsed = 5.0;                           // s
constexpr double kVagalShare = 0.7;                         // of the way to the slowest rate, at the largest load
constexpr double kReflexBegins = 0.60, kReflexFull = 0.30;  // tissue saturation, chemoreflex
constexpr double kDirectBegins = 0.30, kDirectFull = 0.05;  // tissue saturation, the heart's own muscle
constexpr double kTissueLag = 5.0, kSlowing = 3.0, kQuickening = 4.0, kInflationFades = 6.0;  // s
constexpr double kInflationPerBreath = 0.3, kInflationShare = 0.7;
// 0.025 a breath is a time constant of one minute at 40 breaths a minute: medians 96, 139 and 163 at 1, 2 and 5 minutes
// (Dawson 2010, Arch Dis Child 95:F177).
constexpr double kAwakeningPerBreath = 0.025;

double ramp(double value, double begins, double full) noexcept {
  return std::clamp((begins - value) / (begins - full), 0.0, 1.0);
}

void follow(double& value, double target, double time_s, double dt_s) noexcept {
  value += (target - value) * dt_s / (time_s + dt_s);
}

}  // namespace

HeartState start(const Heart& h, double arterial) noexcept {
  HeartState s;
  s.awakening = h.first_per_min < h.resting_per_min ? 0.0 : 1.0;
  s.per_min = h.first_per_min;
  s.tissue = arterial;
  return s;
}

void breathe(HeartState& s, double share) noexcept {
  s.awakening += share * kAwakeningPerBreath * (1.0 - s.awakening);
  s.inflation += share * kInflationPerBreath * (1.0 - s.inflation);
  s.driven_per_min *= 1.0 - std::min(1.0, share) * kBackPerBreath;
}

void beat(const Heart& h, HeartState& s, double arterial, double load_n, double dt_s) noexcept {
  follow(s.tissue, arterial, kTissueLag, dt_s);
  follow(s.inflation, 0.0, kInflationFades, dt_s);
  const double load = std::max(0.0, load_n - s.used_to_n - kLeastLoad);
  const double vagal = kVagalShare * load / (load + h.half_load_n);
  const double chemo = ramp(s.tissue, kReflexBegins, kReflexFull) * (1.0 - kInflationShare * s.inflation);
  const double reflex = h.reflex * (1.0 - (1.0 - vagal) * (1.0 - chemo));
  const double direct = ramp(s.tissue, kDirectBegins, kDirectFull);
  const double free = h.first_per_min + s.awakening * (h.resting_per_min - h.first_per_min);
  const double target =
      std::clamp(kSlowest + (free - kSlowest) * (1.0 - reflex) * (1.0 - direct) + s.driven_per_min, kSlowest, kFastest);
  follow(s.getting_used_to_n, load_n, kGetsUsed, dt_s);
  follow(s.used_to_n, s.getting_used_to_n, kGetsUsed, dt_s);
  follow(s.per_min, target, target < s.per_min ? kSlowing : kQuickening, dt_s);
}

void drive(HeartState& s, double by_per_min) noexcept {
  const double to = std::clamp(s.per_min + by_per_min, kSlowest, kFastest), way = to - s.per_min;
  s.per_min = to;
  s.driven_per_min = std::clamp(s.driven_per_min + way, kSlowest - kFastest, kFastest - kSlowest);
}

double flow(const Heart& h, const HeartState& s) noexcept { return s.per_min / h.resting_per_min; }

}  // namespace vallecula::engine
