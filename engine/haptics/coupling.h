// The tool as the hand holds it: a virtual mass on a 6-DoF spring and damper to the device pose, stopped by springs
// that push.
#pragma once

#include <array>

#include "engine/types.h"

namespace vallecula::engine {

struct ProxySettings {
  double step_s = 0.001;
  double mass_kg = 0.08;          ///< virtual
  double inertia_kg_m2 = 7e-5;    ///< virtual, about the blade tip, the same about every axis
  double stiffness_n_m = 1200.0;  ///< of the coupling
  double rotation_nm_rad = 8.0;
  double force_limit_n = 7.9;  ///< of the device: bounds what the coupling can turn with
};

/// Force and torque about the blade tip, or velocity of the tip (m/s) and of rotation (rad/s); world axes.
struct Wrench {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
};

using Vec6 = Eigen::Matrix<double, 6, 1>;  ///< a move of the tool: of the tip, m, and about it, rad; world axes
using Mat6 = Eigen::Matrix<double, 6, 6>;  ///< stiffness over such a move

struct ProxyState {
  Pose pose;
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  Wrench pull;  ///< of the coupling's spring and damper at the end of the last step: what the hand feels, reversed
};

/// Where the hand is and how hard the coupling may pull.
struct HandState {
  Pose device;
  Wrench velocity;             ///< filtered
  double scale = 1.0;          ///< of the coupling's stiffness, in (0, 1]
  double force_limit_n = 1e3;  ///< the spring pulls with no more
};

/// What pushes on the tool: springs along a direction each, with no force once drawn out.
class PushingSprings {
 public:
  static constexpr int kMost = 257;  // rigid points, and the tissue as one

  PushingSprings() noexcept {}  // what is not counted is not set
  PushingSprings(const PushingSprings& other) noexcept { *this = other; }
  PushingSprings& operator=(const PushingSprings& other) noexcept;  ///< copies those there are

  void clear() noexcept { count = 0; }
  /// `direction`: a unit force and its torque. `deep`: how far it is pressed in, m; negative: still away. `comes`: how far
  /// what pushes moves along it in a tick, m. Returns false when full: it is left out.
  bool add(const Vec6& direction, double deep, double stiffness_n_m, double damping_n_s_m, double comes = 0.0) noexcept;
  /// The tool has moved.
  void follow(const Vec6& move) noexcept;
  Vec3 force() const noexcept;  ///< of all, dampers not counted

  int count = 0;
  std::array<Vec6, kMost> direction;
  std::array<double, kMost> depth, stiffness, damping, comes;
};

/// Rotation vector (axis times angle, rad) that turns `from` into `to`, world axes.
Vec3 rotation_between(const Quat& from, const Quat& to);

/// Finite, and a rotation.
bool usable(const Pose& pose) noexcept;

/// From one pose to the other.
Vec6 move_between(const Pose& from, const Pose& to);

inline Vec3 no_longer_than(const Vec3& v, double most) { return v.norm() > most ? Vec3(v * (most / v.norm())) : v; }

/// The hand goes on to `device`; its velocity is the filtered difference quotient.
void follow_device(const Pose& device, double step_s, HandState& hand) noexcept;

/// Force of the virtual coupling's spring on the proxy: stiffness times the way to the device pose; `scale` in (0, 1].
Wrench coupling_wrench(const ProxySettings& settings, const Pose& proxy, const Pose& device, double scale);

/// One implicit step of the proxy: (M/h^2 + B/h + K) dx = M v/h + coupling + load + springs, where K holds the
/// coupling's stiffness, the springs' and `stiffness`, which is what `load` would change by. The damper works against
/// the hand, so that moving freely costs no force. Returns the move.
Vec6 move_coupled(const ProxySettings& settings, const HandState& hand, const Wrench& load, const Mat6& stiffness,
                  const PushingSprings& springs, ProxyState& proxy) noexcept;

}  // namespace vallecula::engine
