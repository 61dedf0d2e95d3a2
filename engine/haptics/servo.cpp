#include "engine/haptics/servo.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

/// Hand and step apart by more than this are no prediction's business, m.
constexpr double kFarthestHand = 2.0;

/// The coupling as the step left it, brought on to this tick.
CouplingState predicted(const Scene& scene, std::int64_t tick, const StepResult& used, const ServoState& servo) {
  CouplingState coupling = used.coupling;
  const auto fed_at = [&servo](std::int64_t step) { return servo.fed_at[static_cast<std::size_t>(step % 4)]; };
  const std::int64_t late = tick - fed_at(used.step);
  if (late > 0 && used.step > 0) {
    // A scene whose steps take several ticks each goes slow; by the hand's clock its speeds are that much less.
    const double slow =
        std::clamp(static_cast<double>(fed_at(used.step) - fed_at(used.step - 1)), 1.0, 1.0 * kMostPredictedTicks);
    for (Vec3* v : {&coupling.hand.velocity.force, &coupling.hand.velocity.torque, &coupling.proxy.velocity,
                    &coupling.proxy.angular_velocity})
      *v /= slow;
  }
  const Vec3 from = coupling.hand.device.position;
  for (std::int64_t t = tick - std::min<std::int64_t>(late, kMostPredictedTicks) + 1; t <= tick; ++t) {
    Pose device = servo.devices[static_cast<std::size_t>(t % kMostPredictedTicks)];
    device.position = from + no_longer_than(device.position - from, kFarthestHand);
    advance(scene.proxy, servo.prediction, device, coupling);
  }
  return coupling;
}

void observe_energy(const PortInput& input, ServoState& servo) {
  if (servo.placed)
    servo.energy.add(servo.displayed, input.pose.position - servo.device.position, -servo.turn_nm,
                     rotation_between(servo.device.rotation, input.pose.rotation));
  servo.placed = true;
  servo.device = input.pose;
}

/// The second hand's part of the record, and its force.
void second_hand(const Scene& scene, const PortInput& input, const StepResult& used, ServoState& servo,
                 TickRecord& record) {
  record.has_intubation = true;
  IntubationRecord& r = record.intubation;
  r = used.step >= 0 ? used.intubation : scene.intubation->at_start;
  r.hand_pose = input.second_pose;
  r.hand_valid = input.second_valid;
  if (!input.second_valid) r.faults |= kIntubationFaultHand;
  if (!usable(input.second_pose)) r.faults |= kIntubationFaultHandPose;
  // What stops the blade's hand stops this one: the trial stands still, or the scene is not what it was.
  bool fault = used.step < 0 || !input.valid ||
               (record.faults & (kFaultTissue | kFaultDevicePose | kFaultDeviceInvalid)) != 0 ||
               (r.faults & (kIntubationFaultHand | kIntubationFaultHandPose | kIntubationFaultTube)) != 0;
  if (!fault && !r.model_force_n.allFinite()) {
    fault = true;
    r.faults |= kIntubationFaultForce;
  }
  const HapticSettings& haptics = scene.description.haptics;
  servo.second_displayed =
      fault ? Vec3::Zero()
            : rate_bound(haptics, scene.model.step_s,
                         no_longer_than(r.model_force_n, scene.description.intubation->device_limit_n),
                         servo.second_displayed);
  r.displayed_force_n = servo.second_displayed;
}

}  // namespace

StepInput step_input(const PortInput& input) noexcept {
  StepInput fed;
  fed.device = input.pose;
  fed.valid = input.valid;
  fed.second = input.second_pose;
  fed.second_valid = input.second_valid;
  fed.actions = input.buttons & kAllActions;
  return fed;
}

TickRecord servo_tick(const Scene& scene, std::int64_t tick, const PortInput& input, std::int64_t step_fed,
                      const StepResult& used, bool overrun, ServoState& servo) noexcept {
  TickRecord record;
  record.tick = tick;
  record.time_s = static_cast<double>(tick) * scene.model.step_s;
  record.device_pose = input.pose;
  record.buttons = input.buttons;
  record.device_valid = input.valid;
  record.step_fed = step_fed;
  record.step_used = used.step;
  record.faults = used.faults | (overrun ? kFaultOverrun : kFaultNone);
  if (used.step >= 0) {
    record.proxy_pose = used.proxy_pose;
    record.state = used.limit.state;
    record.model_force_n = used.model_force_n;
    record.model_torque_nm = used.model_torque_nm;
    record.loads = used.loads;
    record.glottis_visible = used.glottis_visible;
    record.has_sight = used.step != servo.last_used && used.step % kSightEverySteps == 0;
  }
  const bool good = usable(input.pose);
  if (good) observe_energy(input, servo);
  servo.devices[static_cast<std::size_t>(tick % kMostPredictedTicks)] = servo.device;
  if (step_fed >= 0) servo.fed_at[static_cast<std::size_t>(step_fed % 4)] = tick;
  const CouplingState coupling = used.step >= 0 ? predicted(scene, tick, used, servo) : CouplingState{};
  if (!good) record.faults |= kFaultDevicePose;
  const bool hands = input.valid && (!scene.intubation || input.second_valid);
  bool fault =
      !hands || used.step < 0 || (record.faults & (kFaultTissue | kFaultDevicePose | kFaultDeviceInvalid)) != 0;
  // A pose that is none is the device's fault and named as such; with a good one, a pull that is not is ours.
  if (!fault && !(coupling.proxy.pull.force.allFinite() && used.model_force_n.allFinite())) {
    fault = true;
    record.faults |= kFaultForce;
  }
  servo.displayed = displayed_force(scene.description.haptics, scene.model.step_s, used.limit,
                                    coupling.proxy.pull.force, !fault, servo.displayed);
  record.displayed_force_n = servo.displayed;
  servo.turn_nm = fault || used.limit.state == HapticState::lost ? Vec3::Zero() : coupling.proxy.pull.torque;
  if (scene.intubation) second_hand(scene, input, used, servo, record);
  servo.last_used = used.step;
  return record;
}

}  // namespace vallecula::engine
