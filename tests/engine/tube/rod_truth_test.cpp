// The rod against beam theory: small and large deflection, own weight, Euler's buckling load, twist, independence of
// step and iterations. The elastica's numbers come from an integration of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/tube/rods.h"

namespace vallecula::engine {
namespace {

using testing::dead_load;
using testing::free_length;
using testing::kEi;
using testing::settle;
using testing::straight_rod;

/// Where a cantilever's tip goes under a dead load across it: the elastica E I theta'' = -P cos(theta), theta(0) = 0,
/// theta'(L) = 0, shot from the clamp by its curvature there (bisection) and integrated by Runge and Kutta.
struct Elastica {
  double along, across;  ///< of the tip from the clamp, m
};
Elastica elastica(double ei, double length, double load) {
  constexpr int kSteps = 4000;
  const double h = length / kSteps;
  Elastica tip{};
  const auto shoot = [&](double curvature) {
    double theta = 0.0;
    tip = {};
    const auto bend = [&](double angle) { return -load / ei * std::cos(angle); };
    for (int n = 0; n < kSteps; ++n) {
      const double k1 = curvature, m1 = bend(theta);
      const double k2 = curvature + h / 2 * m1, m2 = bend(theta + h / 2 * k1);
      const double k3 = curvature + h / 2 * m2, m3 = bend(theta + h / 2 * k2);
      const double k4 = curvature + h * m3, m4 = bend(theta + h * k3);
      const double middle = theta + h / 4 * (k1 + k2), end = theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      tip.along += h / 6 * (std::cos(theta) + 4 * std::cos(middle) + std::cos(end));
      tip.across += h / 6 * (std::sin(theta) + 4 * std::sin(middle) + std::sin(end));
      theta = end;
      curvature += h / 6 * (m1 + 2 * m2 + 2 * m3 + m4);
    }
    return curvature;  // at the tip
  };
  double low = 0.0, high = load * length / ei * 1.01;  // the moment's arm is at most the length
  for (int n = 0; n < 60; ++n) (shoot((low + high) / 2) > 0 ? high : low) = (low + high) / 2;
  shoot((low + high) / 2);
  return tip;
}

TEST(RodTruth, TheElasticaOfThisTestIsTheTabulatedOne) {
  // Bisshopp and Drucker 1945: P L^2 / E I = 1, 2, 4, 10: tip across 0.302, 0.493, 0.670, 0.811 and along 0.944, 0.840,
  // 0.671, 0.445 of the length.
  const double load[] = {1, 2, 4, 10}, across[] = {0.302, 0.493, 0.670, 0.811}, along[] = {0.944, 0.840, 0.671, 0.445};
  for (int i = 0; i < 4; ++i) {
    const Elastica tip = elastica(1, 1, load[i]);
    EXPECT_NEAR(tip.across, across[i], 0.001) << load[i];
    EXPECT_NEAR(tip.along, along[i], 0.001) << load[i];
  }
}

TEST(RodTruth, SmallDeflectionOfACantilever) {
  const Rod rod(straight_rod());
  const double length = free_length(rod), load = 0.002;
  for (const Vec3& across : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(0, -0.6, 0.8)}) {
    RodState state(rod, Pose{});
    settle(rod, state, Pose{}, {dead_load(0, load * across)}, 4000);
    const double expected = load * std::pow(length, 3) / (3 * kEi);
    EXPECT_NEAR(state.position[0].dot(across), expected, 0.01 * expected);
    // Halfway: P x^2 (3 L - x) / (6 E I), x from the clamp.
    const int node = 19;
    const double x = length - node * rod.segment_m();
    const double half = load * x * x * (3 * length - x) / (6 * kEi);
    EXPECT_NEAR(state.position[node].dot(across), half, 0.01 * half);
  }
}

TEST(RodTruth, LargeDeflectionIsTheElastica) {
  const Rod rod(straight_rod());
  const double length = free_length(rod);
  for (double scaled : {1.0, 2.0, 4.0, 10.0}) {
    const double load = scaled * kEi / (length * length);
    RodState state(rod, Pose{});
    settle(rod, state, Pose{}, {dead_load(0, Vec3(0, 0, load))}, 4000);
    const Elastica tip = elastica(kEi, length, load);
    EXPECT_NEAR(state.position[0].z(), tip.across, 0.01 * tip.across) << scaled;
    EXPECT_NEAR(-state.position[0].x() - rod.segment_m() / 2, tip.along, 0.01 * length) << scaled;
  }
}

TEST(RodTruth, ItsOwnWeightBendsIt) {
  RodDescription d = straight_rod();
  d.gravity_m_s2 = Vec3(0, 0.1 * 9.81, 0);  // a tenth, so that the deflection is small
  const Rod rod(d);
  RodState state(rod, Pose{});
  const RodStep r = settle(rod, state, Pose{}, {}, 4000);
  const double weight = d.mass_kg_m * d.gravity_m_s2.y();
  const double expected = weight * std::pow(free_length(rod), 4) / (8 * kEi);
  EXPECT_NEAR(state.position[0].y(), expected, 0.02 * expected);
  EXPECT_NEAR(r.on_hand.force.y(), weight * d.length_m, 1e-3 * weight * d.length_m);
}

TEST(RodTruth, StiffnessDoesNotDependOnTheStep) {
  const Rod rod(straight_rod());
  const double load = 2 * kEi / std::pow(free_length(rod), 2);
  Vec3 tip[3];
  const double dt[] = {0.0005, 0.001, 0.002};
  for (int i = 0; i < 3; ++i) {
    RodState state(rod, Pose{});
    RodContact c = dead_load(0, Vec3(0, 0, load));
    for (double t = 0; t < 4; t += dt[i]) step(rod, state, Pose{}, &c, 1, dt[i]);
    tip[i] = state.position[0];
  }
  EXPECT_LT((tip[0] - tip[1]).norm(), 1e-6);
  EXPECT_LT((tip[2] - tip[1]).norm(), 1e-6);
}

/// Whether a rod pushed along itself by `load` leaves its line: a small bend grows.
bool buckles(const Rod& rod, double load) {
  RodState state(rod, Pose{});
  settle(rod, state, Pose{}, {dead_load(0, Vec3(load, 0, 0)), dead_load(0, Vec3(0, 0, 1e-5))}, 200);
  settle(rod, state, Pose{}, {dead_load(0, Vec3(load, 0, 0))}, 500);  // what damping holds back goes
  const double early = std::hypot(state.position[0].y(), state.position[0].z());
  settle(rod, state, Pose{}, {dead_load(0, Vec3(load, 0, 0))}, 1000);
  const double late = std::hypot(state.position[0].y(), state.position[0].z());
  return late > early || late > 0.01 * rod.description().length_m;
}

TEST(RodTruth, BucklesAtEulersLoad) {
  for (double length_m : {0.08, 0.12, 0.16}) {
    const Rod rod(straight_rod(length_m));
    const double euler = M_PI * M_PI * kEi / (4 * std::pow(free_length(rod), 2));
    double low = 0.5 * euler, high = 1.5 * euler;
    EXPECT_FALSE(buckles(rod, low));
    EXPECT_TRUE(buckles(rod, high));
    for (int n = 0; n < 8; ++n) (buckles(rod, (low + high) / 2) ? high : low) = (low + high) / 2;
    EXPECT_NEAR((low + high) / 2, euler, 0.02 * euler) << length_m;
  }
}

// Pushed by the hand onto a wall where its tip sticks it is clamped and pinned: it gives way at 20.19 E I / L^2, and
// bulges from there on with hardly more force.
TEST(RodTruth, PushedAgainstAWallItBucklesInTheHand) {
  RodDescription d = straight_rod();
  for (RodSection& s : d.section) s.natural_curvature_per_m = 0.02;  // no tube is straight
  const Rod rod(d);
  RodState state(rod, Pose{});
  const double wall = state.position[0].x(), length = free_length(rod);
  const double load = 20.19 * kEi / (length * length);
  double most = 0.0, last = 0.0, bulge = 0.0;
  for (int n = 0; n < 6000; ++n) {
    Pose hand;
    hand.position.x() = -0.002 * std::min(1.0, n / 5000.0);
    RodContact c;
    c.normal = Vec3::UnitX();
    c.depth_m = wall - state.position[0].x();
    c.stiffness_n_m = 1e5;
    c.friction = 5.0;
    const RodStep r = step(rod, state, hand, &c, 1, 0.001);
    last = r.on_hand.force.x();
    most = std::max(most, last);
    for (const Vec3& x : state.position) bulge = std::max(bulge, std::abs(x.z()));
  }
  EXPECT_NEAR(last, load, 0.05 * load);
  EXPECT_LT(most, 1.5 * load);  // while it bulges its damping resists as well
  EXPECT_GT(bulge, 0.005);
}

// Beyond the load it stays bent: the elastica's post-buckling, P / P_euler = (2 / pi K(sin(a / 2)))^2 for a tip angle
// a.
TEST(RodTruth, BentBeyondEulersLoadAsTheElastica) {
  const Rod rod(straight_rod());
  const double length = free_length(rod), euler = M_PI * M_PI * kEi / (4 * length * length);
  const double angle = M_PI / 3, k = std::sin(angle / 2);
  double a = 1, b = std::sqrt(1 - k * k);  // K by the arithmetic-geometric mean
  for (int n = 0; n < 20; ++n) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  const double load = euler * std::pow(1 / a, 2);  // K = pi / (2 a)
  RodState state(rod, Pose{});
  settle(rod, state, Pose{}, {dead_load(0, Vec3(load, 0, 0)), dead_load(0, Vec3(0, 0, 0.01))}, 1000);
  settle(rod, state, Pose{}, {dead_load(0, Vec3(load, 0, 0))}, 8000);
  const Vec3 tangent = state.rotation[0] * Vec3::UnitX();
  EXPECT_NEAR(std::acos(tangent.x()), angle, 0.05 * angle);
}

TEST(RodTruth, StretchesByLessThanHalfAPerCent) {
  const Rod rod(straight_rod());
  RodState state(rod, Pose{});
  settle(rod, state, Pose{}, {dead_load(0, Vec3(-9.9, 0, 0))}, 1000);
  const double stretch = (state.position.back() - state.position[0]).norm() / rod.description().length_m - 1;
  EXPECT_GT(stretch, 0.0045);  // F over E A
  EXPECT_LT(stretch, 0.005);
}

// Torsion: the torque two equal and opposite pushes at an arm's ends make goes to the hand and turns the rod by T L / G
// J. The arm is the rod's own tip bent to a right angle.
TEST(RodTruth, TwistsByTorqueTimesLengthOverGj) {
  RodDescription d = straight_rod();
  const int corner = 6;
  const double segment = d.length_m / kTubeSegments;
  for (int i = corner - 3; i < corner + 3; ++i) d.section[i].natural_curvature_per_m = M_PI / 12 / segment;
  for (int i = 0; i < corner + 3; ++i) d.section[i].bending_n_m2 = d.section[i].twisting_n_m2 = 1.0;  // rigid
  const Rod rod(d);
  RodState state(rod, Pose{});
  const Vec3 tip = state.position[0];
  ASSERT_GT(tip.z(), 0.01);
  const double load = 0.002;
  settle(rod, state, Pose{}, {dead_load(0, Vec3(0, load, 0))}, 4000);
  // The arm's turn about the axis, at the last stiff segment.
  const Vec3 z = state.rotation[corner + 3] * Vec3::UnitZ();
  const double turned = std::atan2(z.y(), z.z());
  const double torque = load * tip.z(), soft = (kTubeJoints - corner - 3) * segment;
  const double expected = torque * soft / (0.7 * kEi);
  EXPECT_NEAR(turned, expected, 0.01 * expected);
}

}  // namespace
}  // namespace vallecula::engine
