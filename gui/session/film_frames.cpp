#include "gui/session/film_frames.h"

#include <algorithm>
#include <cmath>

namespace vallecula::gui {

FilmPlan plan_film(std::size_t ticks, double period_s, std::size_t bytes_per_frame, std::size_t most_bytes) {
  FilmPlan plan;
  if (ticks == 0) return plan;
  const std::size_t most = std::max<std::size_t>(1, most_bytes / std::max<std::size_t>(1, bytes_per_frame));
  plan.every_ticks = std::max<std::int64_t>(1, std::llround(1.0 / (kFilmRateHz * period_s)));
  plan.every_ticks = std::max(plan.every_ticks, static_cast<std::int64_t>((ticks + most - 1) / most));
  plan.frames = (ticks - 1) / static_cast<std::size_t>(plan.every_ticks) + 1;
  plan.bytes = plan.frames * bytes_per_frame;
  return plan;
}

std::size_t bytes_of(const engine::Snapshot& s) {
  return sizeof s + s.soft_points.size() * sizeof(float) +
         (s.body_displacement.size() + s.lip_displacement.size()) * sizeof(engine::Vec3);
}

}  // namespace vallecula::gui
