// The whole step: forces at rest against an independent static solution, the limit, faults of the device, replay.
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "engine/haptics/runner.h"
#include "engine/haptics/servo.h"
#include "engine/state.h"
#include "engine/tissue/implicit_step.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

/// Steps the tissue under a plate held at `depth` below the block's top until it rests; the force along z, N.
double resting_force(double young, double poisson, double depth, std::array<int, 3> cells) {
  SceneDescription d = testing::block_scene(young, poisson);
  d.soft = testing::box_body(Vec3(0.03, 0.03, 0.015), cells, {young, poisson, 1040.0});
  const auto scene = build_scene(d);
  SceneState state(*scene);
  Pose before;
  before.position = Vec3(0.015, 0.015, 0.016);
  double force = 0.0, sum = 0.0;
  StageTimes times;
  constexpr int kSteps = 900, kAveraged = 100;
  for (int n = 0; n < kSteps; ++n) {
    Pose tool = before;
    tool.position.z() = 0.015 - depth * std::min(1.0, n / 200.0);
    find_contacts(scene->tree, scene->surface, scene->description.soft.tets, scene->model, state.tissue, scene->tool, tool, before,
                  scene->contact_stiffness, 0.0f, state.contacts);
    implicit_step(scene->model, state.tissue, state.contacts.constraints.data(), state.contacts.count, times);
    keep_multipliers(tool, state.contacts);
    before = tool;
    force = 0.0;
    for (int c = 0; c < state.contacts.count; ++c)
      force += state.contacts.constraints[c].multiplier * -state.contacts.constraints[c].normal[2];
    if (n >= kSteps - kAveraged) sum += force / kAveraged;
  }
  return sum;
}

// scikit-fem, quadratic hexahedra (tests/truth/static_block.py): N per m of a frictionless plate on a bonded block
// 30 x 30 x 15 mm, E 6000 Pa. The tolerance is for linear tetrahedra of 3 mm and for a press of 0.3 mm being finite.
TEST(StaticTruth, PlateOnBlockMatchesIndependentSolution) {
  struct Case {
    double poisson, slope_n_m;
  };
  for (const Case& c : {Case{0.3, 384.0}, Case{0.45, 428.7}, Case{0.49, 455.1}}) {
    const double depth = 0.0003;
    const double force = resting_force(6000.0, c.poisson, depth, {10, 10, 5});
    EXPECT_NEAR(force / depth, c.slope_n_m, 0.06 * c.slope_n_m) << "nu " << c.poisson;
  }
}

// A finer mesh comes closer to the independent solution: what is left is discretisation, not a wrong law.
TEST(StaticTruth, RefinementConverges) {
  const double depth = 0.0003, truth = 428.7;
  const double coarse = std::abs(resting_force(6000.0, 0.45, depth, {6, 6, 3}) / depth - truth);
  const double fine = std::abs(resting_force(6000.0, 0.45, depth, {14, 14, 7}) / depth - truth);
  EXPECT_LT(fine, coarse);
}

/// A hand that follows a height over the block's centre, for the whole engine with coupling and servo.
class HeightPort final : public HapticPort {
 public:
  explicit HeightPort(double (*height)(double)) : height_(height) {}
  PortInput read(double t) noexcept override {
    PortInput in;
    in.pose.position = Vec3(0.015, 0.015, height_(t));
    in.valid = valid;
    if (poison) in.pose.position.x() = std::numeric_limits<double>::quiet_NaN();
    return in;
  }
  void write(const Vec3& force) noexcept override { last = force; }
  bool valid = true, poison = false;
  Vec3 last = Vec3::Zero();

 private:
  double (*height_)(double);
};

double press_and_return(double t) {
  const double depth = t < 0.5 ? 0.005 * t / 0.5 : t < 1.0 ? 0.005 : t < 1.3 ? 0.005 * (1.3 - t) / 0.3 : -0.002;
  return 0.0155 - depth;
}

// Far in at 100 mm/s, holds, comes back.
double overshoot(double t) {
  const double depth = t < 0.3 ? 0.1 * t : t < 1.2 ? 0.030 : t < 1.5 ? 0.030 - (t - 1.2) * 0.14 : -0.012;
  return 0.0155 - depth;
}

