// A real adult CT from series to verified trial: closed mouth, no view, but a tongue to press on.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "curricula/trial_log.h"
#include "gui/session/airway_course.h"
#include "gui/session/scripted_hands.h"
#include "pipeline/package/patient_package.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

fs::path series() {
  const char* data = std::getenv("VALLECULA_DATA");
  const fs::path root = data != nullptr ? fs::path(data) : fs::path(VALLECULA_SOURCE_DIR) / ".." / "shared" / "data";
  return root / "cerr_head_neck_ct" / "dicom";
}

double length(const std::array<double, 3>& v) { return std::hypot(std::hypot(v[0], v[1]), v[2]); }

/// How far the planned hand is from where it began, m.
double planned_way(const device::Trajectory& press, double time_s) {
  const auto a = press.at(press.start_s()).position_m, b = press.at(time_s).position_m;
  return length({b[0] - a[0], b[1] - a[1], b[2] - a[2]});
}

/// When the planned hand leaves its deepest place.
double withdrawal_begins(const device::Trajectory& press) {
  double deepest = 0.0, last_s = 0.0;
  for (const device::Keyframe& key : press.keyframes()) {
    const double way = planned_way(press, key.time_s);
    if (way < deepest - 1e-9) continue;
    deepest = way;
    last_s = key.time_s;
  }
  return last_s;
}

TEST(RealCtTrial, APressOnTheDorsumIsFiniteTouchesTheTongueAndVerifies) {
  if (!fs::exists(series()))
    GTEST_SKIP() << "outside data absent: cerr_head_neck_ct is looked for in $VALLECULA_DATA, else in ../shared/data";
  const Sandbox box;
  const fs::path package = box / "adult.patient";
  const Outcome imported =
      box.run({"import", series().string(), "--out", package.string(), "--seed", "tongue=244,-341,-138"});
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  // A grown-up's trachea, 13 to 25 mm across, that the scan follows for half its length.
  const PatientAirway airway = airway_of(pipeline::read_package(package));
  const engine::AirwayRing& trachea = airway.course.airway[airway.course.airway.size() / 2];
  EXPECT_GT(trachea.to_left_m + trachea.to_right_m, 0.013);
  EXPECT_LT(trachea.to_left_m + trachea.to_right_m, 0.025);
  EXPECT_FALSE(airway.assumed.empty()) << "the carina is below the scan";

  const Outcome trial = box.run({"trial", "--patient", package.string(), "--scenario", "term", "--device",
                                 "scripted:press", "--headless", "--asap", "--out", (box / "out").string()});
  ASSERT_EQ(trial.exit_code, 0) << trial.err;

  const device::Trajectory press = scripted_hand("press", pipeline::read_package(package), {});
  const double withdrawal_s = withdrawal_begins(press);
  const curricula::TrialLog log = curricula::read_trial_log(box / "out");
  ASSERT_TRUE(log.footer.complete);
  ASSERT_GT(log.ticks.back().time_s, withdrawal_s);
  constexpr double kClear = 0.0005;  // m short of where the tongue was first met: the blade has left it
  double press_n = 0.0, withdrawal_n = 0.0, withdrawal_peak_s = 0.0, first_touch_m = -1.0, cleared_n = 0.0;
  int contacts = 0;
  for (const curricula::LogTick& tick : log.ticks) {
    for (const curricula::LogLoad& load : tick.loads) ASSERT_TRUE(std::isfinite(length(load.force_n))) << tick.tick;
    ASSERT_TRUE(std::isfinite(length(tick.model_force_n)) && std::isfinite(length(tick.displayed_force_n)))
        << tick.tick;
    const curricula::LogLoad& tongue = tick.loads[curricula::kTongue];
    const double force_n = length(tongue.force_n);
    const double way_m = planned_way(press, tick.time_s);
    if (first_touch_m < 0.0 && tongue.contacts > 0) first_touch_m = way_m;
    if (tick.time_s > withdrawal_s && way_m < first_touch_m - kClear) cleared_n = std::max(cleared_n, force_n);
    if (tick.time_s <= withdrawal_s) {
      press_n = std::max(press_n, force_n);
      contacts = std::max(contacts, tongue.contacts);
    } else if (force_n > withdrawal_n) {
      withdrawal_n = force_n;
      withdrawal_peak_s = tick.time_s;
    }
  }
  std::cout << "real CT: tongue at most " << press_n << " N in the press, " << withdrawal_n
            << " N in the withdrawal (at " << withdrawal_peak_s << " s), " << cleared_n << " N after leaving it, "
            << contacts << " contacts\n";
  EXPECT_GT(contacts, 0) << "the tongue was touched";
  EXPECT_GT(press_n, 0.1) << "and pressed";
  EXPECT_LE(withdrawal_n, press_n) << "a blade that leaves does not press harder than it did";
  EXPECT_LT(cleared_n, 0.1 * press_n) << "a tongue that is left behind does not hold on to the blade";

  const Outcome verified = box.run({"replay", (box / "out").string(), "--verify"});
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
}

}  // namespace
}  // namespace vallecula::gui::test
