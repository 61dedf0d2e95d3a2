// One servo tick as a pure function of the newest step's result and the device: what the runner does live and the
// replayer does again.
#pragma once

#include "engine/haptics/port.h"
#include "engine/state.h"

namespace vallecula::engine {

struct ServoState {
  Vec3 displayed = Vec3::Zero();
  std::int64_t last_used = -1;
};

/// Force for the device and the tick's record. `used` is the newest finished step (step -1: none yet). The force is the
/// coupling's between the device's present pose and the proxy of `used`: when a step is late, the proxy stands and the
/// coupling's spring predicts the force from the hand's motion.
TickRecord servo_tick(const Scene& scene, std::int64_t tick, const PortInput& input, std::int64_t step_fed,
                      const StepResult& used, bool overrun, ServoState& servo) noexcept;

}  // namespace vallecula::engine
