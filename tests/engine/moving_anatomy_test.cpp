// Rigid anatomy that gives way with a sprung body: where it is, what it answers with, that it rests and comes back.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "engine/state.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

constexpr double kArm = 0.040;        // m, from the hinge to the middle of the gum
constexpr double kHinge = 0.6;        // N m/rad
const Vec3 kGum(0.10, 0.015, 0.005);  // its middle, far from the tissue
const Vec3 kPivot = kGum - Vec3(0, kArm, 0);

SprungBody hinge() {
  SprungBody jaw;
  jaw.motion = SprungBody::Motion::hinge;
  jaw.pivot = kPivot;
  jaw.axis = Vec3::UnitX();
  jaw.stiffness = kHinge;
  jaw.inertia = 0.030 * kArm * kArm / 3;
  jaw.damping = 2 * std::sqrt(jaw.stiffness * jaw.inertia);
  return jaw;
}

void add_box(RigidAnatomy& rigid, const Vec3& middle, const Vec3& size, int part) {
  const TriangleMesh box = testing::box_surface(middle, size);
  const int first = static_cast<int>(rigid.surface.points.size());
  rigid.surface.points.insert(rigid.surface.points.end(), box.points.begin(), box.points.end());
  for (const auto& t : box.triangles) {
    rigid.surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    rigid.triangle_structure.push_back(Structure::gum);
    rigid.triangle_part.push_back(static_cast<std::int8_t>(part));
  }
}

/// A lower gum of 20 x 6 x 10 mm on a hinge, and a plate of 12 x 12 x 3 mm whose lower face is at its pose.
SceneDescription jaw_scene() {
  SceneDescription d = testing::block_scene();
  d.soft.bodies.push_back(hinge());
  d.rigid.parts = {{1, 1.0}};
  add_box(d.rigid, kGum, Vec3(0.02, 0.006, 0.01), 0);
  d.tool.surface = testing::box_surface(Vec3(0, 0, 0.0015), Vec3(0.012, 0.012, 0.003));
  return d;
}

struct Held {
  double angle = 0.0, arm = 0.0, largest_change = 0.0;
  Vec3 force = Vec3::Zero();
};

/// The hand goes from 20 mm above the gum's middle to `height` above it within 0.4 s and stays; after 1.5 s.
Held press_with(const Scene& scene, SceneState& state, double height) {
  Held held;
  Vec3 last = Vec3::Zero();
  for (int n = 0; n < 1500; ++n) {
    StepInput input;
    input.device.position = kGum + Vec3(0, 0, 0.020 + (height - 0.020) * std::min(1.0, n / 400.0));
    const StepResult r = step(scene, state, input);
    if (n > 1000) held.largest_change = std::max(held.largest_change, (r.model_force_n - last).norm());
    last = r.model_force_n;
    held.arm = (state.parts[0].rest_of(r.loads[static_cast<int>(Structure::gum)].centre_m) - kPivot).y();
  }
  held.force = last;
  held.angle = state.tissue.body_displacement[1].x();
  return held;
}

TEST(RigidField, AMovedPartIsWhereItsLinearisedMotionPutsItAndTheRestStandsStill) {
  RigidAnatomy rigid;
  rigid.parts = {{0, 1.0}, {1, 0.5}};
  add_box(rigid, Vec3(0, 0.04, 0), Vec3(0.01, 0.01, 0.01), 0);
  add_box(rigid, Vec3(0.03, 0.04, 0), Vec3(0.01, 0.01, 0.01), 1);
  add_box(rigid, Vec3(-0.03, 0.04, 0), Vec3(0.01, 0.01, 0.01), -1);
  SprungBody jaw = hinge(), hyoid;
  jaw.pivot = Vec3::Zero();
  hyoid.motion = SprungBody::Motion::translation;
  const RigidField field(rigid, {jaw, hyoid}, Vec3(-0.05, 0.01, -0.03), Vec3(0.05, 0.07, 0.03), 0.0007, 0.005);
  const double angle = -0.15;
  const Vec3 shift(0.001, 0.004, -0.002);
  PartPoses poses;
  field.place({Vec3(angle, 0, 0), shift}, {Vec3::Zero(), Vec3::Zero()}, poses);
  const auto ignored = [](int, double) {};
  const auto distance_at = [&](const Vec3& x, int part) {
    double found = 1.0;
    field.look(x, poses, 0.002, [&](const RigidField::Touch& t) {
      if (t.part == part) found = t.distance;
    }, ignored);
    return found;
  };
  // A millimetre above the middle of each box's top, moved as the body moves.
  const Vec3 top(0, 0.04, 0.006);
  const Vec3 turned = top + angle * Vec3::UnitX().cross(top);
  EXPECT_NEAR(distance_at(turned, 0), 0.001, 1e-5);
  EXPECT_GT(distance_at(turned + Vec3(0, 0, 0.004), 0), 0.5);
  EXPECT_NEAR(distance_at(top + Vec3(0.03, 0, 0) + 0.5 * shift, 1), 0.001, 1e-5);
  EXPECT_NEAR(distance_at(top + Vec3(-0.03, 0, 0), -1), 0.001, 1e-5);
  // The jaw has left where it was: nothing of it is met there.
  EXPECT_GT(distance_at(top, 0), 0.5);
  EXPECT_GT(distance_at(top, -1), 0.5);
  // The normal of the moved top stands square on it.
  const Vec3 along = Vec3::UnitY() + angle * Vec3::UnitX().cross(Vec3::UnitY());
  field.look(turned, poses, 0.002, [&](const RigidField::Touch& t) { EXPECT_NEAR(t.normal.dot(along), 0.0, 1e-4); }, ignored);
}

