// One servo tick as a pure function of the newest step's result and the device: what the runner does live and the
// replayer does again.
#pragma once

#include "engine/haptics/passivity.h"
#include "engine/haptics/port.h"
#include "engine/state.h"

namespace vallecula::engine {

/// A late step is predicted over at most this many ticks; beyond, the last of them are taken.
constexpr int kMostPredictedTicks = 10;

struct ServoState {
  Prediction prediction = Prediction::contact;
  Vec3 displayed = Vec3::Zero();
  std::int64_t last_used = -1;
  PassivityObserver energy;
  Pose device;                                    ///< of the last tick with a usable one
  bool placed = false;                            ///< there has been one
  Vec3 turn_nm = Vec3::Zero();                    ///< coupling's torque on the tool in the last tick
  std::array<Pose, kMostPredictedTicks> devices;  ///< of the last ticks, by tick
  /// Tick that fed a step, by step: one is worked on, one is done, one came before it.
  std::array<std::int64_t, 4> fed_at{-1, -1, -1, -1};
  Vec3 second_displayed = Vec3::Zero();           ///< force on the second hand
};

/// What the hands do, as a step takes it.
StepInput step_input(const PortInput& input) noexcept;

/// Force for the device and the tick's record. `used` is the newest finished step (step -1: none yet). The force is the
/// coupling's, spring and damper, brought on from `used` to the device's present pose over the ticks since that step
/// was fed. In a scene with an intubation a hand that is lost takes the other's force as well, from that tick on: the trial
/// stands still. The second hand's, where the scene has one, is the tube's as the newest step left it: over late steps it is
/// held (a simplification).
TickRecord servo_tick(const Scene& scene, std::int64_t tick, const PortInput& input, std::int64_t step_fed,
                      const StepResult& used, bool overrun, ServoState& servo) noexcept;

}  // namespace vallecula::engine
