#include "gui/session/dual_task.h"

#include <algorithm>

namespace vallecula::gui {

using curricula::Distraction;
using curricula::LogEvent;

double DualTask::open_for_s(int distraction) const {
  const Distraction& it = at(distraction);
  return it.kind == Distraction::Kind::talk ? kTalkShownS : it.time_allowed_s;
}

void DualTask::begin(bool scripted) {
  const std::lock_guard<std::mutex> lock(mutex_);
  states_.assign(distractions_.size(), State::to_come);
  shown_s_.assign(distractions_.size(), 0.0);
  asked_for_.clear();
  last_shown_ = 0;
  now_s_ = 0.0;
  scripted_ = scripted;
}

std::vector<DualTask::Open> DualTask::open() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Open> open;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i] != State::open) continue;
    const int number = static_cast<int>(i) + 1;
    const double of_s = open_for_s(number);
    open.push_back({number, std::clamp(shown_s_[i] + of_s - now_s_, 0.0, of_s), of_s});
  }
  return open;
}

void DualTask::ask(const LogEvent& event) {
  if (event.distraction < 1 || event.distraction > static_cast<int>(distractions_.size())) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  State& state = states_[static_cast<std::size_t>(event.distraction - 1)];
  if (state != State::open) return;
  state = State::over;  // one answer counts, the first
  asked_for_.push_back(event);
}

void DualTask::ask_of_nothing(LogEvent event) {
  const std::lock_guard<std::mutex> lock(mutex_);
  event.distraction = last_shown_;
  if (last_shown_ != 0) asked_for_.push_back(event);
}

void DualTask::answer(int distraction, int answer) {
  if (distraction == 0) return ask_of_nothing({0, LogEvent::Kind::answered, 0, answer});
  if (distraction < 1 || distraction > static_cast<int>(distractions_.size())) return;
  if (at(distraction).kind != Distraction::Kind::question) return;
  if (answer < 1 || answer > static_cast<int>(at(distraction).answers.size())) return;
  ask({0, LogEvent::Kind::answered, distraction, answer});
}

void DualTask::silence(int distraction) {
  if (distraction == 0) return ask_of_nothing({0, LogEvent::Kind::silenced, 0, 0});
  if (distraction < 1 || distraction > static_cast<int>(distractions_.size())) return;
  if (at(distraction).kind != Distraction::Kind::alarm) return;
  ask({0, LogEvent::Kind::silenced, distraction, 0});
}

std::vector<LogEvent> DualTask::advance(std::int64_t tick, double trial_s) {
  if (distractions_.empty()) return {};
  const std::lock_guard<std::mutex> lock(mutex_);
  now_s_ = trial_s;
  std::vector<LogEvent> events = std::move(asked_for_);
  asked_for_.clear();
  for (LogEvent& event : events) event.tick = tick;
  const ScriptedAnswers script;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    const Distraction& it = distractions_[i];
    if (states_[i] == State::to_come && trial_s >= it.at_s) {
      states_[i] = State::open;
      shown_s_[i] = trial_s;
      last_shown_ = number;
      events.push_back({tick, LogEvent::Kind::shown, number, 0});
    }
    if (states_[i] != State::open) continue;
    const double for_s = trial_s - shown_s_[i];
    if (for_s >= open_for_s(number)) {
      states_[i] = State::over;
    } else if (scripted_ && it.kind == Distraction::Kind::question &&
               for_s >= std::min(script.question_s, 0.5 * it.time_allowed_s)) {
      states_[i] = State::over;
      events.push_back({tick, LogEvent::Kind::answered, number, it.right_answer});
    } else if (scripted_ && it.kind == Distraction::Kind::alarm &&
               for_s >= std::min(script.alarm_s, 0.5 * it.time_allowed_s)) {
      states_[i] = State::over;
      events.push_back({tick, LogEvent::Kind::silenced, number, 0});
    }
  }
  return events;
}

}  // namespace vallecula::gui
