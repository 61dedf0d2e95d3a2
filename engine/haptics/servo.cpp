#include "engine/haptics/servo.h"

namespace vallecula::engine {

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
  const Vec3 pull = used.limit.coupling_scale * scene.proxy.stiffness_n_m * (input.pose.position - used.proxy_pose.position);
  bool fault = !input.valid || used.step < 0 ||
               (used.faults & (kFaultTissue | kFaultDevicePose | kFaultDeviceInvalid)) != 0;
  // A pose that is not finite is the device's fault and named as such; with a finite one, a pull that is not is ours.
  if (!fault && input.pose.position.allFinite() && !(pull.allFinite() && used.model_force_n.allFinite())) {
    fault = true;
    record.faults |= kFaultForce;
  }
  servo.displayed = displayed_force(scene.description.haptics, scene.model.step_s, used.limit, pull, !fault, servo.displayed);
  record.displayed_force_n = servo.displayed;
  servo.last_used = used.step;
  return record;
}

}  // namespace vallecula::engine
