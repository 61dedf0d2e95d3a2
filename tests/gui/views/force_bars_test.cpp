// The bars show what the hand lifts and what the jaw bears, by loads that were computed by hand.
#include "gui/views/force_bars.h"

#include "curricula/score/force_figures.h"
#include "gui/session/languages.h"
#include "gui/session/log_conversion.h"
#include "gui/views/theme.h"
#include "tests/curricula/score/hand_made_intubation.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using engine::Structure;

engine::TickRecord loaded(std::initializer_list<std::pair<Structure, engine::Vec3>> forces,
                          const engine::Quat& blade = engine::Quat::Identity()) {
  engine::TickRecord tick;
  tick.proxy_pose.rotation = blade;
  for (const auto& [structure, force_n] : forces) tick.loads[static_cast<std::size_t>(structure)].force_n = force_n;
  return tick;
}
BladeForces of(const engine::TickRecord& tick) { return blade_forces(tick.loads, tick.proxy_pose); }

TEST(BladeForces, LiftIsWhatTheJawDoesNotBear) {
  // 3 N of tongue and 0.5 N of epiglottis press the blade down, the gum holds 1.2 N of it up: 2.3 N are lifted.
  const BladeForces f = of(
      loaded({{Structure::tongue, {0, 0, -3}}, {Structure::epiglottis, {0, 0, -0.5}}, {Structure::gum, {0, 0, 1.2}}}));
  EXPECT_NEAR(f.tongue_n, 3.0, 1e-12);
  EXPECT_NEAR(f.gum_n, 1.2, 1e-12);
  EXPECT_NEAR(f.lifted_n, 2.3, 1e-12);
  EXPECT_NEAR(f.levered_n, 1.2, 1e-12);
}

TEST(BladeForces, TheJawBearsNoMoreThanThereIs) {
  const BladeForces f = of(loaded({{Structure::tongue, {0, 0, -1}},
                                   {Structure::gum, {0, 0, 2}},
                                   {Structure::palate, {0, 0, 1}},
                                   {Structure::teeth, {0, 0, -4}}}));
  EXPECT_NEAR(f.lifted_n, 0.0, 1e-12);
  EXPECT_NEAR(f.levered_n, 1.0, 1e-12);
}

TEST(BladeForces, GoAlongTheHandleHoweverItStands) {
  // A quarter turn about x takes the handle's z to -y: the tongue's 2 N in +y press it down, its 5 N in z do not.
  const engine::Quat turned(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);
  const BladeForces f = of(loaded({{Structure::tongue, {0, 2, 5}}, {Structure::gum, {0, -0.5, 0}}}, turned));
  EXPECT_NEAR(f.tongue_n, std::sqrt(29.0), 1e-12);
  EXPECT_NEAR(f.lifted_n, 1.5, 1e-12);
  EXPECT_NEAR(f.levered_n, 0.5, 1e-12);
}

class Bars : public Screen {
 protected:
  Bars() {
    bars_.resize(460, 170);
    bars_.set_marks({5.0, 2.0, 7.9});
  }
  /// Pixels of this colour in a row across the middle of `in`.
  int pixels(const QColor& colour) {
    return find_pixels(bars_.grab().toImage(),
                       [&](QRgb c, int, int) {
                         return std::abs(qRed(c) - colour.red()) + std::abs(qGreen(c) - colour.green()) +
                                    std::abs(qBlue(c) - colour.blue()) <
                                12;
                       })
        .pixels;
  }
  ForceBars bars_;
};

TEST_F(Bars, GrowWithTheForceAndTellLiftFromLever) {
  bars_.show_forces({2.0, 0.0, 2.0, 0.0});
  const int lifted = pixels(theme::within()), none = pixels(theme::bad());
  keep_picture(bars_, "bars-lift.png");
  bars_.show_forces({4.0, 0.0, 4.0, 0.0});
  EXPECT_NEAR(pixels(theme::within()) / static_cast<double>(lifted), 2.0, 0.15) << "twice the force, twice the length";
  bars_.clear();
  bars_.show_forces({2.0, 1.2, 0.8, 1.2});
  EXPECT_GT(pixels(theme::bad()), none + 100) << "the levered part stands in its own colour";
  keep_picture(bars_, "bars-lever.png");
  EXPECT_TRUE(bars_.accessibleDescription().contains("lift 0.8 N, lever 1.2 N"));
  bars_.show_forces({6.2, 2.6, 3.6, 2.6});
  keep_picture(bars_, "bars-over.png");
  EXPECT_NEAR(bars_.tongue_peak_n(), 6.2, 1e-12);
}

