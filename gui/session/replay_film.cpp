#include "gui/session/replay_film.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "gui/session/log_conversion.h"

namespace vallecula::gui {

namespace {

/// What the log knows is shown as the log has it. The first tick of a trial used no step yet and knows no tool: what the
/// replay made of that tick is shown then.
void take_recorded(const engine::TickRecord& tick, double sight, engine::Snapshot& s) {
  s.time_s = tick.time_s;
  s.ticks = tick.tick + 1;
  s.device_pose = tick.device_pose;
  s.state = tick.state;
  s.displayed_force_n = tick.displayed_force_n;
  s.glottis_visible = sight;
  s.faults = tick.faults;
  if (tick.step_used < 0) return;
  s.has_intubation = tick.has_intubation;
  s.proxy_pose = tick.proxy_pose;
  s.model_force_n = tick.model_force_n;
  s.loads = tick.loads;
  s.intubation = tick.intubation;
}

}  // namespace

ReplayFilm::ReplayFilm(std::shared_ptr<const curricula::TrialLog> log, const engine::SceneDescription& description,
                       std::size_t most_bytes)
    : log_(std::move(log)), replayer_(engine::build_scene(description)) {
  if (log_->ticks.empty()) throw std::runtime_error("the trial's log has no tick, so there is nothing to replay");
  plan_ = plan_film(log_->ticks.size(), log_->header.servo_period_s, bytes_of(replayer_.snapshot()), most_bytes);
  frames_.emplace(plan_.frames);
  worker_ = std::thread([this] {
    try {
      compute();
    } catch (const std::exception& error) {
      remark_ = std::string("the replay stopped: ") + error.what();
    }
    finished_.store(true, std::memory_order_release);
  });
}

ReplayFilm::~ReplayFilm() {
  stop_ = true;
  worker_.join();
}

void ReplayFilm::compute() {
  double sight = 0.0;
  for (std::size_t i = 0; i < log_->ticks.size(); ++i) {
    if (stop_) {
      remark_ = "stopped before its end";
      return;
    }
    const engine::TickRecord recorded = from_log(log_->ticks[i]);
    curricula::LogTick again = to_log(replayer_.replay(recorded));
    again.tick = log_->ticks[i].tick;  // the replayer takes count and clock as given
    again.time_s = log_->ticks[i].time_s;
    if (remark_.empty()) {
      const Difference difference = first_difference(log_->ticks[i], again);
      if (!difference.field.empty()) {
        char text[200];
        std::snprintf(text, sizeof text,
                      "from %.1f s on the tissue's shape may be a little different from what it was (%s is the first to "
                      "differ); figures are the recorded ones",
                      recorded.time_s, difference.field.c_str());
        remark_ = text;
      }
    }
    if (recorded.has_sight) sight = recorded.glottis_visible;
    if (i % static_cast<std::size_t>(plan_.every_ticks) != 0) continue;
    engine::Snapshot& frame = frames_->next();
    frame = replayer_.snapshot();
    take_recorded(recorded, sight, frame);
    frames_->publish();
  }
}

double ReplayFilm::time_s(std::size_t frame) const {
  return log_->ticks[std::min(frame, plan_.frames - 1) * static_cast<std::size_t>(plan_.every_ticks)].time_s;
}

std::size_t ReplayFilm::frame_at(double time_s) const {
  // Half a tick: a time that was written with a few decimals still means its own frame.
  const double ticks = (time_s - log_->ticks.front().time_s) / log_->header.servo_period_s + 0.5;
  if (!(ticks > 0.0)) return 0;
  return std::min(static_cast<std::size_t>(ticks / static_cast<double>(plan_.every_ticks)), plan_.frames - 1);
}

const engine::Snapshot* ReplayFilm::frame(std::size_t index) const {
  return frames_->at(index);
}

std::string ReplayFilm::remark() const { return finished() ? remark_ : std::string(); }

}  // namespace vallecula::gui
