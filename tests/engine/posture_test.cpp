// The operator's own head and the infant's: what moves, how far, and what it does to the view.
#include "engine/posture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/haptics/runner.h"
#include "engine/haptics/snapshots.h"
#include "tests/engine/mouth_scene.h"

namespace vallecula::engine {
namespace {

constexpr double kSide = 0.06;  // m, of the square that is looked at from above

SightDescription square_sight(double half) {
  SightDescription sight;
  sight.eye = Vec3(0, 0, 0.3);
  sight.eye_right = Vec3::UnitX();
  sight.eye_up = Vec3::UnitY();
  sight.glottis_outline = {Vec3(-half, -half, 0), Vec3(half, -half, 0), Vec3(half, half, 0), Vec3(-half, half, 0)};
  return sight;
}

TriangleMesh sheet(const Vec3& corner, const Vec3& across, const Vec3& along) {
  return {{corner, corner + across, corner + across + along, corner + along}, {{0, 1, 2}, {0, 2, 3}}};
}

double seen(const LineOfSight& sight, const Vec3& eye_offset, const TriangleMesh* extra = nullptr) {
  auto scratch = sight.make_scratch(8);
  sight.begin(scratch, {}, eye_offset);
  if (extra != nullptr)
    sight.add(scratch, 4, extra->triangles, [&](int i) -> Vec3 { return extra->points[static_cast<std::size_t>(i)]; });
  return sight.visible(scratch);
}

// Half way between eye and square stands a half plane x > 0. The ray from an eye moved by e to g passes it at (e + g) / 2:
// hidden where g > -e, so that of the square (side - 2 e) / (2 side) is seen.
TEST(Posture, AHalfPlaneHidesFromAMovedEyeWhatTheRaysSay) {
  const LineOfSight sight(square_sight(kSide / 2), {}, 14400);
  const TriangleMesh half = sheet(Vec3(0, -1, 0.15), Vec3(1, 0, 0), Vec3(0, 2, 0));
  for (const double e : {-0.02, -0.013, 0.0, 0.004, 0.02}) {
    EXPECT_NEAR(seen(sight, Vec3(e, 0, 0), &half), (kSide - 2 * e) / (2 * kSide), 0.01) << e;
    EXPECT_NEAR(seen(sight, Vec3(e, 0.02, 0), &half), seen(sight, Vec3(e, -0.02, 0), &half), 1e-12) << "symmetry " << e;
  }
  // The edge turned by a quarter: the same of the other direction.
  const TriangleMesh above = sheet(Vec3(-1, 0, 0.15), Vec3(2, 0, 0), Vec3(0, 1, 0));
  EXPECT_NEAR(seen(sight, Vec3(0, 0.02, 0), &above), 1.0 / 6, 0.01);
  EXPECT_NEAR(seen(sight, Vec3(0, -0.02, 0), &above), 5.0 / 6, 0.01);
}

// A patch just before where the eye goes to: from the standing place it is far from the square.
TEST(Posture, AnatomyThatOnlyAMovedEyeMeetsIsNotLeftOut) {
  SightDescription sight = square_sight(0.003);
  const double z = 0.27;
  for (const Vec3& eye :
       {Vec3(0.02, 0, 0), Vec3(-0.02, 0, 0), Vec3(0, 0.02, 0), Vec3(0, -0.02, 0), Vec3(0.02, 0.02, 0)}) {
    const Vec3 middle = eye * (z / 0.3) + Vec3(0, 0, z);
    sight.occluders = {sheet(middle - Vec3(0.004, 0.004, 0), Vec3(0.008, 0, 0), Vec3(0, 0.008, 0))};
    const LineOfSight built(sight);
    EXPECT_EQ(seen(built, Vec3::Zero()), 1.0);
    EXPECT_EQ(seen(built, eye), 0.0) << eye.transpose();
    EXPECT_EQ(seen(built, -eye), 1.0);
  }
}

/// A hand that waits, and keys by time.
class Keys final : public HapticPort {
 public:
  explicit Keys(std::uint32_t (*asked)(double)) : asked_(asked) { input.pose.position = Vec3(0.015, 0.015, 0.08); }
  PortInput read(double time_s) noexcept override {
    input.buttons = asked_(time_s);
    return input;
  }
  void write(const Vec3&) noexcept override {}
  PortInput input;

