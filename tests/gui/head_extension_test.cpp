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
#include "gui/session/scene_from_package.h"

namespace vallecula::gui::test {
namespace {

struct Seen {
  double best = 0.0, at_lift = 0.0;
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

TEST(HeadExtension, OnTheManikin) {
  if (std::getenv("VALLECULA_SLOW") == nullptr) GTEST_SKIP() << "imports a manikin; VALLECULA_SLOW=1 runs it";
  const char* known = std::getenv("VALLECULA_PATIENT");
  const pipeline::PatientPackage package =
      pipeline::read_package(known != nullptr ? known : builtin_patient({3.2, 1}));
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
    std::printf("%-12s best %5.1f %%, lifted %5.1f %%, hyoid (%.1f %.1f %.1f) mm, peak %.1f N\n", name, 100 * seen.best,
                100 * seen.at_lift, 1e3 * seen.hyoid.x(), 1e3 * seen.hyoid.y(), 1e3 * seen.hyoid.z(), seen.peak_n);
    EXPECT_LT(seen.hyoid.norm(), 0.02);
  }
}

}  // namespace
}  // namespace vallecula::gui::test
