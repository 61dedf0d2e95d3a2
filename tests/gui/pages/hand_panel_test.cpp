// What is asked for by keys and buttons reaches the bits the loop reads, and is let go of again.
#include "gui/pages/hand_panel.h"

#include <QKeyEvent>
#include <QPushButton>

#include "gui/pages/hints.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using engine::Action;

class Hands : public Screen {
 protected:
  Hands() {
    panel_.serve(&actions_, true);
    panel_.set_running(true);
  }
  bool key(int code, bool pressed, bool repeated = false) {
    QKeyEvent event(pressed ? QEvent::KeyPress : QEvent::KeyRelease, code, Qt::NoModifier, QString(), repeated);
    return panel_.key(&event, pressed);
  }
  QPushButton* button(const QString& begin) {
    for (auto* candidate : panel_.findChildren<QPushButton*>())
      if (candidate->text().startsWith(begin)) return candidate;
    return nullptr;
  }
  HandActions actions_;
  HandPanel panel_;
};

TEST_F(Hands, HoldWhatTheirKeysHold) {
  const std::pair<int, Action> all[] = {{Qt::Key_B, Action::kActionBreath},
                                        {Qt::Key_Space, Action::kActionBreath},
                                        {Qt::Key_V, Action::kActionSuction},
                                        {Qt::Key_L, Action::kActionPress},
                                        {Qt::Key_T, Action::kActionStyletOut}};
  for (const auto& [code, action] : all) {
    EXPECT_TRUE(key(code, true));
    EXPECT_EQ(actions_.bits(), action);
    EXPECT_TRUE(key(code, true, true));  // a key held repeats itself: it is still one breath until it is let go
    EXPECT_TRUE(key(code, false, true));
    EXPECT_EQ(actions_.bits(), action);
    EXPECT_TRUE(key(code, false));
    EXPECT_EQ(actions_.bits(), 0u);
  }
  EXPECT_TRUE(key(Qt::Key_L, true));
  EXPECT_TRUE(key(Qt::Key_B, true));
  EXPECT_EQ(actions_.bits(), Action::kActionPress | Action::kActionBreath) << "an assistant has hands of their own";
  panel_.release_all();
  EXPECT_EQ(actions_.bits(), 0u);
  EXPECT_FALSE(key(Qt::Key_W, true)) << "the blade's";
}

TEST_F(Hands, ChangeTubeForCatheterAndHandForHand) {
  EXPECT_TRUE(key(Qt::Key_C, true));
  EXPECT_TRUE(key(Qt::Key_C, false));
  EXPECT_EQ(actions_.bits(), Action::kActionCatheter) << "it stays in the hand";
  EXPECT_TRUE(key(Qt::Key_V, true));
  panel_.release_all();
  EXPECT_EQ(actions_.bits(), Action::kActionCatheter);
  EXPECT_TRUE(key(Qt::Key_C, true));
  EXPECT_EQ(actions_.bits(), 0u);
  for (const int code : {Qt::Key_X, Qt::Key_Tab}) {
    EXPECT_TRUE(key(code, true));
    EXPECT_TRUE(key(code, false));
  }
  EXPECT_EQ(actions_.changes(), 2u);
  panel_.serve(&actions_, false);  // a device for each hand
  EXPECT_FALSE(key(Qt::Key_X, true));
  EXPECT_EQ(actions_.changes(), 2u);
}

TEST_F(Hands, CanDoNothingBeforeTheStartAndSayWhen) {
  panel_.set_running(false);
  for (const char* name : {"Breath", "Suction", "Press", "Stylet", "Catheter", "Other hand"}) {
    ASSERT_NE(button(name), nullptr) << name;
    EXPECT_FALSE(button(name)->isEnabled()) << name;
    EXPECT_TRUE(button(name)->toolTip().startsWith("Once the trial runs")) << button(name)->toolTip().toStdString();
  }
  for (const int code : {Qt::Key_B, Qt::Key_V, Qt::Key_L, Qt::Key_T, Qt::Key_C, Qt::Key_X}) {
    EXPECT_TRUE(key(code, true)) << "it is still theirs";
    EXPECT_EQ(actions_.bits(), 0u);
    key(code, false);
  }
  EXPECT_EQ(actions_.changes(), 0u);
  panel_.set_running(true);
  EXPECT_TRUE(button("Breath")->isEnabled());
  EXPECT_FALSE(button("Breath")->toolTip().startsWith("Once")) << button("Breath")->toolTip().toStdString();
  key(Qt::Key_B, true);
  EXPECT_EQ(actions_.bits(), Action::kActionBreath);
}

