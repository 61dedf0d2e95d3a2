// The tube in the hand: its natural curve, turning it, walls, friction, coming to rest.
#include "engine/tube/rod.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/engine/allocations.h"
#include "tests/engine/tube/rods.h"

namespace vallecula::engine {
namespace {

using namespace testing;  // rods.h

/// The tip's direction about the grip's axis, rad; 0 towards +z.
double tip_angle(const RodState& s) { return std::atan2(-s.position[0].y(), s.position[0].z()); }

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
  EXPECT_LT(fastest(state), 1e-4 / 2 + 1e-5);  // half the limit, half the speed below which friction is a damper
  EXPECT_LT(std::abs(state.position[0].x() + d.length_m), 1e-4);
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

// Without friction nothing moves after two seconds; with it what sticks creeps, ever slower and without a tremor.
TEST(Rod, LiesStillOnAWall) {
  for (double mu : {0.0, 0.2}) {
    const Rod rod = usual_tube();
    RodState state(rod, Pose{});
    std::array<RodContact, kTubeNodes> contacts;
    const double wall = 0.6 * state.position[0].z();
    double tremor = 0.0;
    for (int n = 0; n < 2000; ++n) {
      const int count = plane_contacts(rod, state, -Vec3::UnitZ(), -wall, mu, contacts);
      const std::array<Vec3, kTubeNodes> before = state.velocity;
      step(rod, state, Pose{}, contacts.data(), count, 0.001);
      for (int i = 0; n > 1500 && i < kTubeNodes; ++i)
        tremor = std::max(tremor, (state.velocity[i] - before[i]).norm());
    }
    EXPECT_LT(fastest(state), mu > 0 ? 1e-5 : 1e-6);
    EXPECT_LT(tremor, 1e-7);
  }
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

}  // namespace
}  // namespace vallecula::engine
