#include "curricula/score/stays.h"

#include "curricula/score/mouth.h"

namespace vallecula::curricula {

std::vector<Stay> stays_in_mouth(const TrialLog& log) {
  std::vector<Stay> stays;
  const auto mouth = mouth_from_landmarks(log.header.landmarks_m);
  if (!mouth) return stays;
  const double period_s = log.header.servo_period_s;
  long long paused_so_far = 0;
  for (std::size_t i = 0; i < log.ticks.size(); ++i) {
    const LogTick& tick = log.ticks[i];
    if (paused(tick)) {
      ++paused_so_far;
      continue;
    }
    if (tick.step_used < 0 || !mouth->holds(tick.proxy_pose.position_m)) continue;  // no step yet: no proxy yet
    const auto out_s = [&](const Stay& stay) {
      return tick.time_s - stay.last_s - period_s * static_cast<double>(paused_so_far - stay.paused_at_last);
    };
    if (stays.empty() || out_s(stays.back()) > kOutForAnEntryS)
      stays.push_back({i, i, tick.time_s, tick.time_s, paused_so_far, paused_so_far});
    stays.back().last = i;
    stays.back().last_s = tick.time_s;
    stays.back().paused_at_last = paused_so_far;
  }
  return stays;
}

std::vector<Stay> attempts_in(const TrialLog& log) {
  std::vector<Stay> stays = stays_in_mouth(log);
  if (log.header.has_intubation || stays.size() < 2) return stays;
  Stay whole = stays.front();
  whole.last = stays.back().last;
  whole.last_s = stays.back().last_s;
  whole.paused_at_last = stays.back().paused_at_last;
  return {whole};
}

}  // namespace vallecula::curricula
