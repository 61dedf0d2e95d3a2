// What a session keeps of its device checks, and whether the check asks for the right reach.
#include <gtest/gtest.h>

#include "gui/instructor/device_check.h"
#include "gui/session/operator_axes.h"
#include "gui/session/scripted_hands.h"
#include "tests/gui/window_patient.h"

namespace vallecula::gui {
namespace {

/// The reach that is asked for holds the way of an expert's blade, seen in the operator's axes.
TEST(DeviceChecks, TheReachIsThatOfALaryngoscopy) {
  const pipeline::PatientPackage package = window_test::coarse_patient();
  curricula::Scenario scenario;
  const device::Trajectory way = scripted_hand("expert", package, scenario);
  const OperatorAxes axes = operator_axes(package);
  const engine::Vec3 towards = axes.right.cross(axes.up);
  engine::Vec3 low = engine::Vec3::Constant(1.0), high = -low;
  for (double t = way.start_s(); t < way.end_s(); t += 0.05) {
    const auto& p = way.at(t).position_m;
    const engine::Vec3 tip(p[0], p[1], p[2]), seen(tip.dot(axes.right), tip.dot(axes.up), tip.dot(towards));
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  for (int i = 0; i < 3; ++i) EXPECT_LE(high[i] - low[i], kMouthReachM[static_cast<std::size_t>(i)]) << "axis " << i;
  EXPECT_GE((high - low).maxCoeff(), 0.5 * kMouthReachM[2]) << "and is not far larger than it";
}

TEST(DeviceChecks, SayWhenItWasAndWhatIsDue) {
  DeviceChecks checks;
  EXPECT_TRUE(checks.due("touch"));
  EXPECT_TRUE(checks.due("falcon:firmware.bin"));
  EXPECT_FALSE(checks.due("mouse"));
  EXPECT_FALSE(checks.due("scripted:expert"));
  EXPECT_EQ(checks.words("mouse"), "");
  EXPECT_EQ(checks.words("touch"), "Device not checked");
  CheckResult result;
  result.device = "touch";
  result.at = QDateTime::currentDateTime();
  checks.keep(result);
  EXPECT_FALSE(checks.due("touch"));
  EXPECT_EQ(checks.words("touch", result.at.addSecs(12 * 60 + 5)), "Device checked 12 min ago");
  EXPECT_EQ(checks.words("touch", result.at.addSecs(3)), "Device checked just now");
  result.lines[2].verdict = CheckVerdict::bad;
  checks.keep(result);
  EXPECT_EQ(checks.words("touch", result.at.addSecs(61)), "Device checked 1 min ago: 1 of 7 not as it should be");
  EXPECT_TRUE(checks.due("touch:other"));
}

}  // namespace
}  // namespace vallecula::gui
