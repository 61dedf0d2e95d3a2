// The engine's port onto a device: a pose in, a force out.
#pragma once

#include "device/guarded_device.h"
#include "engine/haptics/port.h"

namespace vallecula::gui {

/// The engine's port onto a guarded device. A pause of the device is an input that is not valid, so that all that
/// changes the engine's way is in the tick's record.
class DevicePort final : public engine::HapticPort {
 public:
  explicit DevicePort(device::GuardedDevice& device) : device_(device) {}

  engine::PortInput read(double time_s) noexcept override {
    const device::DeviceReading reading = device_.read(time_s);
    engine::PortInput input;
    input.pose.position = {reading.position_m[0], reading.position_m[1], reading.position_m[2]};
    const auto& q = reading.rotation_wxyz;
    input.pose.rotation = engine::Quat(q[0], q[1], q[2], q[3]);
    input.buttons = reading.buttons;
    input.valid = reading.valid;
    return input;
  }

  void see_tool(const engine::Pose& tool) noexcept override {
    const engine::Vec3& p = tool.position;
    const engine::Quat& q = tool.rotation;
    device_.see_tool({p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()});
  }

  void write(const engine::Vec3& force_n) noexcept override { device_.write({force_n.x(), force_n.y(), force_n.z()}); }

 private:
  device::GuardedDevice& device_;
};

}  // namespace vallecula::gui
