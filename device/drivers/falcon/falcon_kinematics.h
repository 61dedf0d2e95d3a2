// Where the Falcon's grip stands for its three leg angles, and which leg torques push it how.
//
// Three legs stand around the z axis; each is an arm of length a turning by its motor in the leg's plane (angle theta
// from the leg's u axis), and a parallelogram of length b that keeps the grip upright (R. E. Stamper, A Three Degree of
// Freedom Parallel Manipulator with Only Translational Degrees of Freedom, 1997). The grip therefore only shifts.
//
// Axes: +x right, +y up, +z towards the person, m; the origin is the middle of the workspace, kMiddleZ in front of the
// plane of the motors.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "device/rotation.h"

namespace vallecula::device::falcon {

using Angles = std::array<double, 3>;  ///< rad: top, right, left leg
using Matrix = std::array<Vector, 3>;  ///< rows

/// The middle of what the legs reach, from the plane of the motors, m.
constexpr double kMiddleZ = 0.125;
/// Width, height and depth within which it is meant to be used (4 inches), m.
constexpr double kWorkspace = 0.1016;
/// The most force, N: what its maker names for short. Nothing is known of what it bears for long.
constexpr double kPeakForce = 8.0;

/// A leg's angle for its encoder's count.
double leg_angle(std::int16_t encoder) noexcept;

/// The inverse: leg angles with the grip at `position`; nothing where a leg does not reach.
std::optional<Angles> leg_angles(const Vector& position) noexcept;

/// Rows: how each leg's angle changes with the grip's position, rad/m. Nothing where a leg does not reach, or where it
/// is stretched so that its angle does not say where the grip is.
std::optional<Matrix> angles_by_position(const Vector& position) noexcept;

/// The grip's position for leg angles, by Newton's method from `guess` (the position before); nothing when no position
/// near it has these angles.
std::optional<Vector> position_of(const Angles& angles, const Vector& guess = {0, 0, 0}) noexcept;

/// Leg torques (N m, in the sense of growing angle) with which the grip, at `position`, pushes the hand by `force_n`:
/// the transposed Jacobian d position / d angles times force. Nothing where the Jacobian does not exist.
std::optional<Vector> leg_torques(const Vector& position, const Vector& force_n) noexcept;

/// Motor commands for leg torques. All three are made smaller by the same share when one exceeds kMostMotor, so that
/// the force keeps its direction; torques that are not finite give zero.
std::array<std::int16_t, 3> motor_commands(const Vector& torques) noexcept;

/// The largest command in use.
constexpr std::int16_t kMostMotor = 4095;
/// Leg torque per unit of command, N m. Measured as 1.9835e-5 N m at the motor's shaft (S. Martin and N. Hillier,
/// Characterisation of the Novint Falcon Haptic Device for Application as a Robot Manipulator, 2009), times the drum's
/// ratio. Another public driver takes 1e-4 (check): were that right, forces would be two thirds of what is asked.
constexpr double kDrumRatio = 0.110 / 0.01425;  ///< arm's drum over the motor's shaft; another source has 7.62
constexpr double kTorquePerUnit = 1.9835e-5 * kDrumRatio;

}  // namespace vallecula::device::falcon