/// A slender upright leaf of cartilage on a block of muscle, pushed at its top and let go.
double leaf_speed_after(bool coarse_space) {
  SoftBodyDescription soft = testing::box_body(Vec3(0.020, 0.010, 0.020), {10, 5, 10}, {6000.0, 0.45, 1040.0});
  soft.materials.push_back({200e3, 0.45, 1040.0});
  SoftBodyDescription leaf = soft;
  leaf.tets.clear();
  leaf.tet_material.clear();
  for (const auto& t : soft.tets) {
    const Vec3 c = (soft.nodes[t[0]] + soft.nodes[t[1]] + soft.nodes[t[2]] + soft.nodes[t[3]]) / 4;
    const bool in_leaf = c.x() > 0.008 && c.x() < 0.010;
    if (c.z() > 0.006 && !in_leaf) continue;  // above the block only the leaf is left
    leaf.tets.push_back(t);
    leaf.tet_material.push_back(c.z() > 0.006 ? 1 : 0);
  }
  std::vector<int> renamed(soft.nodes.size(), -1);
  leaf.nodes.clear();
  leaf.node_anchor.clear();
  for (auto& t : leaf.tets)
    for (int& v : t) {
      if (renamed[v] < 0) {
        renamed[v] = static_cast<int>(leaf.nodes.size());
        leaf.nodes.push_back(soft.nodes[v]);
        leaf.node_anchor.push_back(soft.node_anchor[v]);
      }
      v = renamed[v];
    }
  leaf.tet_structure.assign(leaf.tets.size(), Structure::epiglottis);
  TissueModel model(leaf, 0.001);
  EXPECT_GT(model.coarse_groups, 0);
  if (!coarse_space) model.coarse_groups = 0;
  TissueState state(model);
  StageTimes times;
  for (int n = 0; n < 600; ++n) {
    for (int i = 0; i < model.nodes; ++i)
      if (n < 100 && model.rest[i].z() > 0.0199) state.external[i].v = F4{2e-3f, 0, 0, 0};
    implicit_step(model, state, nullptr, 0, times);
  }
  double fastest = 0.0;
  for (const Vec3& v : state.velocity) fastest = std::max(fastest, v.norm());
  return fastest;
}

// The preconditioner's second level: without it the leaf still swings on the momentum of unfinished solves.
TEST(CoarseSpace, CartilageOnMuscleComesToRest) {
  const double with = leaf_speed_after(true), without = leaf_speed_after(false);
  EXPECT_LT(with, 0.2 * without);
}

TEST(Scene, DisplayedForceFollowsModelForceAtRest) {
  const auto scene = build_scene(testing::block_scene());
  HeightPort port(press_and_return);
  Runner runner(scene, port);
  TickRecord held;
  runner.run(1000, [&](const TickRecord& r) { held = r; });
  EXPECT_NEAR(held.displayed_force_n.z(), held.model_force_n.z(), 0.03 * held.model_force_n.z());
  EXPECT_EQ(held.state, HapticState::tracking);
}

TEST(Scene, OverTheLimitTheDeviceIsClampedAndTheTissueReturns) {
  const auto scene = build_scene(testing::block_scene(20000.0));  // the limit is reached at a third of its thickness
  HeightPort port(overshoot);
  Runner runner(scene, port);
  bool limited = false, lost = false;
  int transitions = 0;
  HapticState before = HapticState::tracking;
  double shown = 0.0, change = 0.0, deepest = 1.0;
  Vec3 last = Vec3::Zero();
  TickRecord end;
  runner.run(4000, [&](const TickRecord& r) {
    limited |= r.state == HapticState::limited;
    lost |= r.state == HapticState::lost;
    transitions += r.state != before ? 1 : 0;
    before = r.state;
    shown = std::max(shown, r.displayed_force_n.norm());
    change = std::max(change, (r.displayed_force_n - last).norm());
    last = r.displayed_force_n;
    if (r.state == HapticState::limited) deepest = std::min(deepest, r.proxy_pose.position.z());
    end = r;
  });
  const HapticSettings& settings = scene->description.haptics;
  EXPECT_TRUE(limited);
  EXPECT_LE(transitions, 6);  // in, lost, back, done, and once more on the way: the limit does not flutter
  EXPECT_TRUE(lost);  // held for 0.9 s, longer than the limit's time
  EXPECT_LE(shown, settings.device_limit_n * (1 + 1e-9));
  EXPECT_LE(change, settings.force_rate_n_s * 0.001 * (1 + 1e-9));
  EXPECT_GT(deepest, 0.006);  // the proxy stayed while the hand went 15 mm beneath the block
  EXPECT_EQ(end.state, HapticState::tracking);
  double residual = 0.0;
  const auto& points = runner.latest().soft_points;
  for (int i = 0; i < scene->model.nodes; ++i)
    for (int a = 0; a < 3; ++a) residual = std::max(residual, std::abs(points[3 * i + a] - scene->model.rest[i][a]));
  EXPECT_LT(residual, 1e-4);
}