TEST_F(Hands, ButtonsHoldAsLongAsTheyArePressedAndSayWhatCanBeDone) {
  engine::Snapshot snapshot;
  snapshot.has_intubation = true;
  snapshot.intubation.in_hand = engine::InHand::tube_with_stylet;
  panel_.show_snapshot(snapshot);
  EXPECT_FALSE(button("Suction")->isEnabled()) << "there is no catheter in the hand";
  EXPECT_TRUE(button("Stylet")->isEnabled());
  auto* breath = button("Breath");
  emit breath->pressed();
  EXPECT_EQ(actions_.bits(), Action::kActionBreath);
  emit breath->released();
  EXPECT_EQ(actions_.bits(), 0u);
  button("Catheter")->click();
  panel_.show_snapshot(snapshot);
  EXPECT_NE(button("Tube out first"), nullptr) << "asked for, and not yet in the hand";
  snapshot.intubation.in_hand = engine::InHand::catheter;
  panel_.show_snapshot(snapshot);
  EXPECT_NE(button("Tube (C)"), nullptr);
  EXPECT_TRUE(button("Suction")->isEnabled());
  EXPECT_FALSE(button("Stylet")->isEnabled());
  panel_.serve(nullptr, false);
  EXPECT_EQ(actions_.bits(), 0u) << "the trial is over";
  EXPECT_FALSE(key(Qt::Key_B, true));
}

TEST_F(Hands, WhatIsGreyDoesNothingByItsKeyEither) {
  engine::Snapshot snapshot;
  snapshot.has_intubation = true;
  snapshot.intubation.in_hand = engine::InHand::tube;
  panel_.show_snapshot(snapshot);
  for (const int code : {Qt::Key_V, Qt::Key_T}) {  // no catheter to draw with, no stylet to draw
    EXPECT_TRUE(key(code, true)) << "nobody else's either";
    EXPECT_EQ(actions_.bits(), 0u);
    EXPECT_TRUE(key(code, false));
  }
  snapshot.intubation.in_hand = engine::InHand::catheter;
  panel_.show_snapshot(snapshot);
  EXPECT_TRUE(key(Qt::Key_V, true));
  EXPECT_EQ(actions_.bits(), engine::kActionSuction);
  snapshot.intubation.in_hand = engine::InHand::tube;
  panel_.show_snapshot(snapshot);
  EXPECT_TRUE(key(Qt::Key_V, false));
  EXPECT_EQ(actions_.bits(), 0u) << "held while it turned grey, it is let go of all the same";
  panel_.serve(nullptr, false);
  for (auto* one : panel_.findChildren<QPushButton*>()) EXPECT_FALSE(one->isEnabled()) << one->text().toStdString();
}

