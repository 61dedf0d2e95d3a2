#include <array>

#include "engine/haptics/runner.h"
#include "engine/haptics/servo.h"
#include "engine/haptics/snapshots.h"

namespace vallecula::engine {

struct Replayer::Impl {
  explicit Impl(std::shared_ptr<const Scene> s) : scene(std::move(s)), state(*scene) {
    size_snapshot(*scene, snapshot);
  }
  std::shared_ptr<const Scene> scene;
  SceneState state;
  ServoState servo;
  std::array<StepResult, kResultSlots> results;
  Snapshot snapshot;
};

Replayer::Replayer(std::shared_ptr<const Scene> scene) : impl_(std::make_unique<Impl>(std::move(scene))) {}

Replayer::~Replayer() = default;

TickRecord Replayer::replay(const TickRecord& recorded) {
  Impl& m = *impl_;
  PortInput in;
  in.pose = recorded.device_pose;
  in.buttons = recorded.buttons;
  in.valid = recorded.device_valid;
  in.second_pose = recorded.intubation.hand_pose;
  in.second_valid = recorded.intubation.hand_valid;
  if (recorded.step_fed >= 0) {
    const StepResult result = step(*m.scene, m.state, step_input(in));
    m.results[result.step % kResultSlots] = result;
  }
  const StepResult none;
  const StepResult& slot = recorded.step_used >= 0 ? m.results[recorded.step_used % kResultSlots] : none;
  return servo_tick(*m.scene, recorded.tick, in, recorded.step_fed >= 0 ? m.state.step - 1 : -1, slot,
                    (recorded.faults & kFaultOverrun) != 0, m.servo);
}

const Snapshot& Replayer::snapshot() {
  Impl& m = *impl_;
  if (m.state.step > 0) fill_snapshot(*m.scene, m.state, m.results[(m.state.step - 1) % kResultSlots], m.snapshot);
  return m.snapshot;
}

const PassivityObserver& Replayer::energy() const { return impl_->servo.energy; }

}  // namespace vallecula::engine
