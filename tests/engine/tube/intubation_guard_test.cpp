// What every tick of the second half must keep: a hand that is lost, numbers that are none, contacts without room, and
// nothing of it where the scene has none.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/engine/tube/intubation_scene.h"

namespace vallecula::engine {
namespace {

using testing::intubation_scene;
using testing::jamming_scene;
using testing::kBeforeMouth;
using testing::kJammed;
using testing::LateLoop;
using testing::Trial;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expect_number(const IntubationRecord& r) {
  double sum = r.tip_m.sum() + r.tip_direction.sum() + r.model_force_n.sum() + r.displayed_force_n.sum();
  for (const double n : r.loads_n) sum += n;
  sum += r.past_cords_m + r.at_mouth_m + r.buckled_m + r.tip_load_n + r.glottis_opening + r.secretions_ml + r.sao2 +
         r.spo2 + r.heart_per_min + r.given_per_min;
  EXPECT_TRUE(std::isfinite(sum));
}

TEST(IntubationGuard, ALostHandLeavesTheTubeWhereItIsCountsItsForceAndComesBackWithoutAJump) {
  for (const bool as_pose : {false, true}) {
    Trial t(jamming_scene()), twin(jamming_scene());  // the twin's hand stands where it is
    for (Trial* each : {&t, &twin}) {
      each->go(kBeforeMouth, kJammed);
      each->hold(0.5, kJammed);
    }
    const IntubationRecord held = t.record.intubation;
    ASSERT_GT(held.displayed_force_n.norm(), 0.3);
    ASSERT_LT((held.displayed_force_n - held.model_force_n).norm(), 1e-9);
    ASSERT_GT(held.loads_n[static_cast<std::size_t>(AirwayPart::cricoid)], 0.2);

    // Its device vanishes, and reports nonsense from elsewhere.
    for (int n = 0; n < 1000; ++n) {
      PortInput in = t.hands(kJammed + Vec3(0.02, 0, 0.1));
      in.second_valid = as_pose;
      if (as_pose) in.second_pose.position.x() = kNan;
      const IntubationRecord& r = t.tick(in);
      ASSERT_TRUE(r.displayed_force_n.isZero(0)) << n;  // from the first tick on
      ASSERT_NE(r.faults & (as_pose ? kIntubationFaultHandPose : kIntubationFaultHand), 0u);
      const IntubationRecord& still = twin.hold(0.001, kJammed);
      ASSERT_EQ(r.tip_m, still.tip_m) << n;
      ASSERT_EQ(r.model_force_n, still.model_force_n) << n;
      ASSERT_EQ(r.loads_n, still.loads_n) << n;
      ASSERT_GT(r.model_force_n.norm(), 0.3) << n;
      ASSERT_EQ(t.record.faults, 0u);
    }

    // It comes back 3 mm aside, and the tube follows it there at a hand's pace.
    Vec3 last_force = Vec3::Zero(), last_grip = t.loop.state.intubation->rod.position.back();
    for (int n = 0; n < 300; ++n) {
      const IntubationRecord& r = t.hold(0.001, kJammed + Vec3(0.003, 0, 0));
      const Vec3 grip = t.loop.state.intubation->rod.position.back();
      ASSERT_LE((r.displayed_force_n - last_force).norm(), 0.4 + 1e-9);
      ASSERT_LT((grip - last_grip).norm(), 1.2e-4) << n;
      last_force = r.displayed_force_n;
      last_grip = grip;
    }
    EXPECT_EQ(t.record.intubation.faults, 0u);
    EXPECT_FALSE(t.loop.state.intubation->returning);
    EXPECT_GT(last_force.norm(), 0.3);
  }
}

// Whichever hand is lost, the other one moves on alone: neither tool follows it, nothing it asks for happens.
TEST(IntubationGuard, WhileEitherHandIsLostBothToolsStayAndComeBackWithoutAJump) {
  for (const bool second : {false, true}) {
    Trial t(jamming_scene());
    const auto press = [&t](double depth) { t.blade = testing::press_on(testing::kTongueTop, depth, 0.3); };
    press(-0.005);
    t.go(kBeforeMouth, kJammed);
    for (int n = 1; n <= 1000; ++n) {
      press(-0.005 + 0.009 * std::min(1.0, n / 500.0));
      t.hold(0.001, kJammed);
    }
    const Pose proxy = t.record.proxy_pose, grip = t.loop.state.intubation->rod.grip;
    ASSERT_GT(t.record.displayed_force_n.norm(), 0.1);
    ASSERT_GT(t.record.intubation.displayed_force_n.norm(), 0.3);
    const Pose blade = t.blade;
    const auto away = [&](int n) {
      const double way = std::min(1.0, n / 500.0);
      if (second) t.blade.position = blade.position + way * Vec3(0.01, 0.005, 0.02);
      PortInput in = t.hands(kJammed + (second ? Vec3(0, 0, 0) : Vec3(0.002, 0, 0.02 * way)));
      return in;
    };
    for (int n = 0; n < 1000; ++n) {
      PortInput in = away(n);
      in.buttons = kActionStyletOut | kActionBreath | kActionPress;
      (second ? in.second_valid : in.valid) = false;
      const IntubationRecord& r = t.tick(in);
      ASSERT_TRUE(r.displayed_force_n.isZero(0)) << n;  // of either hand, from the first tick on
      ASSERT_TRUE(t.record.displayed_force_n.isZero(0)) << n;
      ASSERT_EQ(t.record.proxy_pose.position, proxy.position) << n;
      ASSERT_EQ(t.record.proxy_pose.rotation.coeffs(), proxy.rotation.coeffs()) << n;
      ASSERT_EQ(t.loop.state.intubation->rod.grip.position, grip.position) << n;
      ASSERT_EQ(t.loop.state.intubation->rod.grip.rotation.coeffs(), grip.rotation.coeffs()) << n;
      ASSERT_EQ(r.in_hand, InHand::tube_with_stylet);
    }
    EXPECT_EQ(t.loop.state.intubation->press, 0.0);
    Vec3 force = Vec3::Zero(), second_force = Vec3::Zero(), at = proxy.position, held = grip.position;
    for (int n = 0; n < 2000; ++n) {  // both hands there; the one that went away comes back to its tool
      const IntubationRecord& r = t.tick(away(std::max(0, 1000 - n)));
      ASSERT_LE((t.record.displayed_force_n - force).norm(), 0.4 + 1e-9) << n;
      ASSERT_LE((r.displayed_force_n - second_force).norm(), 0.4 + 1e-9) << n;
      ASSERT_LT((t.record.proxy_pose.position - at).norm(), 5e-4) << n;
      ASSERT_LE((t.loop.state.intubation->rod.grip.position - held).norm(), 1.001e-4) << n;
      force = t.record.displayed_force_n;
      second_force = r.displayed_force_n;
      at = t.record.proxy_pose.position;
      held = t.loop.state.intubation->rod.grip.position;
    }
    EXPECT_FALSE(t.loop.state.intubation->returning);
    EXPECT_EQ(t.record.state, HapticState::tracking);
    EXPECT_LT((at - t.blade.position).norm(), 0.008);
  }
}

// What takes the force from the blade's hand takes it from the other one too.
TEST(IntubationGuard, ATissueOrABladesPoseThatIsNoNumberLeavesNeitherHandAForce) {
  for (const bool tissue : {false, true}) {
    Trial t(jamming_scene());
    t.go(kBeforeMouth, kJammed);
    t.hold(0.5, kJammed);
    ASSERT_GT(t.record.intubation.displayed_force_n.norm(), 0.3);
    PortInput in = t.hands(kJammed);
    if (tissue)
      t.loop.state.tissue.displacement.back().x() = kNan;
    else
      in.pose.position.x() = kNan;
    const IntubationRecord& r = t.tick(in);
    EXPECT_NE(t.record.faults & (tissue ? kFaultTissue : kFaultDevicePose), 0u);
    EXPECT_TRUE(r.displayed_force_n.isZero(0));
    EXPECT_TRUE(t.record.displayed_force_n.isZero(0));
    EXPECT_GT(t.hold(0.3, kJammed).displayed_force_n.norm(), 0.3);
  }
}

// A long gullet of many rings, all of them pressing.
TEST(IntubationGuard, ContactsWithoutRoomAreNamedAndTheTissueKeepsItsPlaces) {
  SceneDescription d = jamming_scene();
  std::vector<AirwayRing>& gullet = d.intubation->course.oesophagus;
  const AirwayRing first = gullet.front();
  gullet.assign(181, first);
  for (std::size_t n = 0; n < gullet.size(); ++n) {
    gullet[n].centre.z() -= 0.0005 * static_cast<double>(n);
    gullet[n].to_left_m = gullet[n].to_right_m = gullet[n].to_front_m = gullet[n].to_back_m = 0.0022;
  }
  Trial t(d);
  t.go(kBeforeMouth, testing::kBeforeOesophagus);
  t.go(testing::kBeforeOesophagus, testing::kInOesophagus);
  EXPECT_EQ(t.record.intubation.place, TipPlace::oesophagus);
  EXPECT_EQ(t.record.intubation.faults, 0u);
  const Vec3 far = testing::kInOesophagus - Vec3(0, 0, 0.055);
  const IntubationRecord& r = t.go(testing::kInOesophagus, far);
  EXPECT_EQ(r.faults, static_cast<std::uint32_t>(kIntubationFaultContacts));
  EXPECT_EQ(t.loop.state.intubation->contacts.count, kMostTubeContacts + t.loop.state.intubation->soft.count);
  EXPECT_GT(r.displayed_force_n.norm(), 0.05);  // what there is room for is felt
  expect_number(r);
}

TEST(IntubationGuard, TheSecondHandsForceKeepsItsDevicesLimit) {
  SceneDescription d = jamming_scene();
  d.intubation->device_limit_n = 0.25;
  Trial t(d);
  t.go(kBeforeMouth, kJammed);
  const IntubationRecord& r = t.hold(0.5, kJammed);
  EXPECT_GT(r.model_force_n.norm(), 0.3);
  EXPECT_NEAR(r.displayed_force_n.norm(), 0.25, 1e-12);
  EXPECT_GT(r.displayed_force_n.dot(r.model_force_n), 0.99 * r.model_force_n.norm() * 0.25);
}

TEST(IntubationGuard, WhatIsNoNumberIsNamedNotFeltAndTheRestGoesOn) {
  struct Poison {
    const char* what;
    void (*into)(IntubationState&);
    std::uint32_t fault;
  };
  const Poison poisons[] = {
      {"tube", [](IntubationState& s) { s.rod.position[7].x() = kNan; }, kIntubationFaultTube},
      {"tube's turn", [](IntubationState& s) { s.rod.rotation[3].w() = kNan; }, kIntubationFaultTube},
      {"tube's speed", [](IntubationState& s) { s.rod.velocity[0].z() = INFINITY; }, kIntubationFaultTube},
      {"infant", [](IntubationState& s) { s.infant.oxygen.venous = kNan; }, kIntubationFaultInfant},
      {"cords", [](IntubationState& s) { s.glottis.opening = kNan; }, kIntubationFaultInfant},
      {"secretions", [](IntubationState& s) { s.secretions_m3 = kNan; }, kIntubationFaultInfant},
      {"press", [](IntubationState& s) { s.press = kNan; }, kIntubationFaultInfant},
      {"breaths", [](IntubationState& s) { s.until_breath_s = kNan; }, kIntubationFaultInfant},
  };
  for (const Poison& p : poisons) {
    SceneDescription d = intubation_scene();
    d.intubation->secretions.volume_m3 = 1e-6;
    Trial t(d), sound(d);
    for (Trial* each : {&t, &sound}) {
      each->go(kBeforeMouth, testing::kInTrachea, kActionPress);
      each->hold(0.2, testing::kInTrachea, kActionPress);
    }
    p.into(*t.loop.state.intubation);
    const IntubationRecord& r = t.hold(0.001, testing::kInTrachea, kActionPress);
    sound.hold(0.001, testing::kInTrachea, kActionPress);
    EXPECT_EQ(r.faults, p.fault) << p.what;
    expect_number(r);
    EXPECT_EQ(p.fault == kIntubationFaultTube, r.displayed_force_n.isZero(0)) << p.what;
    EXPECT_EQ(t.record.faults, 0u) << p.what;
    for (int n = 0; n < 300; ++n) {
      expect_number(t.hold(0.001, testing::kInTrachea, kActionPress));
      sound.hold(0.001, testing::kInTrachea, kActionPress);
      ASSERT_EQ(t.record.intubation.faults, 0u) << p.what << " " << n;
    }
    // The blade and its tissue have seen nothing of it.
    EXPECT_EQ(std::memcmp(t.loop.state.proxy.pose.position.data(), sound.loop.state.proxy.pose.position.data(), 24), 0);
    EXPECT_EQ(t.loop.state.tissue.displacement, sound.loop.state.tissue.displacement) << p.what;
    EXPECT_EQ(t.record.intubation.secretions_ml, 1.0);
  }
}

// The tube being far away, the blade's records are to the bit those of a scene without any of it.
TEST(IntubationGuard, AwayFromTheTubeTheBladeIsAsInASceneWithoutIt) {
  SceneDescription with = intubation_scene();
  SceneDescription without = with;
  without.intubation.reset();
  const auto scene = build_scene(with), bare = build_scene(without);
  LateLoop a(*scene), b(*bare);
  for (std::int64_t n = 0; n < 1900; ++n) {
    PortInput in;
    in.pose = testing::tour(static_cast<double>(n) * 0.001);
    in.second_pose = testing::hand_of_tip(scene->intubation->rod(InHand::tube), kBeforeMouth + Vec3(0.2, 0, 0));
    const TickRecord r = a.tick(n, in), s = b.tick(n, in);
    ASSERT_TRUE(r.has_intubation);
    ASSERT_FALSE(s.has_intubation);
    ASSERT_EQ(std::memcmp(r.displayed_force_n.data(), s.displayed_force_n.data(), 24), 0) << n;
    ASSERT_EQ(std::memcmp(r.proxy_pose.position.data(), s.proxy_pose.position.data(), 24), 0) << n;
    ASSERT_EQ(r.glottis_visible, s.glottis_visible) << n;
  }
  EXPECT_EQ(a.state.tissue.displacement, b.state.tissue.displacement);
}

/// The tube, with a stylet, laid against a blade that is held still in the free.
TEST(IntubationGuard, TubeAndBladePressEachOtherAndRest) {
  SceneDescription d = intubation_scene();
  d.intubation->stylet = Stylet{};
  d.intubation->stylet->bend_rad = 0;
  Trial t(d);
  t.blade.position = Vec3(0.040, 0.0, 0.060);
  const Vec3 above(0.040, 0.0, 0.075), pressed(0.040, 0.0, 0.058);
  t.hold(0.3, above);
  // The tip comes down on the plate, whose upper face is 3 mm above its pose.
  t.go(above, pressed);
  t.hold(0.5, pressed);
  double change = 0.0;
  Vec3 last = t.record.model_force_n;
  for (int n = 0; n < 300; ++n) {
    t.hold(0.001, pressed);
    change = std::max(change, (t.record.model_force_n - last).norm());
    last = t.record.model_force_n;
  }
  const IntubationRecord& r = t.record.intubation;
  EXPECT_GT(r.loads_n[kLoadBlade], 0.3);
  EXPECT_NEAR(last.norm(), r.loads_n[kLoadBlade], 0.02 * r.loads_n[kLoadBlade]);  // nothing else touches it
  EXPECT_LT(last.z(), -0.3);
  EXPECT_LT((last + r.model_force_n).norm(), 0.02 * last.norm());  // what the hand pushes, the blade bears
  EXPECT_EQ(r.tip_against, kLoadBlade);
  EXPECT_LT(change, 0.002);
}

}  // namespace
}  // namespace vallecula::engine
