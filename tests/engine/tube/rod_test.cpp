// The tube in the hand: its natural curve, turning it, walls, friction, coming to rest, bad input.
#include "engine/tube/rod.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "tests/engine/allocations.h"
#include "tests/engine/tube/rods.h"

namespace vallecula::engine {
namespace {

using testing::dead_load;
using testing::settle;
using testing::straight_rod;

Rod usual_tube() {
  const TubeDesign tube = tube_design("3.5");
  return Rod(tube_rod(tube, nullptr, usual_grip_from_tip(tube)));
}

Pose turned(double angle) {
  Pose p;
  p.rotation = Eigen::AngleAxisd(angle, Vec3::UnitX());
  return p;
}

/// The tip's direction about the grip's axis, rad; 0 towards +z.
double tip_angle(const RodState& s) { return std::atan2(-s.position[0].y(), s.position[0].z()); }

double fastest(const RodState& s) {
  double most = 0.0;
  for (const Vec3& v : s.velocity) most = std::max(most, v.norm());
  return most;
}

/// Points along the rod against the plane n x = 0, which they must stay above by the tube's radius.
int plane_contacts(const Rod& rod, const RodState& s, const Vec3& normal, double offset, double friction,
                   std::array<RodContact, kTubeNodes>& contacts) {
  for (int i = 0; i < kTubeNodes; ++i) {
    RodContact& c = contacts[i];
    c = RodContact{};
    c.node = std::min(i, kTubeNodes - 2);
    c.weight = i == kTubeNodes - 1 ? 1.0 : 0.0;
    c.normal = normal;
    c.depth_m = rod.description().outer_radius_m - (normal.dot(s.position[i]) - offset);
    c.friction = friction;
  }
  return kTubeNodes;
}

TEST(Rod, KeepsItsNaturalCurve) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  const Vec3 placed = state.position[0];
  // Bent elsewhere and let go it comes back.
  settle(rod, state, Pose{}, {dead_load(0, Vec3(0, 0.03, -0.05))}, 500);
  EXPECT_GT((state.position[0] - placed).norm(), 0.005);
  settle(rod, state, Pose{}, {}, 4000);
  EXPECT_LT((state.position[0] - placed).norm(), 1e-5);
  // The circle through three nodes far apart.
  const Vec3 a = state.position[0], b = state.position[19], c = state.position[37];
  const double radius = (a - b).norm() * (b - c).norm() * (c - a).norm() / (2 * (b - a).cross(c - a).norm());
  EXPECT_NEAR(radius, 0.140, 0.02 * 0.140);
  EXPECT_GT(state.position[0].z(), 0.03);  // towards +z of the hand
  EXPECT_NEAR(state.position[0].y(), 0.0, 1e-6);
}

TEST(Rod, TurningTheHandTurnsTheBend) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  for (int n = 0; n < 500; ++n) step(rod, state, turned(M_PI / 2 * std::min(1.0, n / 300.0)), nullptr, 0, 0.001);
  settle(rod, state, turned(M_PI / 2), {}, 2000);
  EXPECT_NEAR(tip_angle(state), M_PI / 2, 1e-4);
  // Two whole turns are two whole turns.
  for (int n = 0; n < 4000; ++n) step(rod, state, turned(M_PI / 2 + 4 * M_PI * n / 4000.0), nullptr, 0, 0.001);
  settle(rod, state, turned(M_PI / 2), {}, 2000);
  EXPECT_NEAR(tip_angle(state), M_PI / 2, 1e-4);
  EXPECT_LT(energy(rod, state), 1e-9);
}

TEST(Rod, AgainstAWallTheTipLagsBehindTheHand) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  std::array<RodContact, kTubeNodes> contacts;
  // A wall on the side to which the tip goes, met when it has turned by 30 degrees: it slides along, away from the way
  // it is turned. (Turned by 90 degrees it would be pressed straight at the wall.)
  const double wall = 0.5 * state.position[0].z();
  double angle = 0.0;
  RodStep r;
  for (int n = 0; n < 3000; ++n) {
    angle = M_PI / 3 * std::min(1.0, n / 1000.0);
    const int count = plane_contacts(rod, state, Vec3::UnitY(), -wall, 0.0, contacts);
    r = step(rod, state, turned(angle), contacts.data(), count, 0.001);
  }
  EXPECT_LT(tip_angle(state), 0.85 * angle);
  EXPECT_GT(tip_angle(state), 0.0);
  EXPECT_GT(std::abs(r.on_hand.torque.x()), 1e-4);  // the hand feels it
  EXPECT_GT(r.on_hand.force.y(), 0.005);
}