engine::Snapshot at(engine::TipPlace place) {
  engine::Snapshot snapshot;
  snapshot.has_intubation = true;
  snapshot.intubation.place = place;
  snapshot.intubation.in_hand = engine::InHand::tube;
  snapshot.intubation.spo2 = 0.95;
  snapshot.intubation.heart_per_min = 150.0;
  snapshot.intubation.glottis_opening = 0.55;
  return snapshot;
}
std::string hint(const engine::Snapshot& snapshot, bool blade_in = true) {
  return hint_for(snapshot, 25.0, blade_in, "X").toStdString();
}
bool says(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

TEST(Hint, PutsTheInfantBeforeTheTube) {
  auto now = at(engine::TipPlace::larynx);
  now.intubation.tip_load_n = 2.0;
  now.intubation.heart_per_min = 95.0;
  EXPECT_TRUE(says(hint(now), "Stop this attempt"));
  now.intubation.heart_per_min = 55.0;
  EXPECT_TRUE(says(hint(now), "compressions"));
  auto out = at(engine::TipPlace::outside);
  out.intubation.spo2 = 0.78;
  EXPECT_TRUE(says(hint(out, false), "Hold B"));
}

TEST(Hint, WhatTheInfantNeedsComesBeforeWhatTheDeviceWants) {
  auto now = at(engine::TipPlace::outside);
  EXPECT_EQ(need_of(now, true), QString());
  now.intubation.heart_per_min = 95.0;
  const QString slow = need_of(now, true);
  EXPECT_TRUE(says(slow.toStdString(), "Stop this attempt"));
  EXPECT_FALSE(need_before(now, slow, "").loud) << "a delivery room's infant begins so";
  now.state = engine::HapticState::limited;
  EXPECT_TRUE(need_before(now, slow, "Device limit reached").loud) << "what took an alarm's place is one";
  EXPECT_EQ(need_before(now, slow, "Device limit reached").words, slow) << "the grey blade shows the rest";
  now.state = engine::HapticState::lost;
  now.intubation.heart_per_min = 55.0;
  const Banner both = need_before(now, need_of(now, true), "let go");
  EXPECT_TRUE(both.words.startsWith("Heart rate below 60"));
  EXPECT_TRUE(both.words.contains("grey blade back")) << "else the hand steers nothing";
  EXPECT_TRUE(need_before(now, need_of(now, true), "").loud);
}

TEST(Hint, DoesNotTellTracheaFromOesophagusBeforeTheDetectorDoes) {
  auto trachea = at(engine::TipPlace::trachea), wrong = at(engine::TipPlace::oesophagus);
  for (const int breaths : {0, 3}) {
    trachea.intubation.breaths_given = wrong.intubation.breaths_given = breaths;
    EXPECT_EQ(hint(trachea), hint(wrong));
  }
  trachea.intubation.breaths_given = wrong.intubation.breaths_given = 7;
  trachea.intubation.given_per_min = wrong.intubation.given_per_min = 40.0;
  trachea.intubation.detector_yellow = true;
  EXPECT_TRUE(says(hint(trachea), "in the airway"));
  EXPECT_TRUE(says(hint(wrong), "No CO2"));
}

TEST(Hint, LeveringIsSaidOfMoreThanTheGumsTarget) {
  EXPECT_EQ(levering_words(2.0, 2.0), QString());
  EXPECT_TRUE(levering_words(2.1, 2.0).contains("along its handle"));
}

TEST(Hint, SaysNeverToPush) {
  auto now = at(engine::TipPlace::larynx);
  now.intubation.tip_load_n = 1.5;
  EXPECT_TRUE(says(hint(now), "never push"));
  now.intubation.glottis_opening = 0.0;
  EXPECT_TRUE(says(hint(now), "Wait"));
  now.intubation.spasm = true;
  EXPECT_TRUE(says(hint(now), "laryngospasm"));
}

TEST(Hint, GoesAlongWithTheProcedure) {
  auto now = at(engine::TipPlace::outside);
  EXPECT_TRUE(says(hint(now, false), "right corner"));
  EXPECT_TRUE(says(hint(now, true), "lift"));
  now.intubation.secretions_ml = 1.0;
  EXPECT_TRUE(says(hint(now, true), "suction catheter"));
  now.intubation.secretions_ml = 0.0;
  now.glottis_visible = 0.5;
  EXPECT_TRUE(says(hint(now, true), "X takes the tube"));
  EXPECT_FALSE(says(hint_for(now, 25.0, true, "").toStdString(), "X takes")) << "a device for each hand";
  const auto with_one_device = [&](Tool in_hand) {
    return hint_for(now, 25.0, true, key_to_the_tube(true, in_hand)).toStdString();
  };
  EXPECT_TRUE(says(with_one_device(Tool::blade), "X takes the tube"));
  EXPECT_FALSE(says(with_one_device(Tool::tube), "X takes")) << "it has been taken";
  EXPECT_TRUE(says(with_one_device(Tool::tube), "right corner"));
  EXPECT_EQ(key_to_the_tube(false, Tool::blade), QString()) << "a device for each hand";
  now.intubation.place = engine::TipPlace::mouth;
  EXPECT_TRUE(says(hint(now), "beside the blade"));
  now.intubation.place = engine::TipPlace::trachea;
  now.intubation.in_hand = engine::InHand::tube_with_stylet;
  EXPECT_TRUE(says(hint(now), "stylet"));
}

}  // namespace
}  // namespace vallecula::gui::window_test
