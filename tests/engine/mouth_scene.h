// A small mouth for tests of the whole step: a block for a tongue, partly borne by a jaw on a hinge with its gum, a lip
// that goes along with it, and a sight that it takes along too. Nothing that a trial's scene has is missing but size.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/haptics/servo.h"
#include "engine/state.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine::testing {

/// Tops of what can be pressed, m.
const Vec3 kTongueTop(0.015, 0.015, 0.015), kGumTop(0.015, -0.008, 0.014), kLipTop(0.015, -0.032, 0.016);
constexpr int kMouthJaw = 1;  // among the bodies

inline LipDescription mouth_lip() {
  LipDescription lip;
  constexpr int kSide = 13;
  constexpr double kSpacing = 0.0012;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      lip.surface.points.push_back(kLipTop + kSpacing * Vec3(i - kSide / 2, j - kSide / 2, 0));
      lip.jaw_share.push_back(0.6f);
    }
  for (int j = 0; j + 1 < kSide; ++j)
    for (int i = 0; i + 1 < kSide; ++i) {
      const int a = j * kSide + i;
      lip.surface.triangles.push_back({a, a + 1, a + kSide + 1});
      lip.surface.triangles.push_back({a, a + kSide + 1, a + kSide});
    }
  lip.jaw_body = kMouthJaw;
  lip.bed_pa_m = 1.5e6;
  lip.tension_n_m = 6.0;
  lip.recovery_s = 0.15;
  return lip;
}

inline SceneDescription mouth_scene(const std::array<int, 3>& cells = {10, 10, 5}) {
  SceneDescription d = block_scene();
  d.soft = box_body(Vec3(0.03, 0.03, 0.015), cells, {6000.0, 0.45, 1040.0});
  SprungBody jaw;
  jaw.motion = SprungBody::Motion::hinge;
  jaw.pivot = Vec3(0.015, 0.045, 0.0);
  jaw.stiffness = 2.0;
  jaw.inertia = 3e-5;
  jaw.damping = 2 * std::sqrt(jaw.stiffness * jaw.inertia);
  jaw.stop = 0.02;
  d.soft.bodies.push_back(jaw);
  for (std::size_t i = 0; i < d.soft.nodes.size(); ++i)
    if (d.soft.node_anchor[i] == 0 && d.soft.nodes[i].y() < 0.0091) d.soft.node_anchor[i] = kMouthJaw;
  d.rigid.surface = box_surface(kGumTop - Vec3(0, 0, 0.006), Vec3(0.03, 0.008, 0.012));
  d.rigid.triangle_structure.assign(d.rigid.surface.triangles.size(), Structure::gum);
  d.rigid.triangle_part.assign(d.rigid.surface.triangles.size(), 0);
  d.rigid.parts = {{kMouthJaw, 1.0}};
  d.lips = mouth_lip();
  d.tool.surface = box_surface(Vec3(0, 0, 0.0015), Vec3(0.014, 0.014, 0.003));  // its lower face at the pose
  // Beside the tongue, half hidden by a bar high on the jaw.
  d.sight.eye = Vec3(0.040, 0.015, 0.3);
  d.sight.glottis_outline = {Vec3(0.037, 0.012, -0.01), Vec3(0.043, 0.012, -0.01), Vec3(0.043, 0.018, -0.01),
                             Vec3(0.037, 0.018, -0.01)};
  d.sight.occluders = {box_surface(Vec3(0.040, 0.011, 0.030), Vec3(0.010, 0.008, 0.004))};
  SightDescription::Follower follower;
  follower.body = kMouthJaw;
  follower.glottis_share = 0.2;
  follower.point_share.assign(d.sight.occluders[0].points.size(), 1.0f);
  d.sight.followers = {follower};
  return d;
}

constexpr double kPressTime = 0.6, kWayTime = 0.15;  // s

/// The hand over `top` after t s: from 3 mm above to `depth` below it, held, and up again within kPressTime.
inline Pose press_on(const Vec3& top, double depth, double t) {
  const double in = std::clamp(t / 0.25, 0.0, 1.0) - std::clamp((t - 0.4) / 0.2, 0.0, 1.0);
  Pose pose;
  pose.position = top + Vec3(0, 0, 0.003 - (0.003 + depth) * in);
  return pose;
}

/// Presses tongue, gum and lip in turn, on the way from one to the next above all of them.
inline Pose tour(double t) {
  struct Stop {
    Vec3 top;
    double depth;
  };
  static const Stop kStops[] = {{kTongueTop, 0.006}, {kGumTop, 0.003}, {kLipTop, 0.003}};
  const int n = std::min(2, static_cast<int>(t / (kPressTime + kWayTime)));
  const double within = t - n * (kPressTime + kWayTime);
  Pose pose = press_on(kStops[n].top, kStops[n].depth, within);
  if (n < 2) {
    const double on_the_way = std::clamp((within - kPressTime) / kWayTime, 0.0, 1.0);
    pose.position += on_the_way * (kStops[n + 1].top - kStops[n].top);
  }
  return pose;
}
constexpr double kTourTime = 3 * kPressTime + 2 * kWayTime;

/// Scene and servo on one thread, each step finished `late` ticks after the tick that fed it (0: in it).
class LateLoop {
 public:
  explicit LateLoop(const Scene& scene, int late = 0) : late(late), state(scene), scene_(scene) {}

  TickRecord tick(std::int64_t n, const PortInput& in) noexcept {
    const bool idle = fed_at_ < 0 || n - fed_at_ >= late;
    if (idle) {
      finished_ = running_;
      running_ = step(scene_, state, step_input(in));
      fed_at_ = n;
    }
    return servo_tick(scene_, n, in, idle ? running_.step : -1, late == 0 ? running_ : finished_, !idle, servo);
  }

  int late;
  SceneState state;
  ServoState servo;

 private:
  const Scene& scene_;
  StepResult finished_, running_;
  std::int64_t fed_at_ = -1;
};

}  // namespace vallecula::engine::testing