TEST(Scene, NonFinitePoseMeansZeroForceAndANamedFault) {
  const auto scene = build_scene(testing::block_scene());
  HeightPort port(press_and_return);
  Runner runner(scene, port);
  runner.run(800, [](const TickRecord&) {});
  EXPECT_GT(port.last.norm(), 0.3);
  port.poison = true;
  runner.run(20, [&](const TickRecord& r) {
    EXPECT_NE(r.faults & kFaultDevicePose, 0u);
    EXPECT_EQ(r.displayed_force_n.norm(), 0.0);
    EXPECT_EQ(r.state, HapticState::lost);
  });
  // What led to the fault is kept: the tick it came in and the 49 before.
  const std::vector<TickRecord> led = runner.ticks_before_fault();
  ASSERT_EQ(led.size(), 50u);
  EXPECT_EQ(led.back().tick, 800);
  EXPECT_NE(led.back().faults & kFaultDevicePose, 0u);
  EXPECT_EQ(led.front().tick, 751);
  EXPECT_EQ(led.front().faults, 0u);
  port.poison = false;
  TickRecord end;
  runner.run(2000, [&](const TickRecord& r) {
    ASSERT_TRUE(r.model_force_n.allFinite());
    end = r;
  });
  EXPECT_EQ(end.state, HapticState::tracking);
}

TEST(Servo, AForceThatIsNotFiniteIsNamedAndNotSent) {
  const auto scene = build_scene(testing::block_scene());
  PortInput in;
  in.pose.position = Vec3(0.015, 0.015, 0.012);
  StepResult good;
  good.step = 0;
  good.coupling.hand.device = in.pose;
  good.coupling.proxy.pull.force = Vec3(0, 0, -0.6);
  ServoState servo;
  const TickRecord fine = servo_tick(*scene, 0, in, 0, good, false, servo);
  EXPECT_EQ(fine.faults, kFaultNone);
  EXPECT_GT(fine.displayed_force_n.norm(), 0.1);
  for (const bool in_pose : {true, false}) {
    StepResult bad = good;
    (in_pose ? bad.coupling.proxy.pose.position : bad.model_force_n).y() = std::numeric_limits<double>::quiet_NaN();
    const TickRecord record = servo_tick(*scene, 1, in, 1, bad, false, servo);
    EXPECT_NE(record.faults & kFaultForce, 0u);
    EXPECT_EQ(record.displayed_force_n.norm(), 0.0);
  }
}

TEST(Scene, AnUnpluggedDeviceGetsNoForceAtOnce) {
  const auto scene = build_scene(testing::block_scene());
  HeightPort port(press_and_return);
  Runner runner(scene, port);
  runner.run(800, [](const TickRecord&) {});
  port.valid = false;
  runner.run(1, [](const TickRecord& r) { EXPECT_EQ(r.displayed_force_n.norm(), 0.0); });
}

TEST(Scene, RigidAnatomyStopsTheBlade) {
  SceneDescription d = testing::block_scene();
  d.rigid.surface = testing::box_surface(Vec3(0.015, 0.015, 0.010), Vec3(0.01, 0.01, 0.014));  // top at 17 mm
  d.rigid.triangle_structure.assign(d.rigid.surface.triangles.size(), Structure::gum);
  const auto scene = build_scene(d);
  HeightPort port([](double t) { return 0.020 - 0.005 * std::min(1.0, t); });
  Runner runner(scene, port);
  TickRecord end;
  runner.run(1500, [&](const TickRecord& r) { end = r; });
  // The hand is 2 mm inside; the coupling's pull is what the gum bears.
  EXPECT_NEAR(end.proxy_pose.position.z(), 0.017, 0.0003);
  EXPECT_NEAR(end.loads[static_cast<int>(Structure::gum)].force_n.z(), scene->proxy.stiffness_n_m * 0.002, 0.3);
  EXPECT_LT(end.loads[static_cast<int>(Structure::tongue)].force_n.norm(), 0.01);
}

