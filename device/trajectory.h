// A trajectory in time: keyframes of the tool's pose, interpolated smoothly. Also the reader of the CSV form.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

#include "device/haptic_device.h"

namespace vallecula::device {

/// The tool at an instant: blade tip (m, world) and tool-to-world rotation (w first).
struct Keyframe {
  double time_s = 0.0;
  std::array<double, 3> position_m{0, 0, 0};
  std::array<double, 4> rotation_wxyz{1, 0, 0, 0};
};

/// Names what was given, what is wrong and how to mend it.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Position: monotone piecewise cubic (Fritsch and Butland 1984): through every keyframe, with continuous velocity,
/// never beyond the two neighbouring keyframes on any axis, at rest at both ends. Rotation: slerp by the shorter arc.
class Trajectory {
 public:
  /// Throws DeviceError unless there is a keyframe, all numbers are finite, times increase strictly and every rotation
  /// has a length within 1 % of one (it is normalised).
  explicit Trajectory(std::vector<Keyframe> keyframes);

  /// Before the first and after the last keyframe the pose rests there. A time that is NaN gives the first. Allocates
  /// nothing; several threads may ask at once.
  Keyframe at(double time_s) const noexcept;
  double start_s() const noexcept { return keyframes_.front().time_s; }
  double end_s() const noexcept { return keyframes_.back().time_s; }
  const std::vector<Keyframe>& keyframes() const noexcept { return keyframes_; }

 private:
  std::vector<Keyframe> keyframes_;
  std::vector<std::array<double, 3>> velocities_;  ///< m/s at each keyframe
};

/// Reads rows `t,x,y,z[,qw,qx,qy,qz]` in s and m; rotation is the identity where it is left out. A first line of column
/// names, blank lines and lines starting with # are skipped. Every row has the same number of columns. At most a
/// million rows. Throws DeviceError naming file and line.
std::vector<Keyframe> read_trajectory_csv(const std::filesystem::path& file);
/// The same from text that is named so in errors.
std::vector<Keyframe> read_trajectory_csv(std::istream& text, const std::string& name);

}  // namespace vallecula::device
