// How far a predicted force is from the one the full step gives: measured on a recorded hand, by withholding steps.
#pragma once

#include <deque>

#include "engine/haptics/servo.h"

namespace vallecula::engine {

/// How many steps are withheld, each measured on its own.
constexpr std::array<int, 5> kWithheldSteps = {1, 2, 3, 5, 10};

/// Magnitudes of force errors, N.
struct ForceError {
  double rms_n = 0.0, p99_n = 0.0, max_n = 0.0;
  std::int64_t ticks = 0;  ///< looked at: those with a force, true or predicted, of 0.01 N and more
};

/// Collects the errors of one kind of prediction.
class ForceErrors {
 public:
  void add(const Vec3& predicted, const Vec3& truth);
  ForceError summary() const;

 private:
  std::vector<float> errors_;
};

/// Steps a scene along a recorded hand, a step each tick and done within it; beside that every tick's displayed force
/// is predicted by servo_tick() from the step of 1, 2, 3, 5 and 10 ticks before, the limits of the device included.
class PredictionMeasurement {
 public:
  explicit PredictionMeasurement(std::shared_ptr<const Scene> scene);
  void add(const PortInput& input);
  ForceError error(Prediction prediction, int withheld) const;       ///< withheld: one of kWithheldSteps
  double peak_force_n() const { return peak_; }                      ///< of the full steps' displayed force
  const PassivityObserver& energy() const { return servo_.energy; }  ///< as if no step had been late

 private:
  struct Moment {
    PortInput input;
    StepResult result;
    ServoState servo;
  };
  std::shared_ptr<const Scene> scene_;
  SceneState state_;
  ServoState servo_;
  std::deque<Moment> past_;  ///< newest last
  std::int64_t tick_ = 0;
  double peak_ = 0.0;
  std::array<std::array<ForceErrors, kWithheldSteps.size()>, 3> errors_;
};

}  // namespace vallecula::engine
