// A tube that is led beside the mouth does not go in: face and neck stop it, and it is not told as one in the mouth.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "curricula/trial_log.h"
#include "device/drivers/scripted_device.h"
#include "engine/mesh/triangle_bvh.h"
#include "engine/state.h"
#include "gui/commands/headless_application.h"
#include "gui/session/device_choice.h"
#include "gui/session/intubation_of.h"
#include "gui/session/package_parts.h"
#include "gui/session/scene_from_package.h"
#include "gui/session/scripted_pairs.h"
#include "gui/session/trial_session.h"
#include "gui/session/user_paths.h"
#include "tests/gui/coarse_infant.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

using engine::Vec3;

constexpr double kSetsOut_s = 10.0, kAtInlet_s = 13.2;  // of the planned pair's tube (scripted_pairs.cpp)

class TubeBesideMouth : public ::testing::Test {
 protected:
  TubeBesideMouth() { ::setenv("VALLECULA_HOME", box_.home().c_str(), 1); }

  /// The expert's tube as far as the inlet, all of it moved to the patient's right by `aside_m`; the blade stays
  /// outside.
  curricula::TrialLog run(double aside_m, const std::string& out) {
    TrialSetup setup;
    setup.patient = coarse_infant();
    setup.curriculum = curricula_folder() / "first-intubation.yaml";
    const curricula::Scenario scenario = curricula::load_curriculum(setup.curriculum).scenarios.front();
    setup.scenario = scenario.id;
    setup.out = box_ / out;
    setup.realtime = false;
    const pipeline::PatientPackage package = pipeline::read_package(setup.patient);
    const engine::IntubationDescription intubation = intubation_of(package, scenario);
    half_width_m_ = intubation.mouth_half_width_m;
    const ScriptedPair pair = scripted_pair("expert", package, scenario, intubation);
    std::vector<device::Keyframe> tube;
    for (device::Keyframe key : pair.tube.keyframes()) {
      if (key.time_s < kSetsOut_s || key.time_s > kAtInlet_s + 1e-9) continue;
      key.time_s -= kSetsOut_s;
      key.position_m[0] -= aside_m;
      tube.push_back(key);
    }
    device::Keyframe blade = starting_pose(package, scenario), last = blade;
    last.time_s = blade.time_s + kAtInlet_s - kSetsOut_s;
    setup.own_device = [blade, last] {
      return std::make_unique<device::ScriptedDevice>(device::Trajectory({blade, last}), device::firm_hand());
    };
    setup.own_second_device = [tube] {
      return std::make_unique<device::ScriptedDevice>(device::Trajectory(tube), device::firm_hand());
    };
    TrialSession session(setup);
    session.start();
    while (!session.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return curricula::read_trial_log(session.finish("finished").log);
  }

  HeadlessApplication application_;
  Sandbox box_;
  double half_width_m_ = 0.0;
};

TEST_F(TubeBesideMouth, IsOutsideWhereItSlidesAlongTheCheekBehindTheMouthsFront) {
  const curricula::TrialLog by_mouth = run(0.0, "by-mouth"), by_cheek = run(0.015, "by-cheek");
  // The lips of a term infant end 16 to 20 mm from the middle: the manikin's corners lie 15 mm from it, with the red
  // about.
  EXPECT_GT(half_width_m_, 0.014);
  EXPECT_LT(half_width_m_, 0.021);
  const auto mouth = curricula::mouth_from_landmarks(by_mouth.header.landmarks_m);
  ASSERT_TRUE(mouth);
  std::printf("half the lips' width: %.1f mm\n", 1e3 * half_width_m_);
  const pipeline::PatientPackage package = pipeline::read_package(coarse_infant());
  const engine::TriangleBvh drawn(mesh_of(surface(package, "face"), kMetres));
  struct Seen {
    double beneath_skin_m = 0.0, deepest_m = -1.0, in_cylinder_s = 0.0, mark_m = 0.0, most_n = 0.0;
    int in_mouth = 0;
  };
  const auto seen = [&](const curricula::TrialLog& log) {
    Seen all;
    for (const curricula::LogTick& tick : log.ticks) {
      const auto& tip = tick.intubation.tip_m;
      double deep_m = 0.0, force_n = 0.0;
      for (std::size_t a = 0; a < 3; ++a) {
        deep_m += mouth->inward[a] * (tip[a] - mouth->gum_middle_m[a]);
        force_n += tick.intubation.model_force_n[a] * tick.intubation.model_force_n[a];
      }
      all.deepest_m = std::max(all.deepest_m, deep_m);
      all.beneath_skin_m = std::max(all.beneath_skin_m, -drawn.signed_distance(Vec3(tip[0], tip[1], tip[2]), 0.05));
      all.in_cylinder_s += mouth->holds(tip) ? log.header.servo_period_s : 0.0;
      all.mark_m = std::max(all.mark_m, tick.intubation.at_mouth_m);
      all.most_n = std::max(all.most_n, std::sqrt(force_n));
      all.in_mouth += tick.intubation.place != curricula::LoggedPlace::outside;
    }
    return all;
  };
  const Seen mouth_way = seen(by_mouth), cheek_way = seen(by_cheek);
  for (const auto& [name, way] : {std::pair{"by the mouth", mouth_way}, {"by the cheek", cheek_way}})
    std::printf(
        "%s: tip %.1f mm behind the front at most, %.2f s where a mouth's radius would have it, mark %.1f mm, "
        "%.2f N\n",
        name, 1e3 * way.deepest_m, way.in_cylinder_s, 1e3 * way.mark_m, way.most_n);
  EXPECT_GT(mouth_way.in_mouth, 500);
  EXPECT_GT(mouth_way.mark_m, 0.02);
  EXPECT_GT(cheek_way.deepest_m, 0.005) << "else this shows nothing";
  EXPECT_GT(cheek_way.in_cylinder_s, 0.05) << "where it would have been taken for one in the mouth";
  EXPECT_LT(cheek_way.beneath_skin_m, 0.002) << "the cheek stops it";
  EXPECT_EQ(cheek_way.in_mouth, 0) << "no tick in the mouth or beyond";
  EXPECT_EQ(cheek_way.mark_m, 0.0) << "no mark at the lips";
}

/// A tube with its stylet, its tip along the skin's normal, pushed 22 mm into the head by a hand that feels nothing.
TEST_F(TubeBesideMouth, FaceAndNeckStopItAndLetItSlide) {
  const pipeline::PatientPackage package = pipeline::read_package(coarse_infant());
  const curricula::Scenario scenario =
      curricula::load_curriculum(curricula_folder() / "first-intubation.yaml").scenarios.front();
  const engine::SceneDescription description = scene_from_package(package, scenario);
  const auto scene = engine::build_scene(description);
  const engine::TriangleBvh drawn(description.rigid.surface);  // the very triangles that the window draws
  const engine::Intubation& in = *scene->intubation;
  const engine::Rod& rod = in.rod(engine::InHand::tube_with_stylet);
  const engine::RodState hanging(rod, engine::Pose{});
  const device::Keyframe start = starting_pose(package, scenario);
  engine::StepInput input;
  input.device.position = Vec3(start.position_m[0], start.position_m[1], start.position_m[2]);
  struct Site {
    const char* name;
    Vec3 from, towards;  // mm
  };
  for (const Site& site :
       {Site{"cheek", {-200, 20, -15}, {1, 0, 0}}, Site{"forehead", {0, -100, 55}, {0, 1, 0}},
        Site{"neck in front", {0, -100, -75}, {0, 1, 0}}, Site{"neck at the side", {-200, 30, -70}, {1, 0, 0}}}) {
    Vec3 at = kMetres * site.from;
    while (drawn.signed_distance(at, 0.02) > 2e-5) at += 1e-5 * site.towards;
    const Vec3 normal = drawn.triangle_normal(drawn.closest(at, 0.001).triangle);
    ASSERT_FALSE(scene->rigid.covers(at)) << site.name << ": else it is the mouth's own field that stops it";
    engine::SceneState state(*scene);
    input.second.rotation = engine::Quat::FromTwoVectors(-(hanging.rotation[0] * Vec3::UnitX()), -normal);
    double deepest_m = 0.0, most_n = 0.0, airway_n = 0.0, aside_m = 0.0;
    int in_mouth = 0;
    for (int tick = 0; tick < 1500; ++tick) {
      const double out_m = 0.008 - 2e-5 * tick;
      input.second.position = at + out_m * normal - input.second.rotation * hanging.position[0];
      const engine::IntubationRecord r = engine::step(*scene, state, input).intubation;
      for (int i = 0; i < engine::kTubeNodes; ++i)
        deepest_m = std::max(deepest_m, -drawn.signed_distance(state.intubation->rod.position[i], 0.03));
      most_n = std::max(most_n, r.model_force_n.norm());
      for (const double load : r.loads_n) airway_n = std::max(airway_n, load);
      in_mouth += r.place != engine::TipPlace::outside;
      const Vec3 way = r.tip_m - at;
      aside_m = (way - way.dot(normal) * normal).norm();
    }
    std::printf("%s: the axis %.2f mm beneath the skin at most, %.2f N at most, the tip %.1f mm aside at the end\n",
                site.name, 1e3 * deepest_m, most_n, 1e3 * aside_m);
    EXPECT_LT(deepest_m, 0.002) << site.name;
    EXPECT_GT(most_n, 0.1) << site.name << ": the hand feels it";
    EXPECT_LT(most_n, description.intubation->device_limit_n) << site.name;
    EXPECT_GT(aside_m, 0.005) << site.name << ": it slides along";
    EXPECT_EQ(airway_n, 0.0) << site.name << ": no part of the airway is touched";
    EXPECT_EQ(in_mouth, 0) << site.name;
  }
}

}  // namespace
}  // namespace vallecula::gui::test
