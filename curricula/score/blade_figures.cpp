#include "curricula/score/blade_figures.h"

#include "curricula/score/mouth.h"
#include "curricula/score/stays.h"
#include "curricula/score/vectors.h"

namespace vallecula::curricula {

BladeFigures measure_blade(const TrialLog& log, const std::vector<Stay>& attempts) {
  BladeFigures figures;
  const auto& landmarks = log.header.landmarks_m;
  const auto mouth = mouth_from_landmarks(landmarks);
  if (!mouth || attempts.empty()) return figures;
  const Point vallecula = landmarks.at("vallecula");
  Point left = cross(plus(landmarks.at("lower_gum_midline"), landmarks.at("upper_gum_midline"), -1.0), mouth->axis);
  const double length = magnitude(left);
  const bool has_midline = length > 0.0;  // closed gums span no plane
  if (has_midline) left = scaled(left, (left[0] < 0.0 ? -1.0 : 1.0) / length);
  const double depth_m = distance(vallecula, mouth->gum_middle_m);
  for (const Stay& attempt : attempts)
    for (std::size_t i = attempt.first; i <= attempt.last; ++i) {
      const LogTick& tick = log.ticks[i];
      const Point& tip = tick.proxy_pose.position_m;
      if (paused(tick) || !std::isfinite(magnitude(tip))) continue;
      const Point from_vallecula = plus(tip, vallecula, -1.0);
      const double away_m = magnitude(from_vallecula), beyond_m = dot(from_vallecula, mouth->axis);
      const auto to_left = [&] { return has_midline ? std::optional<double>(dot(from_vallecula, left)) : std::nullopt; };
      if (!figures.to_vallecula_m) figures.entry_left_m = to_left();
      if (!figures.to_vallecula_m || away_m < *figures.to_vallecula_m) {
        figures.to_vallecula_m = away_m;
        figures.to_vallecula_at_s = tick.time_s;
        figures.left_m = to_left();
      }
      if (!figures.vallecula_reached && away_m <= kReachedShare * depth_m) {
        figures.vallecula_reached = true;
        figures.vallecula_reached_at_s = tick.time_s;
      }
      if (beyond_m > figures.past_vallecula_m) {
        figures.past_vallecula_m = beyond_m;
        figures.past_vallecula_at_s = tick.time_s;
      }
    }
  return figures;
}

}  // namespace vallecula::curricula
