// What somebody who watches is told, and when it is told no second time.
#include "gui/instructor/live_events.h"

#include <gtest/gtest.h>

namespace vallecula::gui {
namespace {

class LiveEventsOf : public ::testing::Test {
 protected:
  LiveEventsOf() {
    scenario_.sight_percent = 25.0;
    scenario_.targets.tongue_force_n = 5.0;
    scenario_.targets.gum_force_n = 2.0;
    // A mouth about the origin that goes inwards along +y.
    mouth_ = curricula::mouth_from_landmarks({{"upper_gum_midline", {0.0, 0.0, 0.01}},
                                              {"lower_gum_midline", {0.0, 0.0, -0.01}},
                                              {"vallecula", {0.0, 0.05, 0.0}}});
    events_.begin(scenario_, mouth_);
    snapshot_.proxy_pose.position = {0.0, -0.03, 0.0};
  }
  QStringList at(double time_s, const QString& pause = {}, double paused_s = 0.0) {
    snapshot_.time_s = time_s;
    QStringList texts;
    for (const LiveEvent& event : events_.watch(snapshot_, pause, paused_s, nullptr)) {
      EXPECT_NEAR(event.at_s, time_s, 1e-12) << "as the log, the result and the replay have it";
      texts << event.text;
    }
    return texts;
  }
  void press_tongue(double newton) {
    snapshot_.loads[static_cast<std::size_t>(engine::Structure::tongue)].force_n = {0.0, newton, 0.0};
  }
  curricula::Scenario scenario_;
  std::optional<curricula::Mouth> mouth_;
  engine::Snapshot snapshot_;
  LiveEvents events_;
};

TEST_F(LiveEventsOf, TheBladeGoesInOnceAndIsOutWhenItStaysOut) {
  ASSERT_TRUE(mouth_);
  EXPECT_EQ(at(0.1), QStringList());
  snapshot_.proxy_pose.position = {0.0, 0.02, 0.0};
  EXPECT_EQ(at(0.2), QStringList("Blade in the mouth"));
  EXPECT_EQ(at(0.3), QStringList());
  snapshot_.proxy_pose.position = {0.0, -0.03, 0.0};
  EXPECT_EQ(at(0.4), QStringList());
  snapshot_.proxy_pose.position = {0.0, 0.02, 0.0};
  EXPECT_EQ(at(0.5), QStringList()) << "a tenth of a second out is none";
  snapshot_.proxy_pose.position = {0.0, -0.03, 0.0};
  EXPECT_EQ(at(1.0), QStringList());
  EXPECT_EQ(at(1.6), QStringList("Blade out"));
  EXPECT_EQ(at(2.0), QStringList());
}

TEST_F(LiveEventsOf, ForceOverItsTargetIsToldOnceAStay) {
  press_tongue(4.9);
  EXPECT_EQ(at(1.0), QStringList());
  press_tongue(6.2);
  EXPECT_EQ(at(1.1), QStringList("Over the target on the tongue: 6.2 N of 5.0 N"));
  press_tongue(4.8);
  EXPECT_EQ(at(1.2), QStringList()) << "not back yet: 4.5 N are";
  press_tongue(5.2);
  EXPECT_EQ(at(1.3), QStringList());
  press_tongue(4.0);
  EXPECT_EQ(at(1.4), QStringList());
  press_tongue(5.5);
  EXPECT_EQ(at(1.5).size(), 1);
}

TEST_F(LiveEventsOf, SightPausesAndTheTubesWayAreTold) {
  snapshot_.glottis_visible = 0.24;
  EXPECT_EQ(at(1.0), QStringList());
  snapshot_.glottis_visible = 0.40;
  EXPECT_EQ(at(1.1), QStringList("Glottis in sight, 40 %"));
  EXPECT_EQ(at(1.2), QStringList());
  EXPECT_EQ(at(1.3, "unplugged"), QStringList("Paused: unplugged"));
  EXPECT_EQ(at(2.3, {}, 1.0), QStringList("It goes on"));

  snapshot_.has_intubation = true;
  auto& tube = snapshot_.intubation;
  tube.spo2 = 0.97;
  tube.heart_per_min = 150.0;
  tube.place = engine::TipPlace::oesophagus;
  EXPECT_EQ(at(3.0, {}, 1.0), QStringList("Tube in the oesophagus"));
  tube.place = engine::TipPlace::outside;
  EXPECT_EQ(at(4.0, {}, 1.0), QStringList("Tube out"));
  tube.place = engine::TipPlace::trachea;
  EXPECT_EQ(at(5.0, {}, 1.0), QStringList("Tube past the cords"));
  tube.place = engine::TipPlace::main_bronchus;
  tube.detector_yellow = true;
  EXPECT_EQ(at(6.0, {}, 1.0), (QStringList{"Tube in a main bronchus", "CO2 detector yellow"}));
  tube.spo2 = 0.70;
  const QStringList alarm = at(7.0, {}, 1.0);
  ASSERT_EQ(alarm.size(), 1);
  EXPECT_TRUE(alarm[0].startsWith("Alarm: ")) << alarm[0].toStdString();
  EXPECT_EQ(at(7.1, {}, 1.0), QStringList());

  events_.begin(scenario_, mouth_);
  EXPECT_TRUE(at(0.1).contains("Glottis in sight, 40 %")) << "begun anew, all is new";
}

}  // namespace
}  // namespace vallecula::gui
