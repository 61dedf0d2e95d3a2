#include "engine/haptics/prediction_error.h"

#include <algorithm>
#include <cmath>

namespace vallecula::engine {

namespace {

constexpr double kForce = 0.01;  // N; ticks without a force would hide the others' errors

}  // namespace

void ForceErrors::add(const Vec3& predicted, const Vec3& truth) {
  if (predicted.norm() >= kForce || truth.norm() >= kForce)
    errors_.push_back(static_cast<float>((predicted - truth).norm()));
}

ForceError ForceErrors::summary() const {
  ForceError error;
  error.ticks = static_cast<std::int64_t>(errors_.size());
  if (errors_.empty()) return error;
  std::vector<float> sorted = errors_;
  std::sort(sorted.begin(), sorted.end());
  double squares = 0.0;
  for (const float e : sorted) squares += double(e) * e;
  error.rms_n = std::sqrt(squares / static_cast<double>(sorted.size()));
  error.p99_n = sorted[static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(sorted.size()))) - 1];
  error.max_n = sorted.back();
  return error;
}

PredictionMeasurement::PredictionMeasurement(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), state_(*scene_) {}

void PredictionMeasurement::add(const PortInput& input) {
  const std::int64_t tick = tick_++;
  Moment now;
  now.input = input;
  now.result = step(*scene_, state_, step_input(input));
  const Vec3 truth = servo_tick(*scene_, tick, input, now.result.step, now.result, false, servo_).displayed_force_n;
  now.servo = servo_;
  peak_ = std::max(peak_, truth.norm());
  past_.push_back(now);
  if (past_.size() > static_cast<std::size_t>(kWithheldSteps.back()) + 1) past_.pop_front();

  for (std::size_t n = 0; n < kWithheldSteps.size(); ++n) {
    const auto withheld = static_cast<std::size_t>(kWithheldSteps[n]);
    if (past_.size() <= withheld) continue;
    const std::size_t from = past_.size() - 1 - withheld;
    for (std::size_t kind = 0; kind < errors_.size(); ++kind) {
      ServoState servo = past_[from].servo;
      servo.prediction = static_cast<Prediction>(kind);
      for (std::size_t i = from + 1; i < past_.size(); ++i)
        servo_tick(*scene_, tick - static_cast<std::int64_t>(past_.size() - 1 - i), past_[i].input, -1,
                   past_[from].result, true, servo);
      errors_[kind][n].add(servo.displayed, truth);
    }
  }
}

ForceError PredictionMeasurement::error(Prediction prediction, int withheld) const {
  const auto n = std::find(kWithheldSteps.begin(), kWithheldSteps.end(), withheld) - kWithheldSteps.begin();
  return errors_[static_cast<std::size_t>(prediction)].at(static_cast<std::size_t>(n)).summary();
}

}  // namespace vallecula::engine
