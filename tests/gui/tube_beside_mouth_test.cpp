// A tube that goes in beside the mouth, through the cheek, is not told as one in the mouth.
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
#include "gui/commands/headless_application.h"
#include "gui/session/device_choice.h"
#include "gui/session/intubation_of.h"
#include "gui/session/package_parts.h"
#include "gui/session/scripted_pairs.h"
#include "gui/session/trial_session.h"
#include "gui/session/user_paths.h"
#include "tests/gui/coarse_infant.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

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

TEST_F(TubeBesideMouth, IsOutsideHoweverDeepItIsInTheCheek) {
  const curricula::TrialLog by_mouth = run(0.0, "by-mouth"), by_cheek = run(0.015, "by-cheek");
  // The lips of a term infant end 16 to 20 mm from the middle: the manikin's corners lie 15 mm from it, with the red
  // about.
  EXPECT_GT(half_width_m_, 0.014);
  EXPECT_LT(half_width_m_, 0.021);
  const auto mouth = curricula::mouth_from_landmarks(by_mouth.header.landmarks_m);
  ASSERT_TRUE(mouth);
  std::printf("half the lips' width: %.1f mm\n", 1e3 * half_width_m_);
  struct Seen {
    double deepest_m = -1.0, in_cylinder_s = 0.0, mark_m = 0.0, most_n = 0.0;
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
  EXPECT_EQ(cheek_way.in_mouth, 0) << "no tick in the mouth or beyond";
  EXPECT_EQ(cheek_way.mark_m, 0.0) << "no mark at the lips";
}

}  // namespace
}  // namespace vallecula::gui::test
