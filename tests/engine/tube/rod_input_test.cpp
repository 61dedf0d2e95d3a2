// The rod under whatever comes: hands that are no pose or jump, wild contacts, lost states, wrong descriptions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/engine/tube/rods.h"

namespace vallecula::engine {
namespace {

using namespace testing;  // rods.h

/// Numbers from nowhere to 1e300, of both signs, and now and then none at all.
class Wild {
 public:
  double uniform() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) * 0x1.0p-53;
  }
  double number() {
    const double kind = uniform();
    if (kind < 0.02) return std::numeric_limits<double>::quiet_NaN();
    if (kind < 0.04) return std::numeric_limits<double>::infinity();
    const double size = kind < 0.3 ? std::pow(10, 600 * uniform() - 300) : std::pow(10, 6 * uniform() - 5);
    return uniform() < 0.5 ? -size : size;
  }
  Vec3 vector() { return Vec3(number(), number(), number()); }

 private:
  std::uint64_t state_ = 20240607;
};

TEST(RodInput, WhateverComesItStaysFiniteAndRecovers) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  Wild wild;
  std::uint32_t faults = 0;
  std::array<RodContact, 20> contacts;
  for (int n = 0; n < 5000; ++n) {
    Pose hand;
    hand.position = wild.vector();
    hand.rotation = Quat(wild.number(), wild.number(), wild.number(), wild.number());
    if (wild.uniform() < 0.9) hand.rotation.normalize();
    for (RodContact& c : contacts) {
      c.node = static_cast<int>(60 * wild.uniform()) - 5;
      c.weight = wild.uniform() < 0.9 ? wild.uniform() : wild.number();
      c.normal = wild.vector();
      if (wild.uniform() < 0.9) c.normal.normalize();
      c.depth_m = wild.number();
      c.stiffness_n_m = wild.number();
      c.friction = wild.number();
      c.surface_velocity = wild.vector();
    }
    const RodStep r = step(rod, state, hand, contacts.data(), 20, wild.number());
    faults |= r.faults;
    ASSERT_TRUE(r.on_hand.force.allFinite() && r.on_hand.torque.allFinite()) << n;
    for (int i = 0; i < kTubeNodes; ++i) ASSERT_TRUE(state.position[i].allFinite() && state.velocity[i].allFinite());
    for (const Quat& q : state.rotation) ASSERT_NEAR(q.norm(), 1.0, 1e-9);
    for (const RodContact& c : contacts) ASSERT_TRUE(c.force.allFinite()) << n;
  }
  EXPECT_TRUE(faults & kRodFaultGrip);
  EXPECT_TRUE(faults & kRodFaultContact);
  Pose hand;
  hand.position = state.position.back();
  settle(rod, state, hand, {}, 6000);
  EXPECT_LT(fastest(state), 1e-4);
  EXPECT_LT(energy(rod, state), 1e-6);
}

TEST(RodInput, AStateThatWasLostIsPutBackInTheHand) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  state.velocity[7].y() = std::numeric_limits<double>::infinity();
  const RodStep r = step(rod, state, turned(0.3), nullptr, 0, 0.001);
  EXPECT_EQ(r.faults, kRodFaultState);
  EXPECT_EQ(r.on_hand.force.norm(), 0.0);
  const RodState rest(rod, turned(0.3));
  EXPECT_TRUE(same_bits(state, rest));
}

TEST(RodInput, AHandThatIsNoPoseLeavesTheLastOne) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  Pose bad;
  bad.rotation = Quat(0, 0, 0, 0);
  const RodStep r = step(rod, state, bad, nullptr, 0, 0.001);
  EXPECT_EQ(r.faults, kRodFaultGrip);
  EXPECT_LT(r.on_hand.force.norm(), 1e-9);
}

TEST(RodInput, AHandThatJumpsIsFollowedWithoutHarm) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  Pose there;
  there.position = Vec3(0.2, -0.1, 0.05);
  there.rotation = Eigen::AngleAxisd(2.5, Vec3(1, 2, 3).normalized());
  settle(rod, state, there, {}, 5000);
  EXPECT_LT((state.position[0] - RodState(rod, there).position[0]).norm(), 1e-4);
  EXPECT_LT(fastest(state), 1e-4);
}

TEST(RodInput, SaysWhatIsWrongWithADescription) {
  const auto message = [](auto change) {
    RodDescription d = straight_rod();
    change(d);
    try {
      Rod rod(d);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(message([](RodDescription&) {}), "nothing");
  EXPECT_NE(message([](RodDescription& d) { d.length_m = 0; }).find("length, m, is 0.0"), std::string::npos);
  EXPECT_NE(message([](RodDescription& d) { d.outer_radius_m = 0.05; }).find("50.0"), std::string::npos);
  EXPECT_NE(message([](RodDescription& d) { d.section[5].bending_n_m2 = -1; }).find("joint 5"), std::string::npos);
  EXPECT_NE(message([](RodDescription& d) { d.section[9].natural_curvature_per_m = 1e4; }).find("joint 9"),
            std::string::npos);
  EXPECT_NE(message([](RodDescription& d) { d.gravity_m_s2.x() = NAN; }).find("gravity"), std::string::npos);
  for (auto member : {&RodDescription::mass_kg_m, &RodDescription::stretching_n, &RodDescription::grip_n_m,
                      &RodDescription::grip_nm_rad, &RodDescription::damping_s})
    EXPECT_NE(message([&](RodDescription& d) { d.*member = NAN; }), "nothing");
}

}  // namespace
}  // namespace vallecula::engine
