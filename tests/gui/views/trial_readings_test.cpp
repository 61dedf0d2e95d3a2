// What the readings say of the tube before and in the mouth, by a mouth and tips laid out by hand, and whose figures
// they show while an expert is looked at.
#include "gui/views/trial_readings.h"

#include <QLabel>
#include <algorithm>

#include "gui/session/languages.h"
#include "gui/views/theme.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

/// Gums 20 mm apart about the origin, the throat 50 mm behind them along +y: a mouth 30 mm to each side.
std::optional<curricula::Mouth> mouth() {
  return curricula::mouth_from_landmarks({{"upper_gum_midline", {0.0, 0.0, 0.01}},
                                          {"lower_gum_midline", {0.0, 0.0, -0.01}},
                                          {"vallecula", {0.0, 0.05, 0.0}}});
}

engine::IntubationRecord tip_at(const engine::Vec3& tip_m, double at_mouth_m = 0.0,
                                engine::InHand in_hand = engine::InHand::tube) {
  engine::IntubationRecord record;
  record.tip_m = tip_m;
  record.at_mouth_m = at_mouth_m;
  record.in_hand = in_hand;
  return record;
}

class TrialReadingsOf : public Screen {
 protected:
  static std::string words(const engine::IntubationRecord& record) { return tube_words(record, mouth()).toStdString(); }
  const QLabel* label(const QString& text) const {
    const auto labels = readings_.findChildren<QLabel*>();
    const auto found =
        std::find_if(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text() == text; });
    return found == labels.end() ? nullptr : *found;
  }
  TrialReadings readings_;
};

// To the operator's eye, which looks along the mouth's axis, the first three are in the mouth.
TEST_F(TrialReadingsOf, ATubeBeforeTheMouthIsTheFartherFromTheGumsTheFartherItIs) {
  EXPECT_EQ(words(tip_at({-0.008, -0.017, 0.004})), "1.7 cm before the gums");
  EXPECT_EQ(words(tip_at({-0.008, -0.004, 0.004})), "0.4 cm before the gums");
  EXPECT_EQ(words(tip_at({0.0, -0.004, 0.0}, 0.0, engine::InHand::catheter)), "catheter 0.4 cm before the gums");
  EXPECT_EQ(words(tip_at({-0.008, 0.006, 0.004}, 0.021)), "2.1 cm at the lips");
  // Through the cheek: behind the gums, and yet the engine has it outside.
  EXPECT_EQ(words(tip_at({-0.022, 0.006, 0.0})), "beside the mouth");
  // Over the ear: nobody takes 1 mm before the plane of the gums for before the mouth.
  EXPECT_EQ(words(tip_at({-0.070, -0.001, 0.0})), "beside the mouth");
  EXPECT_EQ(words(tip_at({-0.070, -0.120, 0.0})), "12.0 cm before the gums") << "as it hangs from the hand at first";
  // Where the mouth goes down to the throat the eye looks in from above: there a tip is before it, not beside.
  const auto steep = curricula::mouth_from_landmarks({{"upper_gum_midline", {0.0, 0.0, 0.01}},
                                                      {"lower_gum_midline", {0.0, 0.0, -0.01}},
                                                      {"vallecula", {0.0, 0.03, -0.04}}});
  EXPECT_EQ(tube_words(tip_at({0.0, -0.036, 0.048}), steep).toStdString(), "3.6 cm before the gums");
  EXPECT_EQ(tube_words(tip_at({0.0, -0.004, 0.0}), std::nullopt).toStdString(), "not in the mouth");
  ASSERT_TRUE(install_language(*qApp, "de"));
  EXPECT_EQ(words(tip_at({-0.008, -0.017, 0.004})), "1,7 cm vor der Zahnleiste");
  install_language(*qApp, "en");
}