TEST_F(Bars, SayWhatTheirMarksAreByTheScenariosOwnFigures) {
  curricula::Scenario scenario;
  scenario.targets.tongue_force_n = 4.1;
  scenario.targets.gum_force_n = 1.6;
  scenario.pass.peak_tongue_force_n = 5.7;
  scenario.pass.peak_gum_force_n = 2.4;
  scenario.pass.time_over_target_s = 2.5;
  const int without = pixels(theme::bad());
  bars_.set_marks(force_marks(scenario, 7.9));
  EXPECT_GT(pixels(theme::bad()), without + 60) << "the marks that decide are drawn";
  for (const char* figure : {"4.1 N", "1.6 N", "5.7 N", "2.4 N", "2.5 s", "7.9 N"})
    EXPECT_TRUE(bars_.toolTip().contains(figure)) << figure << " in " << bars_.toolTip().toStdString();
  for (const char* word : {"Target: ", "Pass limit: ", "Device limit: "})
    EXPECT_TRUE(bars_.toolTip().contains(word)) << word;
  for (const char* look : {"yellow line", "red line", "blue dashed line, hatched beyond it", "White line"})
    EXPECT_TRUE(bars_.toolTip().contains(look)) << "who wonders what it is looks for how it looks: " << look;
  bars_.show_forces({4.4, 1.0, 4.0, 0.4});
  keep_picture(bars_, "bars-marks.png");
  bars_.resize(280, 140);
  keep_picture(bars_, "bars-marks-narrow.png");
  bars_.resize(360, 160);  // the side in the smallest window
  keep_picture(bars_, "bars-marks-small-window.png");
  ASSERT_TRUE(install_language(*qApp, "de"));
  bars_.set_marks(force_marks(scenario, 7.9));
  bars_.show_forces({4.4, 1.0, 4.0, 0.4});
  keep_picture(bars_, "bars-marks-small-window-de.png");
  ASSERT_TRUE(install_language(*qApp, "en"));
  bars_.set_marks(force_marks(scenario, 0.0));
  EXPECT_FALSE(bars_.toolTip().contains("evice")) << "without a limit: " << bars_.toolTip().toStdString();
}

TEST_F(Bars, AnExpertsForcesLeaveOnesOwnPeaks) {
  bars_.show_forces({3.0, 1.0, 2.0, 1.0});
  bars_.show_expert({6.5, 0.2, 6.3, 0.2});
  EXPECT_EQ(bars_.tongue_peak_n(), 3.0);
  EXPECT_TRUE(bars_.accessibleDescription().startsWith("An expert's: tongue 6.5 N"));
  bars_.show_forces({0.0, 0.0, 0.0, 0.0});
  EXPECT_EQ(bars_.tongue_peak_n(), 3.0);
  EXPECT_TRUE(bars_.accessibleDescription().startsWith("tongue 0.0 N"));
}

TEST_F(Bars, PatternsTellThePartsApartWithoutColour) {
  bars_.show_forces({4.0, 0.0, 2.0, 2.0});
  // The strip below the tongue's bar: grey values along a row; a plain part has one, a hatched one changes.
  const QImage grey = bars_.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
  int plain = 0, hatched = 0;
  for (int y = 0; y < grey.height(); ++y) {
    int changes_left = 0, changes_right = 0;
    const double from = 64.0, track = grey.width() - 64.0 - 72.0;
    for (int x = 2; x < static_cast<int>(0.18 * track); ++x) {
      const int left = static_cast<int>(from) + x,
                right = static_cast<int>(from + bars_.share_of_track(2.0) * track) + x;
      changes_left += std::abs(qGray(grey.pixel(left, y)) - qGray(grey.pixel(left + 1, y))) > 30;
      changes_right += std::abs(qGray(grey.pixel(right, y)) - qGray(grey.pixel(right + 1, y))) > 30;
    }
    if (changes_left == 0 && changes_right >= 8) ++hatched;
    if (changes_left == 0 && changes_right == 0) ++plain;
  }
  EXPECT_GE(hatched, 6) << "rows of the strip with a hatched right part and a plain left one";
  EXPECT_GT(plain, hatched);
}

TEST(BladeForces, AreTheScores) {
  // The score's own sums of a hand-made log, against the bars' figures of its ticks.
  const auto log = curricula::testing::log_of([](curricula::LogTick& t) {
    if (curricula::testing::between(t, 6, 8)) t.loads[curricula::kTongue].force_n = {0.4, 0, -3};
    if (curricula::testing::between(t, 7, 8)) t.loads[curricula::kGum].force_n = {0, 0, 1.5};
  });
  double lifted = 0.0, levered = 0.0;
  for (const auto& tick : log.ticks) {
    const BladeForces f = of(from_log(tick));
    lifted += f.lifted_n;
    levered += f.levered_n;
  }
  EXPECT_NEAR(lifted / (lifted + levered), 0.75, 1e-9);
  EXPECT_NEAR(*curricula::measure_forces_beyond_peaks(log, curricula::testing::scenario()).lift_share, 0.75, 1e-9);
}

}  // namespace
}  // namespace vallecula::gui::window_test
