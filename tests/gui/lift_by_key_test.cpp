// The lift of mouse and keyboard from where the blade stands after F (the vallecula): the key alone brings the view.
#include <gtest/gtest.h>

#include <algorithm>

#include "curricula/scenario.h"
#include "device/drivers/mouse_device.h"
#include "engine/state.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/scene_from_package.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {
namespace {

engine::Pose pose_of(const std::array<double, 3>& p, const std::array<double, 4>& q) {
  return {engine::Vec3(p[0], p[1], p[2]), engine::Quat(q[0], q[1], q[2], q[3])};
}

// Held until the view is there, and then still for as long as anybody would: the blade stays in the hand and in the
// vallecula, and the forces that decide stay below their limits when the view comes.
TEST(LiftByKey, FromTheValleculaToAViewWithoutTheDevicesLimit) {
  constexpr double kHeldS = 2.5, kFrameS = 0.1;  // a slow machine's frames: what is felt comes late
  const curricula::Curriculum course = curricula::load_curriculum(default_curriculum());
  const curricula::Scenario& scenario = course.scenarios.front();
  const pipeline::PatientPackage package = pipeline::read_package(builtin_patient(scenario.manikin));
  const auto scene = engine::build_scene(scene_from_package(package, scenario));
  engine::SceneState state(*scene);
  const double step_s = scene->model.step_s;
  const device::Trajectory way = way_to_vallecula(package);
  engine::StepInput input;
  for (double t = way.start_s(); t < way.end_s(); t += step_s) {
    const device::Keyframe key = way.at(t);
    input.device = pose_of(key.position_m, key.rotation_wxyz);
    engine::step(*scene, state, input);
  }
  device::MouseDevice mouse;
  const device::Keyframe there = way.at(way.end_s());
  mouse.place(there.position_m, there.rotation_wxyz);
  mouse.set_lift(1.0);
  const auto load = [](const engine::StepResult& now, engine::Structure structure) {
    return now.loads[static_cast<std::size_t>(structure)].force_n.norm();
  };
  double best = 0.0, most_n = 0.0, frame_s = 0.0, gum_n = -1.0, tongue_n = 0.0;
  for (double t = 0.0; t < kHeldS; t += step_s) {
    const device::DeviceReading hand = mouse.read(t);
    input.device = pose_of(hand.position_m, hand.rotation_wxyz);
    const engine::StepResult now = engine::step(*scene, state, input);
    ASSERT_EQ(now.limit.state, engine::HapticState::tracking) << "at " << t << " s, " << 1e3 * mouse.lift_m() << " mm";
    best = std::max(best, now.glottis_visible);
    most_n = std::max(most_n, now.model_force_n.norm());
    if (gum_n < 0.0) tongue_n = std::max(tongue_n, load(now, engine::Structure::tongue));
    if (gum_n < 0.0 && 100.0 * now.glottis_visible >= scenario.pass.glottis_visible_percent)
      gum_n = load(now, engine::Structure::gum);
    if (t < frame_s) continue;
    frame_s += kFrameS;
    mouse.feel(now.model_force_n.norm(), scene->description.haptics.device_limit_n);
  }
  RecordProperty("most_force_mn", static_cast<int>(1e3 * most_n));
  RecordProperty("best_view_percent", static_cast<int>(100 * best));
  ASSERT_GE(gum_n, 0.0) << "the glottis was seen at most to " << 100 * best << " %";
  EXPECT_LT(gum_n, scenario.targets.gum_force_n);
  EXPECT_LT(tongue_n, scenario.targets.tongue_force_n);
  EXPECT_LT(most_n, 0.9 * scene->description.haptics.device_limit_n);
  EXPECT_GT(best, 0.7);

  // A pause in the lift: the tissue moves the blade on. The mouse takes hold where it is then, and the key lifts again.
  const double paused_s = kHeldS + 2.0;
  double t = kHeldS;
  mouse.set_lift(0.0);
  engine::StepResult now;
  for (input.valid = false; t < paused_s; t += step_s) now = engine::step(*scene, state, input);
  const engine::Quat& q = now.proxy_pose.rotation;
  const engine::Vec3& at = now.proxy_pose.position;
  mouse.place({at.x(), at.y(), at.z()}, {q.w(), q.x(), q.y(), q.z()});
  for (input.valid = true; t < paused_s + 1.5; t += step_s) {
    const device::DeviceReading hand = mouse.read(t);
    input.device = pose_of(hand.position_m, hand.rotation_wxyz);
    now = engine::step(*scene, state, input);
    ASSERT_NE(now.limit.state, engine::HapticState::limited) << "at " << t - paused_s << " s after the pause";
  }
  EXPECT_EQ(now.limit.state, engine::HapticState::tracking);
}

}  // namespace
}  // namespace vallecula::gui
