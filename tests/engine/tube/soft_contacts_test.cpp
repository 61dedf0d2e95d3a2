// The tube against soft tissue. Forces are held against the blade's path of the engine (distance field, other
// contacts), which has its own truth from outside (static_truth_test.cpp); the rest are Newton's laws.
#include "engine/tube/soft_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/lab/experiment.h"
#include "engine/state.h"
#include "engine/tissue/elasticity.h"
#include "tests/engine/allocations.h"
#include "tests/engine/box_mesh.h"
#include "tests/engine/tube/rods.h"

namespace vallecula::engine {
namespace {

using namespace testing;

constexpr double kTop = 0.020;  // of the block, m

/// 40 x 40 x 20 mm, E 6000 Pa, fixed at its base; the blade far above it.
SceneDescription tongue_block(int cells = 16) {
  SceneDescription d = block_scene();
  d.soft = box_body(Vec3(0.04, 0.04, kTop), {cells, cells, cells / 2}, {6000.0, 0.45, 1040.0});
  d.tool.surface = box_surface(Vec3(0, 0, 0.5), Vec3(0.01, 0.01, 0.003));
  return d;
}

/// A block of tongue and, standing on it across x, a leaf of cartilage 9 mm wide and high, 1.5 mm thick.
SceneDescription tongue_with_leaf() {
  SceneDescription d = tongue_block();
  const SoftBodyDescription whole = box_body(Vec3(0.03, 0.03, 0.024), {20, 20, 16}, {6000.0, 0.45, 1040.0});
  SoftBodyDescription& soft = d.soft;
  soft = SoftBodyDescription{};
  soft.materials = {whole.materials[0], {200e3, 0.45, 1040.0}};
  soft.bodies = whole.bodies;
  std::vector<int> place(whole.nodes.size(), -1);
  for (const auto& tet : whole.tets) {
    const Vec3 at = (whole.nodes[tet[0]] + whole.nodes[tet[1]] + whole.nodes[tet[2]] + whole.nodes[tet[3]]) / 4;
    const bool leaf = at.z() > 0.015;
    if (leaf && (std::abs(at.x() - 0.01575) > 0.00075 || std::abs(at.y() - 0.015) > 0.0045)) continue;
    std::array<int, 4> corners;
    for (int k = 0; k < 4; ++k) {
      int& node = place[tet[k]];
      if (node < 0) {
        node = static_cast<int>(soft.nodes.size());
        soft.nodes.push_back(whole.nodes[tet[k]]);
        soft.node_anchor.push_back(whole.node_anchor[tet[k]]);
      }
      corners[k] = node;
    }
    soft.tets.push_back(corners);
    soft.tet_material.push_back(leaf ? 1 : 0);
    soft.tet_structure.push_back(leaf ? Structure::epiglottis : Structure::tongue);
  }
  return d;
}

/// Held `length` m from its tip, straight: the tests say where it lies by where the hand is.
Rod straight_tube(double length, const Stylet* stylet = nullptr) {
  RodDescription d = tube_rod(tube_design("3.5"), stylet, length);
  for (RodSection& s : d.section) s.natural_curvature_per_m = 0.0;
  return Rod(d);
}

/// So stiff that it is a rigid cylinder.
Rod rigid_tube(double radius) {
  RodDescription d = straight_rod(0.14);
  d.outer_radius_m = radius;
  for (RodSection& s : d.section) s = {100.0, 70.0, 0.0};
  return Rod(d);
}

/// The hand of a tube that points along -y, its axis through (x, z).
Pose along_y(double x, double hand_y, double z) {
  Pose hand;
  hand.position = Vec3(x, hand_y, z);
  hand.rotation = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ());
  return hand;
}

/// A scene with a tube in it, tick by tick.
struct Mouth {
  Mouth(const Scene& scene, const Rod& rod, const Pose& hand)
      : scene(scene), rod(rod), state(scene), soft(scene), tube(rod, hand), contacts(kMostSoftContacts) {}

  void tick(const Pose& hand) noexcept {
    count =
        find_soft_contacts(scene, state.tissue, rod, tube, outside_from_m, friction, soft, contacts.data(), capacity);
    on_hand = step(rod, tube, hand, contacts.data(), count, scene.model.step_s).on_hand;
    press_tissue(scene, tube, contacts.data(), soft);
    std::array<StructureLoad, kLoadedStructures> loads{};
    StageTimes times;
    step_tissue(scene, state, Pose{}, loads, times, &soft);
    load = soft_loads(scene, soft);
    on_tube.setZero();
    for (int i = 0; i < count; ++i) on_tube += contacts[i].force;
  }

