// What moving one's own head and extending the infant's do to the view on a manikin under the expert's lift.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "engine/haptics/runner.h"
#include "engine/posture.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/device_choice.h"
#include "gui/session/hands_port.h"
#include "gui/session/package_parts.h"
#include "gui/session/scene_from_package.h"
#include "gui/session/scripted_hands.h"

namespace vallecula::gui::test {
namespace {

struct Seen {
  double best = 0.0, at_lift = 0.0, in_sight_s = -1.0;
  engine::Vec3 hyoid = engine::Vec3::Zero(), eye = engine::Vec3::Zero();
  double peak_n = 0.0;
};

Seen play(const pipeline::PatientPackage& package, const std::shared_ptr<const engine::Scene>& scene, std::uint32_t actions) {
  const curricula::Scenario scenario;
  const auto device = make_device("scripted:expert", {package, scenario, nullptr});
  device::GuardedDevice guard(*device, device::guard_for(device->info()));
  const device::ActionPlan plan(actions != 0 ? std::vector<device::TimedActions>{{0.0, actions}}
                                             : std::vector<device::TimedActions>{});
  const HandActions nobody;
  HandsPort port(guard, plan, nobody);
  engine::Runner runner(scene, port);
  Seen seen;
  while (seen.best < 2.0) {
    bool over = false;
    runner.run(10, [&](const engine::TickRecord& tick) {
      seen.best = std::max(seen.best, tick.glottis_visible);
      if (seen.in_sight_s < 0.0 && tick.glottis_visible >= 0.25) seen.in_sight_s = tick.time_s;
      if (tick.time_s < 11.0) seen.at_lift = tick.glottis_visible;
      seen.peak_n = std::max(seen.peak_n, tick.model_force_n.norm());
      over = tick.time_s > 11.4;
    });
    if (runner.latest().time_s < 10.9) {
      seen.hyoid = runner.latest().body_displacement[kHyoidBody];
      seen.eye = runner.latest().eye_offset_m;
    }
    if (over) break;
  }
  return seen;
}

pipeline::PatientPackage manikin() {
  const char* known = std::getenv("VALLECULA_PATIENT");
  return pipeline::read_package(known != nullptr ? known : builtin_patient({3.2, 1}));
}

TEST(WayToTheVallecula, IsFastAndComesToNoLimit) {
  if (std::getenv("VALLECULA_SLOW") == nullptr) GTEST_SKIP() << "imports a manikin; VALLECULA_SLOW=1 runs it";
  const pipeline::PatientPackage package = manikin();
  curricula::Scenario scenario;
  scenario.blade = "miller-1";
  const auto scene = engine::build_scene(scene_from_package(package, scenario));
  const auto device = make_device("scripted:expert", {package, scenario, nullptr});
  device::GuardedDevice guard(*device, device::guard_for(device->info()));
  HandsPort port(guard);
  port.lead_in(way_to_vallecula(package), 2400);
  engine::Runner runner(scene, port);
  double peak_n = 0.0, last_n = 0.0;
  runner.run(2400, [&](const engine::TickRecord& tick) {
    peak_n = std::max(peak_n, tick.model_force_n.norm());
    last_n = tick.model_force_n.norm();
    EXPECT_EQ(tick.state, engine::HapticState::tracking) << tick.time_s;
    EXPECT_EQ(tick.faults, 0u);
  });
  const engine::Vec3 vallecula = 1e-3 * landmark(package, "vallecula");
  const double off = (runner.latest().proxy_pose.position - vallecula).norm();
  std::printf("led to the vallecula: peak %.1f N, at its end %.1f N, %.1f mm from the landmark\n", peak_n, last_n, 1e3 * off);
  EXPECT_LT(peak_n, 5.0) << "less than the training target of a lift";
  EXPECT_LT(off, 0.008);
}

TEST(HeadExtension, OnTheManikin) {
  if (std::getenv("VALLECULA_SLOW") == nullptr) GTEST_SKIP() << "imports a manikin; VALLECULA_SLOW=1 runs it";
  const pipeline::PatientPackage package = manikin();
  curricula::Scenario scenario;
  scenario.blade = "miller-1";
  const auto scene = engine::build_scene(scene_from_package(package, scenario));
  const Seen still = play(package, scene, 0);
  const Seen extended = play(package, scene, engine::kActionExtend);
  EXPECT_LT(extended.hyoid.y(), still.hyoid.y()) << "the tongue's root is drawn forward";
  EXPECT_GT(extended.hyoid.z(), still.hyoid.z()) << "and up";
  EXPECT_GE(extended.at_lift, still.at_lift);
  for (const auto& [name, seen] :
       {std::pair<const char*, Seen>{"as it lies", still}, {"extended", extended},
        {"eye up", play(package, scene, engine::kActionEyeUp)}, {"eye down", play(package, scene, engine::kActionEyeDown)},
        {"eye right", play(package, scene, engine::kActionEyeRight)},
        {"eye left", play(package, scene, engine::kActionEyeLeft)}}) {
    std::printf("%-12s best %5.1f %%, in sight from %.2f s, lifted %5.1f %%, hyoid (%.1f %.1f %.1f) mm, peak %.1f N\n", name, 100 * seen.best,
                seen.in_sight_s, 100 * seen.at_lift, 1e3 * seen.hyoid.x(), 1e3 * seen.hyoid.y(), 1e3 * seen.hyoid.z(), seen.peak_n);
    EXPECT_LT(seen.hyoid.norm(), 0.02);
  }
}

}  // namespace
}  // namespace vallecula::gui::test
