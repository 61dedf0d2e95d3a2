#include "device/drivers/falcon/falcon_kinematics.h"

#include <algorithm>

namespace vallecula::device::falcon {
namespace {

// Lengths, m, named as in Stamper's figures.
constexpr double kA = 0.060, kB = 0.1025, kC = 0.01443, kD = 0.01125, kE = kD, kF = -0.025, kR = 0.040, kS = -0.02309;
// The encoder's wheel: 320 slots a turn, four counts a slot.
constexpr double kCountsPerTurn = 4.0 * 320.0;
/// A leg's angle where its encoder counts zero. 35, 40 and 50 degrees are reported (check); an error of 5 degrees
/// shifts the whole workspace by a centimetre in z, and bends it little.
constexpr double kAngleAtZero = 35.0 * M_PI / 180.0;
/// A positive command drives a leg to smaller angles (two public drivers agree).
constexpr double kMotorSense = -1.0;

constexpr int kMostSteps = 30;
constexpr double kLongestStep = 0.05;  ///< m; keeps a bad beginning from running away
constexpr double kConverged = 1e-12;   ///< m; the step after it would be rounding
constexpr double kSameAngles = 1e-9;   ///< rad

struct LegFrame {
  double cosine, sine;
};
const std::array<LegFrame, 3>& leg_frames() noexcept {
  // 90, -30 and -150 degrees, the whole turned by 15.
  static const std::array<LegFrame, 3> kFrames = [] {
    std::array<LegFrame, 3> frames{};
    for (int leg = 0; leg < 3; ++leg) {
      const double turn = (90.0 - 120.0 * leg + 15.0) * M_PI / 180.0;
      frames[leg] = {std::cos(turn), std::sin(turn)};
    }
    return frames;
  }();
  return kFrames;
}

/// One leg closed on the grip. With U = u + c: (U - a cos theta)^2 + (w - a sin theta)^2 = reach^2.
struct Leg {
  double u_c = 0.0, w = 0.0, theta = 0.0;
  double reach = 0.0;          ///< the parallelogram with both its links, in the leg's plane
  double reach_by_side = 0.0;  ///< d reach / d v
};

/// All but the angle; nothing where the parallelogram does not reach to the side.
std::optional<Leg> placed(const LegFrame& frame, const Vector& position) noexcept {
  const double side = -frame.sine * position[0] + frame.cosine * position[1] - kS + kF;
  const double squared = kB * kB - side * side;
  if (!(squared > 0.0)) return std::nullopt;
  Leg leg;
  leg.u_c = frame.cosine * position[0] + frame.sine * position[1] - kR + kC;
  leg.w = position[2] + kMiddleZ;
  leg.reach = kD + kE + std::sqrt(squared);
  leg.reach_by_side = -side / std::sqrt(squared);
  return leg;
}

std::optional<Leg> closed(const LegFrame& frame, const Vector& position) noexcept {
  auto leg = placed(frame, position);
  if (!leg) return std::nullopt;
  const double distance = std::hypot(leg->u_c, leg->w);
  const double cosine = (distance * distance + kA * kA - leg->reach * leg->reach) / (2.0 * kA * distance);
  if (!(std::abs(cosine) <= 1.0)) return std::nullopt;
  leg->theta = std::atan2(leg->w, leg->u_c) - std::acos(cosine);  // the knee stands outwards
  return leg;
}

/// A direction given in a leg's u, v, w axes.
Vector in_space(const LegFrame& frame, double u, double v, double w) noexcept {
  return {frame.cosine * u - frame.sine * v, frame.sine * u + frame.cosine * v, w};
}

double dot3(const Vector& a, const Vector& b) noexcept { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Columns of the inverse of a matrix given by rows; nothing when it is singular to working precision.
std::optional<Matrix> inverse_columns(const Matrix& rows) noexcept {
  const Vector c0 = cross(rows[1], rows[2]);
  const double determinant = dot3(rows[0], c0);
  if (!(std::abs(determinant) > 1e-6 * length(rows[0]) * length(rows[1]) * length(rows[2]))) return std::nullopt;
  return Matrix{scale(c0, 1.0 / determinant), scale(cross(rows[2], rows[0]), 1.0 / determinant),
                scale(cross(rows[0], rows[1]), 1.0 / determinant)};
}

}  // namespace

double leg_angle(std::int16_t encoder) noexcept {
  return kAngleAtZero + 2.0 * M_PI * encoder / (kCountsPerTurn * kDrumRatio);
}

std::optional<Angles> leg_angles(const Vector& position) noexcept {
  Angles angles{};
  for (int i = 0; i < 3; ++i) {
    const auto leg = closed(leg_frames()[i], position);
    if (!leg) return std::nullopt;
    angles[i] = leg->theta;
  }
  return angles;
}

std::optional<Matrix> angles_by_position(const Vector& position) noexcept {
  Matrix rows{};
  for (int i = 0; i < 3; ++i) {
    const LegFrame& frame = leg_frames()[i];
    const auto leg = closed(frame, position);
    if (!leg) return std::nullopt;
    // Half the derivatives of the closing condition.
    const double cosine = std::cos(leg->theta), sine = std::sin(leg->theta);
    const double by_theta = kA * (leg->u_c * sine - leg->w * cosine);
    if (!(std::abs(by_theta) > 1e-6 * kA * leg->reach)) return std::nullopt;
    const double by_u = leg->u_c - kA * cosine, by_w = leg->w - kA * sine, by_v = -leg->reach * leg->reach_by_side;
    rows[i] = scale(in_space(frame, by_u, by_v, by_w), -1.0 / by_theta);
  }
  return rows;
}

std::optional<Vector> position_of(const Angles& angles, const Vector& guess) noexcept {
  // Newton on the closing conditions themselves: they are nearly quadratic and, unlike the angles, exist beyond what
  // the legs reach, so that the way there may lead through it.
  Vector position = guess;
  for (int step = 0; step < kMostSteps; ++step) {
    Matrix rows{};
    Vector open{};
    for (int i = 0; i < 3; ++i) {
      const LegFrame& frame = leg_frames()[i];
      const auto leg = placed(frame, position);
      if (!leg) return std::nullopt;
      const double u = leg->u_c - kA * std::cos(angles[i]), w = leg->w - kA * std::sin(angles[i]);
      open[i] = 0.5 * (u * u + w * w - leg->reach * leg->reach);
      rows[i] = in_space(frame, u, -leg->reach * leg->reach_by_side, w);
    }
    const auto columns = inverse_columns(rows);
    if (!columns) return std::nullopt;
    Vector way{0, 0, 0};
    for (int i = 0; i < 3; ++i) way = subtract(way, scale((*columns)[i], open[i]));
    const double distance = length(way);
    if (!std::isfinite(distance)) return std::nullopt;
    position = add(position, distance > kLongestStep ? scale(way, kLongestStep / distance) : way);
    if (distance < kConverged) break;
  }
  // The conditions have a second answer, with knees turned inwards; and the steps may have run out.
  const auto again = leg_angles(position);
  if (!again || !(length(subtract(*again, angles)) < kSameAngles)) return std::nullopt;
  return position;
}

std::optional<Vector> leg_torques(const Vector& position, const Vector& force_n) noexcept {
  const auto rows = angles_by_position(position);
  if (!rows) return std::nullopt;
  const auto columns = inverse_columns(*rows);
  if (!columns) return std::nullopt;
  return Vector{dot3((*columns)[0], force_n), dot3((*columns)[1], force_n), dot3((*columns)[2], force_n)};
}

std::array<std::int16_t, 3> motor_commands(const Vector& torques) noexcept {
  if (!finite(torques)) return {0, 0, 0};
  const double largest = std::max({std::abs(torques[0]), std::abs(torques[1]), std::abs(torques[2])}) / kTorquePerUnit;
  const double units = kMotorSense / kTorquePerUnit * (largest > kMostMotor ? kMostMotor / largest : 1.0);
  std::array<std::int16_t, 3> commands{};
  for (int i = 0; i < 3; ++i) commands[i] = static_cast<std::int16_t>(std::lround(torques[i] * units));
  return commands;
}

}  // namespace vallecula::device::falcon