TEST(Rod, TheHandBearsWhatTheContactsPushWith) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  std::array<RodContact, kTubeNodes> contacts;
  const double wall = state.position[0].x() + 0.003;
  RodStep r;
  double last = 0.0, change = 0.0;
  for (int n = 0; n < 3000; ++n) {
    const int count = plane_contacts(rod, state, Vec3::UnitX(), wall, 0.3, contacts);
    r = step(rod, state, Pose{}, contacts.data(), count, 0.001);
    if (n > 1000) change = std::max(change, std::abs(r.on_hand.force.x() - last));
    last = r.on_hand.force.x();
  }
  Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
  for (int i = 0; i < kTubeNodes; ++i) {
    sum += contacts[i].force;
    torque += (state.position[i] - state.position.back()).cross(contacts[i].force);
  }
  EXPECT_GT(sum.x(), 0.005);
  EXPECT_LT((r.on_hand.force - sum).norm(), 1e-4 * sum.norm());
  EXPECT_LT((r.on_hand.torque - torque).norm(), 1e-3 * torque.norm());
  EXPECT_LT(change, 1e-5);
}

TEST(Rod, FrictionIsCoulombs) {
  // A straight rod pressed on a floor by its own (large) weight and drawn along itself.
  RodDescription d = straight_rod();
  d.gravity_m_s2 = Vec3(0, 0, -50 * 9.81);
  const Rod rod(d);
  const double weight = d.mass_kg_m * d.length_m * 50 * 9.81;
  for (double mu : {0.1, 0.3}) {
    RodState state(rod, Pose{});
    std::array<RodContact, kTubeNodes> contacts;
    Pose hand;
    hand.position.z() = d.outer_radius_m;
    RodStep r;
    double pressed = 0.0;
    for (int n = 0; n < 3000; ++n) {
      hand.position.x() = 0.02 * std::max(0, n - 1000) * 0.001;
      const int count = plane_contacts(rod, state, Vec3::UnitZ(), 0.0, mu, contacts);
      r = step(rod, state, hand, contacts.data(), count, 0.001);
    }
    for (const RodContact& c : contacts) pressed += c.force.z();
    EXPECT_GT(pressed, 0.5 * weight);
    EXPECT_NEAR(-r.on_hand.force.x(), mu * pressed, 0.02 * mu * pressed);
    for (const RodContact& c : contacts) EXPECT_LE(c.force.head<2>().norm(), 1.01 * mu * c.force.z() + 1e-9);
  }
}

TEST(Rod, BelowFrictionsLimitItSticks) {
  RodDescription d = straight_rod();
  d.grip_n_m = 1e-3;  // nobody holds it along; the floor does
  d.gravity_m_s2 = Vec3(0, 0, -9.81);
  d.gravity_m_s2.x() = 0.15 * 9.81;  // a slope of half of mu
  const Rod rod(d);
  Pose hand;
  hand.position.z() = d.outer_radius_m;
  RodState state(rod, hand);
  std::array<RodContact, kTubeNodes> contacts;
  for (int n = 0; n < 1000; ++n) {
    const int count = plane_contacts(rod, state, Vec3::UnitZ(), 0.0, 0.3, contacts);
    step(rod, state, hand, contacts.data(), count, 0.001);
  }
  EXPECT_LT(fastest(state), 5.1e-4 / 2 + 2e-5);  // half the limit: half the speed below which friction is a damper
  EXPECT_LT(std::abs(state.position[0].x() + d.length_m), 3e-4);
}

TEST(Rod, ResistsOnlyWhatPushes) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  RodContact away;
  away.depth_m = -0.001;
  const RodStep r = step(rod, state, Pose{}, &away, 1, 0.001);
  EXPECT_EQ(away.force.norm(), 0.0);
  EXPECT_LT(r.on_hand.force.norm(), 1e-9);
}