TEST(MovingAnatomy, AJawUnderTheBladeGivesWayByItsHingeAndRests) {
  const auto scene = build_scene(jaw_scene());
  SceneState state(*scene);
  const Held held = press_with(*scene, state, -0.002);  // 7 mm below the gum's top
  EXPECT_LT(held.angle, -0.02);
  // The gum has tilted, so the plate lies on its edge towards the hinge. The hinge holds what that bears.
  EXPECT_NEAR(held.arm, kArm - 0.003, 0.0012);
  EXPECT_NEAR(held.force.z() * held.arm, -kHinge * held.angle, 0.03 * kHinge * -held.angle);
  // Two springs in a row, the coupling's and the hinge's where the plate lies, share the hand's 7 mm.
  const double coupling = scene->proxy.stiffness_n_m, gum = kHinge / (held.arm * held.arm);
  EXPECT_NEAR(held.force.z(), 0.007 * coupling * gum / (coupling + gum), 0.05);
  EXPECT_LT(held.largest_change, 0.005) << "it chatters";
  const Held let_go = press_with(*scene, state, 0.020);
  EXPECT_NEAR(let_go.angle, 0.0, 1e-5);
  EXPECT_EQ(let_go.force.norm(), 0.0);
}

TEST(MovingAnatomy, AJointHardlyPassesItsStop) {
  SceneDescription d = jaw_scene();
  d.soft.bodies[1].stop = 0.03;
  const auto scene = build_scene(d);
  SceneState state(*scene);
  const Held held = press_with(*scene, state, -0.002);
  const double moment = held.force.z() * held.arm;
  EXPECT_GT(moment, 1.5 * kHinge * 0.03);
  EXPECT_NEAR(-held.angle, 0.03 + (moment - kHinge * 0.03) / (SprungBody::kStopFactor * kHinge), 0.002);
  EXPECT_LT(held.largest_change, 0.005);
}

// What is jammed between both gums opens the mouth: before, it was met by two walls that nothing could part.
TEST(MovingAnatomy, WhatIsJammedBetweenBothGumsOpensTheMouth) {
  SceneDescription d = jaw_scene();
  const double gap = 0.010;  // between the gums; a bar of 12 mm is turned upright in it
  add_box(d.rigid, kGum + Vec3(0, 0, 0.010 + gap), Vec3(0.02, 0.006, 0.01), -1);
  d.tool.surface = testing::box_surface(Vec3::Zero(), Vec3(0.012, 0.030, 0.003));
  const auto scene = build_scene(d);
  SceneState state(*scene);
  const Vec3 middle = kGum + Vec3(0, 0, 0.005 + gap / 2);
  double largest = 0.0, change = 0.0;
  Vec3 last = Vec3::Zero();
  double turned = 0.0;
  for (int n = 0; n < 2000; ++n) {
    StepInput input;
    input.device.position = middle;
    turned = 1.3 * std::min(1.0, n / 1000.0);
    input.device.rotation = Quat(Eigen::AngleAxisd(turned, Vec3::UnitX()));
    const StepResult r = step(*scene, state, input);
    const StructureLoad& gum = r.loads[static_cast<int>(Structure::gum)];
    largest = std::max(largest, gum.force_n.norm());
    if (n > 1500) change = std::max(change, (gum.force_n - last).norm());
    last = gum.force_n;
  }
  EXPECT_LT(state.tissue.body_displacement[1].x(), -0.005);
  EXPECT_LT(largest, 10.0);
  EXPECT_LT(change, 0.02);
}

}  // namespace
}  // namespace vallecula::engine
