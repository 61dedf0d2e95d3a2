// The tube against soft tissue. Forces are held against the blade's path of the engine (distance field, other
// contacts), which has its own truth from outside (static_truth_test.cpp); the rest are Newton's laws.
#include <gtest/gtest.h>

#include "engine/lab/experiment.h"
#include "engine/tissue/elasticity.h"
#include "tests/engine/tube/soft_mouth.h"

namespace vallecula::engine {
namespace {

using namespace testing;

TriangleMesh cylinder_along_y(double radius, double half) {
  constexpr int kAround = 96;
  TriangleMesh m;
  for (const double y : {-half, half})
    for (int i = 0; i < kAround; ++i) {
      const double a = 2 * M_PI * i / kAround;
      m.points.push_back(Vec3(radius * std::cos(a), y, radius * std::sin(a)));
    }
  m.points.push_back(Vec3(0, -half, 0));
  m.points.push_back(Vec3(0, half, 0));
  for (int i = 0; i < kAround; ++i) {
    const int j = (i + 1) % kAround;
    m.triangles.push_back({i, kAround + i, kAround + j});
    m.triangles.push_back({i, kAround + j, j});
    m.triangles.push_back({2 * kAround, i, j});
    m.triangles.push_back({2 * kAround + 1, kAround + j, kAround + i});
  }
  return m;
}

/// Mean force along z over the last 50 ms of 0.5 s of a cylinder as the tool, at its axis `depth` below touch.
double tool_force(const SceneDescription& without_tool, double radius, double depth) {
  SceneDescription d = without_tool;
  d.tool.surface = cylinder_along_y(radius, 0.06);
  const auto scene = build_scene(d);
  ExperimentSettings settings;
  settings.duration_s = 0.5;
  settings.measure_tissue = false;
  const auto pose = [&](double t) {
    Pose p;
    p.position = Vec3(0.02, 0.02, kTop + radius - down(depth, 0.02, t));
    return p;
  };
  double sum = 0.0;
  int count = 0;
  for (const ExperimentStep& s : run_experiment(*scene, pose, settings).steps) {
    if (s.time_s < 0.45) continue;
    sum += s.force_n.z();
    ++count;
  }
  return sum / count;
}

double tube_force(const SceneDescription& d, double radius, double depth) {
  const auto scene = build_scene(d);
  const Rod rod = rigid_tube(radius);
  const auto hand = [&](double t) { return along_y(0.02, 0.12, kTop + radius - down(depth, 0.02, t)); };
  Mouth mouth(*scene, rod, hand(0));
  mouth.friction = 0.0;
  double sum = 0.0;
  int count = 0;
  const double h = scene->model.step_s;
  for (int n = 0; n * h < 0.5; ++n) {
    mouth.tick(hand(n * h));
    if (n * h < 0.45) continue;
    sum -= mouth.load.force_n.z();
    ++count;
  }
  return sum / count;
}

TEST(SoftContacts, ARigidTubeReadsWhatACylinderAsTheToolReads) {
  struct Case {
    int cells;
    double radius, deepest;
  };
  // At 3 mm the blade's second line of points within the tissue makes it stiffer than the surface alone.
  for (const Case& c : {Case{16, 0.00245, 0.003}, Case{18, 0.00245, 0.003}, Case{20, 0.0018, 0.002}})
    for (double depth = 0.001; depth < c.deepest + 1e-6; depth += 0.001) {
      const SceneDescription d = tongue_block(c.cells);
      const double tool = tool_force(d, c.radius, depth), tube = tube_force(d, c.radius, depth);
      EXPECT_NEAR(tube, tool, 0.05 * tool) << c.cells << " cells, radius " << c.radius << ", depth " << depth;
    }
}

TEST(SoftContacts, TheForceDoesNotDependOnTheStep) {
  SceneDescription d = tongue_block();
  const double truth = tube_force(d, 0.00245, 0.002);
  for (double step_s : {0.0005, 0.002}) {
    d.step_s = step_s;
    EXPECT_NEAR(tube_force(d, 0.00245, 0.002), truth, 0.02 * truth) << step_s;
  }
}

// A 3.5 tube, with and without its stylet, pushed 3 mm into the tongue and held for a second.
TEST(SoftContacts, HeldStillItIsSteadyAndActionIsReaction) {
  const auto scene = build_scene(tongue_block());
  const Stylet stylet;
  for (const Stylet* within : {static_cast<const Stylet*>(nullptr), &stylet})
    for (double friction : {0.0, 0.1, 0.3}) {
      constexpr double kHeld = 0.05;
      const Rod rod = straight_tube(kHeld, within);
      const auto hand = [&](double t) {
        return along_y(0.02, 0.005 + kHeld, kTop + rod.description().outer_radius_m - down(0.003, 0.02, t));
      };
      Mouth mouth(*scene, rod, hand(0));
      mouth.friction = friction;
      Vec3 low = Vec3::Constant(1e9), high = -low;
      for (int n = 0; n < 1500; ++n) {
        mouth.tick(hand(0.001 * n));
        if (n < 500) continue;
        low = low.cwiseMin(mouth.load.force_n);
        high = high.cwiseMax(mouth.load.force_n);
      }
      EXPECT_LT((high - low).norm(), 0.01) << friction;
      EXPECT_GT(mouth.on_tube.z(), 0.1);
      EXPECT_LT((mouth.on_tube + mouth.load.force_n).norm(), 0.02 * mouth.on_tube.norm()) << friction;
      // Nothing else holds the tube: the hand carries what the tissue presses with.
      EXPECT_LT((mouth.on_hand.force - mouth.on_tube).norm(), 0.02 * mouth.on_tube.norm()) << friction;
      EXPECT_EQ(mouth.soft.left_out, 0);
      EXPECT_GE(mouth.load.tongue_n, mouth.load.force_n.norm());
      EXPECT_EQ(mouth.load.epiglottis_n, 0.0);
    }
}

// What the tissue is pushed by and the tube is pushed by, summed over a fast press and until both are at rest.
TEST(SoftContacts, NoMomentumIsMade) {
  const auto scene = build_scene(tongue_block());
  const Rod rod = straight_tube(0.06);
  const auto hand = [&](double t) {
    return along_y(0.02, 0.065, kTop + rod.description().outer_radius_m - down(0.003, 0.1, t));
  };
  Mouth mouth(*scene, rod, hand(0));
  Vec3 made = Vec3::Zero();
  double impulse = 0.0;
  for (int n = 0; n < 300; ++n) {
    mouth.tick(hand(0.001 * n));
    made += 0.001 * (mouth.on_tube + mouth.load.force_n);
    impulse += 0.001 * mouth.on_tube.norm();
  }
  EXPECT_GT(impulse, 0.01);
  EXPECT_LT(made.norm(), 0.01 * impulse);
}

// A tube bent up and let go falls on the tongue and comes to rest there; the hand stands still, so nothing feeds it.
TEST(SoftContacts, EnergyDoesNotGrow) {
  const auto scene = build_scene(tongue_block());
  for (double friction : {0.0, 0.3}) {
    const Rod rod = straight_tube(0.05);
    const Pose hand = along_y(0.02, 0.055, kTop + rod.description().outer_radius_m - 0.0005);
    Mouth mouth(*scene, rod, hand);
    mouth.friction = friction;
    for (int i = 0; i < kTubeNodes; ++i) {
      const double s = 0.05 - rod.segment_m() * i;
      mouth.tube.position[i].z() += 0.008 * s * s / (0.05 * 0.05);
      mouth.tube.velocity[i] = Vec3(0.3, 0, -0.6) * s / 0.05;
    }
    mouth.tube.velocity[kTubeNodes - 1].setZero();
    const auto all = [&] {
      double sum = energy(rod, mouth.tube) + elastic_energy(scene->model, mouth.state.tissue);
      for (int i = 0; i < scene->model.nodes; ++i)
        sum += scene->model.mass[i] * mouth.state.tissue.velocity[i].squaredNorm() / 2;
      for (int i = 0; i < mouth.count; ++i) {  // springs that press
        const double depth = std::max(0.0, mouth.contacts[i].depth_m);
        sum += mouth.contacts[i].stiffness_n_m * depth * depth / 2;
      }
      return sum;
    };
    const double start = all();
    double most = start, pressed = 0.0;
    for (int n = 0; n < 600; ++n) {
      mouth.tick(hand);
      if (n > 0) most = std::max(most, all());
      pressed = std::max(pressed, mouth.load.tongue_n);
    }
    EXPECT_GT(pressed, 0.02);
    EXPECT_LE(most, 1.001 * start);
    EXPECT_LT(all(), 0.1 * start);
  }
}

// Drawn over the leaf, lower than its top by 4 mm, the tube folds it aside; behind the tube it stands up again.
TEST(SoftContacts, TheEpiglottisIsFoldedAsideAndComesBack) {
  const auto scene = build_scene(tongue_with_leaf());
  int top = 0;
  const auto height = [&](int i) {
    return scene->model.rest[i].z() - 0.01 * (scene->model.rest[i] - Vec3(0.015, 0.015, 0)).head<2>().norm();
  };
  for (int i = 0; i < scene->model.nodes; ++i)
    if (height(i) > height(top)) top = i;
  const Stylet stylet;
  const Rod rod = straight_tube(0.06, &stylet);
  for (double speed : {0.03, 0.2}) {
    const auto hand = [&](double t) { return along_y(std::min(0.032, 0.008 + speed * t), 0.065, 0.02245); };
    Mouth mouth(*scene, rod, hand(0));
    double folded = 0.0, load = 0.0, jump = 0.0;
    Vec3 before = Vec3::Zero();
    const int ticks = static_cast<int>(1000 * 0.024 / speed) + 800;
    for (int n = 0; n < ticks; ++n) {
      mouth.tick(hand(0.001 * n));
      folded = std::max(folded, mouth.state.tissue.displacement[top].x());
      load = std::max(load, mouth.load.epiglottis_n);
      jump = std::max(jump, (mouth.load.force_n - before).norm());
      before = mouth.load.force_n;
      for (int i = 0; i < mouth.count; ++i) {  // met from the side the tube comes from
        const Structure of =
            scene->description.soft.tet_structure[scene->surface.tet[mouth.soft.constraints[i].triangle]];
        if (of == Structure::epiglottis && mouth.contacts[i].force.norm() > 0 && n * 0.001 * speed < 0.006) {
          EXPECT_LT(mouth.contacts[i].normal.x(), 0.0) << n;
        }
      }
      ASSERT_EQ(mouth.load.tongue_n, 0.0);
    }
    EXPECT_GT(folded, 0.006) << speed;
    EXPECT_GT(load, 0.01) << speed;
    EXPECT_LT(jump, 1.0 * speed) << speed;
    EXPECT_EQ(mouth.count, 0);
    EXPECT_LT(mouth.state.tissue.displacement[top].norm(), 2e-5) << speed;
  }
}

}  // namespace
}  // namespace vallecula::engine
