// The engine's port onto a device: a pose in, a force out.
#pragma once

#include "device/haptic_device.h"
#include "device/output_chain.h"
#include "engine/haptics/port.h"

namespace vallecula::gui {

/// The engine's port onto a device; every force goes through the device's output chain.
class DevicePort final : public engine::HapticPort {
 public:
  DevicePort(device::HapticDevice& device, const device::OutputLimits& limits) : device_(device), chain_(limits) {}

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

  void write(const engine::Vec3& force_n) noexcept override {
    chain_.send(device_, {force_n.x(), force_n.y(), force_n.z()});
  }

  /// Not under the chain's rate limit: nobody drives the device any more.
  void let_go() noexcept {
    chain_.reset();
    device_.write({0.0, 0.0, 0.0});
  }

 private:
  device::HapticDevice& device_;
  device::OutputChain chain_;
};

}  // namespace vallecula::gui