  const Scene& scene;
  const Rod& rod;
  SceneState state;
  SoftContactState soft;
  RodState tube;
  std::vector<RodContact> contacts;
  double outside_from_m = 0.0, friction = 0.1;
  int capacity = kMostSoftContacts, count = 0;
  Wrench on_hand;
  SoftLoads load;
  Vec3 on_tube = Vec3::Zero();
};

/// From 0.5 mm above a depth of 0 to `depth` at `speed`, then still.
double down(double depth, double speed, double t) { return std::min(depth, speed * t - 0.0005); }

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

TEST(SoftContacts, WhatLiesInACanalMeetsNothing) {
  const auto scene = build_scene(tongue_block());
  const Rod rod = straight_tube(0.05);
  const double touching = kTop + rod.description().outer_radius_m - 0.0005;
  const double from = 0.0213;
  Mouth mouth(*scene, rod, along_y(0.02, 0.055, touching));
  mouth.outside_from_m = from;
  mouth.tick(along_y(0.02, 0.055, touching));
  ASSERT_GT(mouth.count, 3);
  for (int i = 0; i < mouth.count; ++i)
    EXPECT_GE((mouth.soft.found[i].segment + mouth.soft.found[i].weight) * rod.segment_m(), from - 1e-9);
  mouth.outside_from_m = 0.05;
  mouth.tick(along_y(0.02, 0.055, touching));
  EXPECT_EQ(mouth.count, 0);
  // It comes out of the canal where the tissue is: no blow, and in the end it is pressed as if it had always been
  // there.
  mouth.outside_from_m = 0.0;
  Mouth other(*scene, rod, along_y(0.02, 0.055, touching + 0.002));
  double jump = 0.0, before = 0.0;
  for (int n = 0; n < 600; ++n) {
    mouth.tick(along_y(0.02, 0.055, touching));
    other.tick(along_y(0.02, 0.055, touching + 0.002 - std::min(0.002, 0.02 * 0.001 * n)));
    jump = std::max(jump, std::abs(mouth.load.tongue_n - before));
    before = mouth.load.tongue_n;
  }
  EXPECT_GT(mouth.load.tongue_n, 0.01);
  EXPECT_LT(jump, 0.3 * mouth.load.tongue_n);
  EXPECT_NEAR(mouth.load.tongue_n, other.load.tongue_n, 0.05 * other.load.tongue_n);
}

TEST(SoftContacts, OfTooManyTheOnesThatPressAreKept) {
  const auto scene = build_scene(tongue_block());
  const Rod rod = straight_tube(0.05);
  const auto hand = [&](double t) {
    return along_y(0.02, 0.055, kTop + rod.description().outer_radius_m - down(0.003, 0.02, t));
  };
  Mouth mouth(*scene, rod, hand(0));
  mouth.capacity = 12;
  Vec3 low = Vec3::Constant(1e9), high = -low;
  int left_out = 0;
  for (int n = 0; n < 1000; ++n) {
    mouth.tick(hand(0.001 * n));
    ASSERT_LE(mouth.count, 12);
    for (int i = 1; i < mouth.count; ++i) ASSERT_LT(mouth.soft.found[i - 1].sphere, mouth.soft.found[i].sphere);
    left_out = std::max(left_out, mouth.soft.left_out);
    if (n < 700) continue;
    low = low.cwiseMin(mouth.load.force_n);
    high = high.cwiseMax(mouth.load.force_n);
  }
  EXPECT_GT(left_out, 3);
  EXPECT_GT(mouth.on_tube.z(), 0.05);
  EXPECT_LT((high - low).norm(), 0.1 * mouth.on_tube.z());
}

TEST(SoftContacts, EqualTicksAreEqualBitForBitAndAllocateNothing) {
  const auto scene = build_scene(tongue_with_leaf());
  const Stylet stylet;
  const Rod rod = straight_tube(0.06, &stylet);
  const auto hand = [&](double t) { return along_y(0.008 + 0.05 * t, 0.065, 0.0175 + 0.005 * std::cos(9 * t)); };
  Mouth one(*scene, rod, hand(0)), two(*scene, rod, hand(0));
  const long before = allocations;
  int most = 0;
  for (int n = 0; n < 400; ++n) {
    one.tick(hand(0.001 * n));
    most = std::max(most, one.count);
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_GT(most, 10);
  for (int n = 0; n < 400; ++n) two.tick(hand(0.001 * n));
  EXPECT_TRUE(same_bits(one.tube, two.tube));
  for (int i = 0; i < scene->model.nodes; ++i)
    ASSERT_EQ(one.state.tissue.displacement[i], two.state.tissue.displacement[i]) << i;
  EXPECT_EQ(one.load.force_n, two.load.force_n);
}

// A tube that touches nothing changes nothing for the blade, whatever the response.
TEST(SoftContacts, TheBladesContactsStayWhatTheyAre) {
  for (Response response : {Response::compliant, Response::projection, Response::penalty}) {
    SceneDescription d = tongue_block(10);
    d.tool.surface = box_surface(Vec3(0, 0, 0.0015), Vec3(0.014, 0.014, 0.003));
    d.response = response;
    const auto scene = build_scene(d);
    const Rod rod = straight_tube(0.05);
    RodState tube(rod, along_y(0.02, 0.055, 0.08));
    SceneState with(*scene), without(*scene);
    SoftContactState soft(*scene);
    std::vector<RodContact> contacts(kMostSoftContacts);
    Wrench last;
    for (int n = 0; n < 150; ++n) {
      Pose blade;
      blade.position = Vec3(0.02, 0.02, kTop + 0.001 - 2e-5 * n);
      for (SceneState* state : {&with, &without}) {
        const Pose before = state->proxy.pose;
        state->placed = true;
        state->proxy.pose = blade;
        std::array<StructureLoad, kLoadedStructures> loads{};
        StageTimes times;
        if (state == &with) {
          find_soft_contacts(*scene, with.tissue, rod, tube, 0.0, 0.1, soft, contacts.data(), kMostSoftContacts);
          press_tissue(*scene, tube, contacts.data(), soft);
        }
        step_tissue(*scene, *state, n == 0 ? blade : before, loads, times, state == &with ? &soft : nullptr);
      }
      ASSERT_EQ(with.tissue_wrench.force, without.tissue_wrench.force) << n;
    }
    EXPECT_GT(with.tissue_wrench.force.z(), 0.05);
  }
}

// Blade and tube press at once, some way apart: each is pressed back by itself.
TEST(SoftContacts, BladeAndTubePressAtOnceWhateverTheResponse) {
  for (Response response : {Response::compliant, Response::projection, Response::penalty}) {
    SceneDescription d = tongue_block(10);
    d.tool.surface = box_surface(Vec3(0, 0, 0.0015), Vec3(0.010, 0.010, 0.003));
    d.response = response;
    const auto scene = build_scene(d);
    const Rod rod = straight_tube(0.05);
    const auto hand = [&](double t) {
      return along_y(0.03, 0.055, kTop + rod.description().outer_radius_m - down(0.002, 0.02, t));
    };
    Mouth mouth(*scene, rod, hand(0));
    mouth.state.placed = true;
    for (int n = 0; n < 400; ++n) {
      Pose& blade = mouth.state.proxy.pose;
      blade.position = Vec3(0.01, 0.02, kTop - std::min(0.0005, 1e-5 * n));
      mouth.tick(hand(0.001 * n));
    }
    EXPECT_GT(mouth.state.tissue_wrench.force.z(), 0.01) << static_cast<int>(response);
    EXPECT_GT(mouth.on_tube.z(), 0.03) << static_cast<int>(response);
    EXPECT_LT((mouth.on_tube + mouth.load.force_n).norm(), 0.02 * mouth.on_tube.norm()) << static_cast<int>(response);
  }
}

TEST(SoftContacts, WhatIsNotFiniteIsLeftOut) {
  const auto scene = build_scene(tongue_block(10));
  const Rod rod = straight_tube(0.05);
  const Pose hand = along_y(0.02, 0.055, kTop + rod.description().outer_radius_m - 0.0005);
  Mouth mouth(*scene, rod, hand);
  for (int n = 0; n < 50; ++n) mouth.tick(hand);
  const double steady = mouth.load.tongue_n;
  EXPECT_GT(steady, 0.005);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  RodState lost = mouth.tube;
  lost.position[3].y() = nan;
  const auto found = [&](const TissueState& tissue, const RodState& tube, double from) {
    const int count =
        find_soft_contacts(*scene, tissue, rod, tube, from, 0.1, mouth.soft, mouth.contacts.data(), kMostSoftContacts);
    for (int i = 0; i < count; ++i) {
      EXPECT_TRUE(std::isfinite(mouth.contacts[i].depth_m));
      EXPECT_TRUE(mouth.contacts[i].normal.allFinite() && mouth.contacts[i].surface_velocity.allFinite());
    }
    return count;
  };
  EXPECT_EQ(found(mouth.state.tissue, lost, 0.0), 0);
  EXPECT_EQ(found(mouth.state.tissue, mouth.tube, nan), 0);
  TissueState torn = mouth.state.tissue;
  const int whole = found(torn, mouth.tube, 0.0);
  EXPECT_GT(whole, 0);
  const auto& face = scene->surface.triangles[mouth.soft.constraints[0].triangle];
  for (int v : face) torn.displacement[v].x() = nan;
  const int rest = found(torn, mouth.tube, 0.0);
  EXPECT_LT(rest, whole);
  torn.fastest_m = nan;
  EXPECT_EQ(found(torn, mouth.tube, 0.0), 0);
  for (int n = 0; n < 200; ++n) mouth.tick(hand);
  EXPECT_NEAR(mouth.load.tongue_n, steady, 0.1 * steady);
}

}  // namespace
}  // namespace vallecula::engine