TEST_F(TrialReadingsOf, ATubesMarkStandsBesideTheRuleButInAnAssessment) {
  curricula::Scenario scenario;
  scenario.manikin.weight_kg = 3.2;  // and 6 cm: 9.2 cm (CLINICAL)
  scenario.intubation.emplace();
  readings_.show_tube(true);
  engine::Snapshot in;
  in.has_intubation = true;
  in.intubation = tip_at({0.0, 0.02, 0.0}, 0.090);
  readings_.set_scenario(scenario, mouth());
  readings_.show_snapshot(in);
  const QLabel* tube = label("9.0 cm at the lips (rule: 9.2), 0.0 N on the hand");
  ASSERT_TRUE(tube);
  EXPECT_TRUE(tube->toolTip().contains("weight in kg (3.2) and 6 cm")) << tube->toolTip().toStdString();
  readings_.resize(360, 260);
  keep_picture(readings_, "readings-rule.png");
  in.intubation.in_hand = engine::InHand::catheter;
  readings_.show_snapshot(in);
  EXPECT_TRUE(label("catheter 9.0 cm at the lips, 0.0 N on the hand")) << "it has no rule";
  in.intubation.in_hand = engine::InHand::tube;
  scenario.attempt.mode = curricula::Mode::assessment;
  readings_.set_scenario(scenario, mouth());
  readings_.show_snapshot(in);
  tube = label("9.0 cm at the lips, 0.0 N on the hand");
  ASSERT_TRUE(tube) << "an assessment has no helps";
  EXPECT_FALSE(tube->toolTip().contains("Rule"));
}

TEST_F(TrialReadingsOf, WhileAnExpertIsLookedAtNothingOfOnesOwnStandsAsThoughItWereHis) {
  curricula::Scenario scenario;
  scenario.pass.attempt_time_s = 3.0;
  readings_.set_scenario(scenario, mouth());
  readings_.show_tube(true);
  engine::Snapshot own, expert;
  own.has_intubation = expert.has_intubation = true;
  own.intubation = tip_at({0.0, -0.05, 0.0});
  own.glottis_visible = 0.2;
  own.proxy_pose.position = {0.0, 0.02, 0.0};
  for (own.time_s = 1.0; own.time_s <= 5.5; own.time_s += 0.5) readings_.show_snapshot(own);
  own.time_s = 5.5;
  readings_.show_drawing(30.0, {});
  ASSERT_TRUE(label("4.5 s") && label("20 %") && label("Attempt") && label("at most 3 s"));
  EXPECT_TRUE(label("4.5 s")->styleSheet().contains(theme::over().name())) << "past its time";
  expert.intubation = tip_at({0.0, 0.02, 0.0}, 0.034);
  expert.glottis_visible = 0.8;
  expert.proxy_pose.position = {0.0, 0.03, 0.0};
  expert.time_s = 14.0;
  readings_.show_expert(expert);
  EXPECT_TRUE(label("80 %")) << "the expert's sight";
  EXPECT_FALSE(label("20 %"));
  EXPECT_TRUE(label("Glottis visible: expert"));
  EXPECT_TRUE(label("expert: 3.4 cm at the lips, 0.0 N on the hand"));
  ASSERT_TRUE(label("4.5 s")) << "one's own clock stands";
  EXPECT_TRUE(label("4.5 s")->styleSheet().contains(theme::faint().name())) << "greyed out";
  EXPECT_TRUE(label("Your attempt") && !label("Attempt") && !label("at most 3 s"));
  EXPECT_FALSE(label("following your hand") || label("keeps up with the hand") || label("30 frames/s"));
  readings_.resize(360, 260);
  keep_picture(readings_, "readings-expert.png");
  readings_.show_snapshot(own);
  readings_.show_drawing(30.0, {});
  ASSERT_TRUE(label("4.5 s") && label("20 %") && label("Attempt") && label("at most 3 s") && label("Glottis visible"));
  EXPECT_TRUE(label("4.5 s")->styleSheet().contains(theme::over().name()));
  EXPECT_TRUE(label("5.0 cm before the gums") && label("following your hand") && label("30 frames/s"));
  readings_.show_expert(expert);
  readings_.clear();
  EXPECT_TRUE(label("Attempt") && label("0.0 s") && !label("80 %"));
}

}  // namespace
}  // namespace vallecula::gui::window_test