TEST(Rod, EnergyFallsUntilItRests) {
  for (const char* size : {"2.5", "3.0", "3.5", "4.0"}) {
    const TubeDesign tube = tube_design(size);
    const Rod rod(tube_rod(tube, nullptr, usual_grip_from_tip(tube)));
    RodState state(rod, Pose{});
    settle(rod, state, Pose{}, {dead_load(0, Vec3(0.01, 0.05, -0.06))}, 1000);
    double last = energy(rod, state);
    const double first = last;
    for (int n = 0; n < 2000; ++n) {
      step(rod, state, Pose{}, nullptr, 0, 0.001);
      const double now = energy(rod, state);
      ASSERT_LE(now, last + 1e-9 * first) << size << ", step " << n;
      last = now;
    }
    EXPECT_LT(last, 1e-9 * first) << size;
    EXPECT_LT(fastest(state), 1e-6) << size;
  }
}

TEST(Rod, LiesStillOnAWall) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  std::array<RodContact, kTubeNodes> contacts;
  const double wall = 0.6 * state.position[0].z();
  for (int n = 0; n < 2000; ++n) {
    const int count = plane_contacts(rod, state, -Vec3::UnitZ(), -wall, 0.2, contacts);
    step(rod, state, Pose{}, contacts.data(), count, 0.001);
  }
  EXPECT_LT(fastest(state), 1e-6);
}

bool same_bits(const RodState& a, const RodState& b) {
  return std::memcmp(a.position.data(), b.position.data(), sizeof a.position) == 0 &&
         std::memcmp(a.velocity.data(), b.velocity.data(), sizeof a.velocity) == 0 &&
         std::memcmp(a.rotation.data(), b.rotation.data(), sizeof a.rotation) == 0;
}

TEST(Rod, EqualStatesAndInputsGiveEqualBits) {
  const Rod rod = usual_tube();
  RodState once(rod, Pose{});
  RodState kept = once;
  std::array<RodContact, kTubeNodes> contacts;
  const auto run = [&](RodState& s, int from, int to) {
    for (int n = from; n < to; ++n) {
      const int count = plane_contacts(rod, s, -Vec3::UnitZ(), -0.03, 0.2, contacts);
      step(rod, s, turned(0.001 * n), contacts.data(), count, 0.001);
    }
  };
  run(once, 0, 400);
  RodState again(rod, Pose{});
  run(again, 0, 200);
  kept = again;  // a copy in the middle goes the same way
  run(kept, 200, 400);
  EXPECT_TRUE(same_bits(once, kept));
}

TEST(Rod, AStepAllocatesNothing) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  std::array<RodContact, kTubeNodes> contacts;
  const int count = plane_contacts(rod, state, -Vec3::UnitZ(), -0.03, 0.2, contacts);
  const long before = testing::allocations;
  for (int n = 0; n < 10; ++n) step(rod, state, turned(0.1), contacts.data(), count, 0.001);
  Pose bad;
  bad.position.x() = std::numeric_limits<double>::quiet_NaN();
  step(rod, state, bad, contacts.data(), count, 0.001);
  EXPECT_EQ(testing::allocations, before);
}

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

TEST(Rod, WhateverComesItStaysFiniteAndRecovers) {
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

TEST(Rod, AStateThatWasLostIsPutBackInTheHand) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  state.velocity[7].y() = std::numeric_limits<double>::infinity();
  const RodStep r = step(rod, state, turned(0.3), nullptr, 0, 0.001);
  EXPECT_EQ(r.faults, kRodFaultState);
  EXPECT_EQ(r.on_hand.force.norm(), 0.0);
  const RodState rest(rod, turned(0.3));
  EXPECT_TRUE(same_bits(state, rest));
}

TEST(Rod, AHandThatIsNoPoseLeavesTheLastOne) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  Pose bad;
  bad.rotation = Quat(0, 0, 0, 0);
  const RodStep r = step(rod, state, bad, nullptr, 0, 0.001);
  EXPECT_EQ(r.faults, kRodFaultGrip);
  EXPECT_LT(r.on_hand.force.norm(), 1e-9);
}

TEST(Rod, AHandThatJumpsIsFollowedWithoutHarm) {
  const Rod rod = usual_tube();
  RodState state(rod, Pose{});
  Pose there;
  there.position = Vec3(0.2, -0.1, 0.05);
  there.rotation = Eigen::AngleAxisd(2.5, Vec3(1, 2, 3).normalized());
  settle(rod, state, there, {}, 5000);
  EXPECT_LT((state.position[0] - RodState(rod, there).position[0]).norm(), 1e-4);
  EXPECT_LT(fastest(state), 1e-4);
}

TEST(Rod, SaysWhatIsWrongWithADescription) {
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
