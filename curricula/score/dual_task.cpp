#include "curricula/score/dual_task.h"

#include <algorithm>

namespace vallecula::curricula {
namespace {

/// Working ticks of the trial before each tick, and at the end those of all.
std::vector<long long> worked_before(const TrialLog& log) {
  std::vector<long long> worked(1, 0);
  for (const LogTick& tick : log.ticks) worked.push_back(worked.back() + (paused(tick) ? 0 : 1));
  return worked;
}

bool fits(const LogEvent& event, const Distraction& asked) {
  if (asked.kind == Distraction::Kind::alarm) return event.kind == LogEvent::Kind::silenced;
  return event.kind == LogEvent::Kind::answered && event.answer >= 1 &&
         event.answer <= static_cast<int>(asked.answers.size());
}

}  // namespace

std::optional<DualTask> measure_dual_task(const TrialLog& log, const Scenario& scenario) {
  if (!log.header.has_events || scenario.distractions.empty()) return std::nullopt;
  const double period_s = log.header.servo_period_s;
  const std::vector<long long> worked = worked_before(log);
  struct Shown {
    std::size_t tick;
    bool over = false;  ///< answered, in time or not
  };
  std::vector<Shown> shown;  // as task.reactions
  DualTask task;
  double sum_s = 0.0;
  for (const LogEvent& event : log.events) {
    const bool in_log = event.tick >= 0 && event.tick < static_cast<std::int64_t>(log.ticks.size());
    const bool known = event.distraction >= 1 && event.distraction <= static_cast<int>(scenario.distractions.size());
    const auto found = std::find_if(task.reactions.begin(), task.reactions.end(),
                                    [&](const Reaction& one) { return one.distraction == event.distraction; });
    if (event.kind == LogEvent::Kind::shown) {
      if (!in_log || !known || found != task.reactions.end()) continue;
      const Distraction& asked = scenario.distractions[static_cast<std::size_t>(event.distraction - 1)];
      if (asked.kind == Distraction::Kind::talk) continue;
      const auto tick = static_cast<std::size_t>(event.tick);
      task.reactions.push_back({event.distraction, log.ticks[tick].time_s, Reaction::Result::open, {}});
      shown.push_back({tick, false});
      continue;
    }
    if (!in_log || !known || found == task.reactions.end()) {
      ++task.false_answers;
      continue;
    }
    const Distraction& asked = scenario.distractions[static_cast<std::size_t>(event.distraction - 1)];
    Shown& from = shown[static_cast<std::size_t>(found - task.reactions.begin())];
    if (from.over || !fits(event, asked)) {
      ++task.false_answers;
      continue;
    }
    from.over = true;
    const double took_s =
        static_cast<double>(worked[static_cast<std::size_t>(event.tick)] - worked[from.tick]) * period_s;
    if (took_s > asked.time_allowed_s + 0.5 * period_s) continue;  // it stays open, and its time is over: missed
    found->reaction_s = took_s;
    found->result = asked.kind == Distraction::Kind::alarm || event.answer == asked.right_answer
                        ? Reaction::Result::right
                        : Reaction::Result::wrong;
    sum_s += took_s;
  }
  for (std::size_t i = 0; i < task.reactions.size(); ++i) {
    Reaction& one = task.reactions[i];
    const double allowed_s = scenario.distractions[static_cast<std::size_t>(one.distraction - 1)].time_allowed_s;
    const double until_end_s = static_cast<double>(worked.back() - worked[shown[i].tick]) * period_s;
    if (one.result == Reaction::Result::open && until_end_s > allowed_s) one.result = Reaction::Result::missed;
    task.right += one.result == Reaction::Result::right;
    task.wrong += one.result == Reaction::Result::wrong;
    task.missed += one.result == Reaction::Result::missed;
  }
  if (task.right + task.wrong > 0) task.mean_reaction_s = sum_s / (task.right + task.wrong);
  return task;
}

}  // namespace vallecula::curricula