/// A plate of 14 mm with sharp edges, smaller than the block of 30 mm under it.
SceneDescription small_plate_scene() {
  SceneDescription d = testing::block_scene();
  d.tool.surface = testing::box_surface(Vec3(0, 0, 0.0015), Vec3(0.014, 0.014, 0.003));
  return d;
}

// What a tick can change is what moved in it: 0.01 mm of press on tissue of about 400 N/m, and as much again of waves.
// A contact that lost its side at an edge used to answer with a blow of several newtons.
TEST(Scene, PressAndWithdrawChangeTheForceByWhatMoved) {
  const auto scene = build_scene(small_plate_scene());
  HeightPort port(press_and_return);
  Runner runner(scene, port);
  double change = 0.0, pressed = 0.0, withdrawn = 0.0;
  Vec3 last = Vec3::Zero();
  runner.run(1500, [&](const TickRecord& r) {
    change = std::max(change, (r.model_force_n - last).norm());
    last = r.model_force_n;
    (r.time_s < 1.0 ? pressed : withdrawn) = std::max(r.time_s < 1.0 ? pressed : withdrawn, last.norm());
  });
  EXPECT_GT(pressed, 0.5);
  EXPECT_LE(withdrawn, pressed * 1.02);
  EXPECT_LT(change, 0.05);
  EXPECT_LT(last.norm(), 1e-3);
}

// A blade wedged between tissue and rigid anatomy rests. Taken as a mere load of the last tick, the tissue's force made it
// chatter by 2 N from tick to tick.
TEST(Scene, ABladeWedgedBetweenTissueAndGumRests) {
  SceneDescription d = testing::block_scene();
  d.rigid.surface = testing::box_surface(Vec3(0.015, 0.015, 0.017), Vec3(0.02, 0.02, 0.004));  // its lower face at 15 mm
  d.rigid.triangle_structure.assign(d.rigid.surface.triangles.size(), Structure::gum);
  const auto scene = build_scene(d);
  // The plate, 3 mm thick, is held between the gum above and the tissue it has pressed by 3 mm below.
  HeightPort port([](double t) { return t < 0.3 ? 0.0117 - 0.001 * t : 0.0117 + 0.0015 * std::min(1.0, (t - 0.3) / 0.3); });
  Runner runner(scene, port);
  double change = 0.0;
  Vec3 tongue = Vec3::Zero(), gum = Vec3::Zero();
  runner.run(1500, [&](const TickRecord& r) {
    const Vec3 t = r.loads[static_cast<int>(Structure::tongue)].force_n, g = r.loads[static_cast<int>(Structure::gum)].force_n;
    if (r.time_s > 0.8) change = std::max({change, (t - tongue).norm(), (g - gum).norm()});
    tongue = t;
    gum = g;
  });
  EXPECT_GT(tongue.z(), 0.3);
  EXPECT_LT(gum.z(), -0.3);
  EXPECT_LT(change, 0.02);
}

TEST(Scene, RealTimeRunKeepsEveryRecordInOrder) {
  const auto scene = build_scene(testing::block_scene());
  HeightPort port(press_and_return);
  Runner runner(scene, port);
  Replayer replayer(scene);
  runner.start();
  TickRecord r;
  std::int64_t next = 0;
  while (next < 600) {
    if (!runner.pop(r)) {
      timespec nap{0, 2'000'000};
      nanosleep(&nap, nullptr);
      continue;
    }
    ASSERT_EQ(r.tick, next++);
    const TickRecord again = replayer.replay(r);
    ASSERT_EQ(std::memcmp(r.displayed_force_n.data(), again.displayed_force_n.data(), 24), 0) << r.tick;
    ASSERT_EQ(r.model_force_n, again.model_force_n) << r.tick;
  }
  runner.stop();
  EXPECT_GE(runner.timing().ticks, 600);
}

}  // namespace
}  // namespace vallecula::engine
