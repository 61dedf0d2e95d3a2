// The port the engine needs: pose in, force out. The application joins a device to it; the engine knows no device.
#pragma once

#include "engine/types.h"

namespace vallecula::engine {

struct PortInput {
  Pose pose;                   ///< device pose in patient axes, m
  std::uint32_t buttons = 0;
  bool valid = true;           ///< false: the device cannot be used now; the pose is its last known one
  Pose second_pose;            ///< of the second hand, likewise; of no concern to a scene without an intubation
  bool second_valid = true;
};

/// Called by the servo thread once a tick. Implementations neither block, allocate, log nor throw.
class HapticPort {
 public:
  virtual ~HapticPort() = default;
  /// `time_s`: nominal time of the tick.
  virtual PortInput read(double time_s) noexcept = 0;
  /// The tool as the scene holds it, once it does; between read and write.
  virtual void see_tool(const Pose& tool) noexcept { (void)tool; }
  /// Force in world axes, N. Called once after every read.
  virtual void write(const Vec3& force_n) noexcept = 0;
  /// Force on the second hand, N; after write() in a scene with an intubation.
  virtual void write_second(const Vec3& force_n) noexcept { (void)force_n; }
};

}  // namespace vallecula::engine