 private:
  std::uint32_t (*asked_)(double);
};

TEST(Posture, TheEyeGoesByItsKeysInEveryScene) {
  SceneDescription d = testing::mouth_scene({4, 4, 2});
  d.sight.eye_right = Vec3::UnitY();
  d.sight.eye_up = Vec3::UnitX();
  const auto scene = build_scene(d);
  Keys keys([](double t) -> std::uint32_t {
    if (t < 0.1 || t > 1.2) return 0;
    if (t < 0.6) return kActionEyeRight;
    return t < 0.9 ? kActionEyeUp | kActionEyeLeft : kActionEyeUp | kActionEyeDown | kActionEyeLeft | kActionEyeRight;
  });
  Runner runner(scene, keys);
  Replayer replayer(scene);
  double most_speed = 0.0, least = 1.0, most = 0.0;
  Vec3 before = Vec3::Zero();
  runner.run(1700, [&](const TickRecord& r) {
    const TickRecord again = replayer.replay(r);
    ASSERT_EQ(r.glottis_visible, again.glottis_visible);
    const Vec3 at = replayer.snapshot().eye_offset_m;
    most_speed = std::max(most_speed, (at - before).norm() / 0.001);
    before = at;
    least = std::min(least, r.glottis_visible);
    most = std::max(most, r.glottis_visible);
    const auto is = [&](double t, const Vec3& want) {
      if (std::abs(r.time_s - t) < 1e-9) {
        EXPECT_LT((at - want).norm(), 1e-12) << t;
      }
    };
    is(0.05, Vec3::Zero());
    is(0.45, Vec3(0, 0.02, 0));
    is(0.59, Vec3(0, 0.02, 0));
    is(0.899, Vec3(0.02, 0.0, 0));  // up at once, and from the right through the middle
    is(1.65, Vec3::Zero());
  });
  // Both ways at once: 1.5 times the mean speed along each.
  EXPECT_LT(most_speed, 1.5 * kEyeMove / kEyeMoveTime * std::sqrt(2.0) * 1.01);
  EXPECT_GT(most, least + 0.05) << "nothing came before the glottis that a moved eye sees past";
}

TEST(Posture, APauseLeavesBothHeadsAsTheyAre) {
  const auto scene = build_scene(testing::mouth_scene({4, 4, 2}));
  SceneState state(*scene);
  StepInput in;
  in.device.position = Vec3(0.015, 0.015, 0.08);
  in.actions = kActionEyeRight | kActionExtend;
  for (int n = 0; n < 600; ++n) step(*scene, state, in);
  EXPECT_EQ(state.posture.right, 1.0);
  EXPECT_EQ(state.posture.extension, 1.0);
  in.valid = false;
  in.actions = 0;
  for (int n = 0; n < 600; ++n) step(*scene, state, in);
  EXPECT_EQ(state.posture.right, 1.0);
  EXPECT_EQ(state.posture.extension, 1.0);
}

TEST(Posture, WhatIsNoNumberIsBackAtItsStart) {
  PostureState s;
  s.right = std::numeric_limits<double>::quiet_NaN();
  s.extension = std::numeric_limits<double>::infinity();
  step(s, kActionEyeRight, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(s.right, 0.0);
  EXPECT_EQ(s.extension, 0.0);
  step(s, kActionEyeRight, 1e9);
  EXPECT_EQ(s.right, 1.0);
}

// A bare body on its springs comes to rest where the neck has it: on the arc about the joint.
TEST(Posture, ExtensionCarriesTheNeckAlongItsArc) {
  SceneDescription d = testing::mouth_scene({4, 4, 2});
  SprungBody body;
  body.motion = SprungBody::Motion::translation;
  body.stiffness = 80.0;
  body.inertia = 0.010;
  body.damping = 2 * std::sqrt(body.stiffness * body.inertia);
  d.soft.bodies.push_back(body);
  const int last = static_cast<int>(d.soft.bodies.size()) - 1;
  const Vec3 joint(0, 0.06, 0.03), at(0.001, 0.02, -0.01);  // 40 mm before the joint and as much below it
  d.neck.joint = joint;
  d.neck.carried = {{last, at}};
  const auto scene = build_scene(d);
  SceneState state(*scene);
  StepInput in;
  in.device.position = Vec3(0.015, 0.015, 0.08);
  in.actions = kActionExtend;
  for (int n = 0; n < 1500; ++n) step(*scene, state, in);
  // Below the joint goes backwards (+y), before it goes down (-z): by hand, for 10 degrees.
  const double s = std::sin(10 * M_PI / 180), c = std::cos(10 * M_PI / 180), y = -0.04, z = -0.04;
  const Vec3 want(0, c * y - s * z - y, s * y + c * z - z);
  ASSERT_GT(want.y(), 0.005);
  ASSERT_LT(want.z(), -0.005);
  EXPECT_LT((state.tissue.body_displacement[static_cast<std::size_t>(last)] - want).norm(), 1e-5);
  in.actions = 0;
  for (int n = 0; n < 1500; ++n) step(*scene, state, in);
  EXPECT_LT(state.tissue.body_displacement[static_cast<std::size_t>(last)].norm(), 1e-5);
}

TEST(Posture, ANeckThatCarriesWhatCannotShiftIsRefused) {
  SceneDescription d = testing::mouth_scene({4, 4, 2});
  d.neck.carried = {{testing::kMouthJaw, Vec3::Zero()}};
  EXPECT_THROW(build_scene(d), std::invalid_argument);
  d.neck.carried = {{99, Vec3::Zero()}};
  EXPECT_THROW(build_scene(d), std::invalid_argument);
}

}  // namespace
}  // namespace vallecula::engine
