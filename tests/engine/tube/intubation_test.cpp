// The second half as the scene steps it: what the second hand holds and where it is, breaths and what they do, sight
// past secretions and tube, the assistant's press.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/tube/intubation_scene.h"
#include "tests/engine/tube/soft_loads.h"

namespace vallecula::engine {
namespace {

using testing::intubation_scene;
using testing::kBeforeMouth;
using testing::Trial;

TEST(Intubation, WhatContradictsItselfIsRefusedWithItsNumber) {
  const auto refusal = [](auto change) {
    SceneDescription d = intubation_scene();
    change(*d.intubation);
    try {
      build_scene(d);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  const auto expect = [](const std::string& said, const char* part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  EXPECT_EQ(refusal([](IntubationDescription&) {}), "nothing");
  expect(refusal([](auto& d) { d.glottis.relaxed = false; }), "relaxant");
  expect(refusal([](auto& d) { d.breathes = true; }), "does not breathe");
  expect(refusal([](auto& d) { d.press_n = 10.5; }), "10.5");
  expect(refusal([](auto& d) { d.press_n = -1; }), "-1.0");
  expect(refusal([](auto& d) { d.press_direction *= 2; }), "2.0");
  expect(refusal([](auto& d) { d.mouth_inward.setZero(); }), "0.0");
  expect(refusal([](auto& d) { d.mouth_axis *= 2; }), "2.0");
  expect(refusal([](auto& d) { d.mouth_radius_m = -0.002; }), "-2.0");
  expect(refusal([](auto& d) { d.mouth_half_width_m = -0.003f; }), "-3.0");
  expect(refusal([](auto& d) { d.device_limit_n = 0; }), "0.0");
  expect(refusal([](auto& d) { d.mouth_gap_m = 0.0048; }), "4.8");
  expect(refusal([](auto& d) { d.lips_before_gums_m = -0.002; }), "-2.0");
  expect(refusal([](auto& d) { d.catheter_outer_m = 0.02; }), "20.0");
  expect(refusal([](auto& d) { d.secretions.volume_m3 = -1e-6; }), "-1.0");
  expect(refusal([](auto& d) { d.secretions.area_m2 = 0; }), "0.0");
  expect(refusal([](auto& d) { d.secretions.up *= 3; }), "3.0");
  expect(refusal([](auto& d) { d.tube.length = 0; }), "length");
  expect(refusal([](auto& d) {
           d.stylet = Stylet{};
           d.stylet->diameter = 0.004;
         }),
         "4.0");
  expect(refusal([](auto& d) { d.course.larynx_body = 3; }), "body 3");
  expect(refusal([](auto& d) { d.glottis.length_m = 0; }), "glottis");
  expect(refusal([](auto& d) { d.infant.weight_kg = 0; }), "weight");
}

TEST(Intubation, TheTubeIsWhereTheHandHoldsIt) {
  Trial t(intubation_scene());
  const IntubationRecord& before = t.hold(0.1, kBeforeMouth);
  EXPECT_TRUE(t.record.has_intubation);
  EXPECT_EQ(before.place, TipPlace::outside);
  EXPECT_EQ(before.at_mouth_m, 0.0);
  EXPECT_EQ(before.in_hand, InHand::tube);
  const Vec3 in_mouth(0.040, 0.015, 0.010);
  const IntubationRecord& r = t.go(kBeforeMouth, in_mouth);
  t.hold(0.2, in_mouth);
  EXPECT_EQ(r.place, TipPlace::mouth);
  EXPECT_NEAR(r.at_mouth_m, testing::kMouthZ - in_mouth.z(), 5e-5);
  EXPECT_LT((r.tip_m - in_mouth).norm(), 1e-5);
  EXPECT_GT(r.tip_direction.dot(-Vec3::UnitZ()), 0.999);
  EXPECT_LT(r.buckled_m, 1e-5);
  EXPECT_LT(r.model_force_n.norm(), 1e-3);
  EXPECT_EQ(r.faults, 0u);
}

// Nothing the hands do that is not a breath changes the infant's course.
TEST(Intubation, ApnoeaIsTheInfantsOwn) {
  Trial t(intubation_scene());
  testing::Patient alone(testing::preterm());
  InfantInput none;
  none.glottis_opening = 0.55;  // relaxed cords
  for (int n = 0; n < 15000; ++n) {
    const IntubationRecord& r = t.tick(t.hands(kBeforeMouth - Vec3(0, 0, 0.03 * (n % 2000) / 2000.0)));
    alone.tick(none);
    ASSERT_EQ(r.sao2, alone.signs.sao2) << n;
    ASSERT_EQ(r.spo2, alone.signs.spo2) << n;
    ASSERT_EQ(r.heart_per_min, alone.signs.heart_per_min) << n;
  }
  EXPECT_LT(t.record.intubation.sao2,
            alone.infant.oxygen.first_mmhg[0] > 0 ? start(alone.infant).oxygen.arterial : 0.0);
}

TEST(Intubation, WhileEitherHandIsLostTheInfantStandsStill) {
  Trial t(intubation_scene()), whole(intubation_scene());
  t.hold(20, kBeforeMouth);
  for (const bool second : {false, true}) {
    const IntubationRecord before = t.record.intubation;
    ASSERT_LT(before.sao2, 0.97);
    for (int n = 0; n < 5000; ++n) {
      PortInput in = t.hands(kBeforeMouth, kActionBreath);  // nobody is there to give it
      (second ? in.second_valid : in.valid) = false;
      const IntubationRecord& r = t.tick(in);
      ASSERT_EQ(r.sao2, before.sao2);
      ASSERT_EQ(r.heart_per_min, before.heart_per_min);
      ASSERT_EQ(r.breaths_given, 0);
    }
  }
  // And goes on where it was.
  EXPECT_EQ(t.hold(10, kBeforeMouth).sao2, whole.hold(30, kBeforeMouth).sao2);
}

TEST(Intubation, BreathsByMaskWhileTheMouthIsFree) {
  Trial t(intubation_scene());
  t.hold(20.0, kBeforeMouth);
  const double low = t.record.intubation.sao2;
  EXPECT_EQ(t.record.intubation.breaths_given, 0);
  // Held for 15 s from the first breath on: 40 a minute.
  t.hold(15.0, kBeforeMouth, kActionBreath);
  EXPECT_EQ(t.record.intubation.breaths_given, 10);
  EXPECT_NEAR(t.record.intubation.given_per_min, 40.0, 0.1);
  EXPECT_GT(t.record.intubation.sao2, low + 0.05);
  EXPECT_FALSE(t.record.intubation.detector_yellow);
  // Key by key, once a second: as often as it goes down.
  for (int k = 0; k < 5; ++k) {
    t.hold(0.2, kBeforeMouth, kActionBreath);
    t.hold(0.8, kBeforeMouth);
  }
  EXPECT_EQ(t.record.intubation.breaths_given, 15);
  // With the tube in the mouth, or the blade, no mask fits.
  const Vec3 in_mouth(0.040, 0.015, 0.015);
  t.go(kBeforeMouth, in_mouth);
  t.hold(3.0, in_mouth, kActionBreath);
  t.go(in_mouth, kBeforeMouth);
  for (int n = 0; n < 2000; ++n) {
    t.blade.position = Vec3(0.0, -0.1, 0.1) + Vec3(0.06, 0.16, -0.08) * std::min(1.0, n / 1500.0);
    t.hold(0.001, kBeforeMouth);
  }
  t.hold(3.0, kBeforeMouth, kActionBreath);
  EXPECT_EQ(t.record.intubation.breaths_given, 15);
}

// Beside the head and below it there is no mouth, however far back.
TEST(Intubation, TheMouthEndsAtItsRadiusForTubeBladeAndMask) {
  SceneDescription d = intubation_scene();
  d.intubation->mouth_radius_m = 0.018;
  d.intubation->mouth_axis = Vec3(0.6, 0, -0.8);  // goes aside: at a depth of 8 mm its middle lies 6 mm to the left
  const Vec3 front(0.040, 0.015, testing::kMouthZ), middle = front + 0.010 * d.intubation->mouth_axis;
  const Vec3 across(0.8, 0, 0.6);
  struct {
    Vec3 tip;
    TipPlace place;
  } const spots[] = {{middle + 0.0178 * Vec3::UnitY(), TipPlace::mouth},
                     {middle + 0.0182 * Vec3::UnitY(), TipPlace::outside},
                     {middle - 0.0120 * across, TipPlace::mouth},
                     {middle - 0.0182 * across, TipPlace::outside},
                     {front + Vec3(0, 0, 0.0005), TipPlace::outside}};
  for (const auto& spot : spots) {
    Trial at(d);
    at.hold(0.001, spot.tip);
    EXPECT_EQ(at.record.intubation.place, spot.place) << spot.tip.transpose();
    EXPECT_EQ(at.record.intubation.at_mouth_m > 0, spot.place == TipPlace::mouth) << spot.tip.transpose();
  }
  // There the tube is changed, and a mask is held while the blade lies aside as well; not while it is in the mouth.
  const Vec3 aside(0.040, 0.080, 0.010);
  Trial beside(d);
  beside.blade.position = Vec3(0.040, -0.060, 0.010);
  EXPECT_EQ(beside.hold(0.01, aside).place, TipPlace::outside);
  EXPECT_EQ(beside.hold(0.01, aside, kActionCatheter).in_hand, InHand::catheter);
  EXPECT_EQ(beside.hold(0.01, aside).in_hand, InHand::tube);
  EXPECT_EQ(beside.hold(0.01, aside, kActionBreath).breaths_given, 1);
  Trial within(d);
  within.blade.position = Vec3(0.040, 0.010, 0.025);
  EXPECT_EQ(within.hold(0.01, aside, kActionBreath).breaths_given, 0);
  // In a canal it is in, whatever the mouth's radius.
  Trial deep(d);
  EXPECT_EQ(deep.go(kBeforeMouth, testing::kInTrachea).place, TipPlace::trachea);
  EXPECT_EQ(deep.hold(0.01, testing::kInTrachea, kActionCatheter).in_hand, InHand::tube);
}

// What goes in beside the mouth's corner is in a cheek: neither in the mouth nor, deeper, in a canal; a mask still
// fits.
TEST(Intubation, WhatCameThroughTheCheekIsNotInTheMouth) {
  SceneDescription d = intubation_scene();
  d.intubation->mouth = Vec3(0.040, 0.015, testing::kMouthZ);
  d.intubation->mouth_half_width_m = 0.015f;
  for (const double aside : {0.0, 0.0145, -0.0145, 0.0155, -0.0155}) {
    Trial at(d);
    const Vec3 behind = d.intubation->mouth + Vec3(aside, 0, -0.008);
    const bool by_mouth = std::abs(aside) < 0.015;
    const IntubationRecord& r = at.hold(0.001, behind);
    EXPECT_EQ(r.place, by_mouth ? TipPlace::mouth : TipPlace::outside) << aside;
    EXPECT_EQ(r.at_mouth_m > 0, by_mouth) << aside;
    EXPECT_EQ(at.hold(0.01, behind, kActionBreath).breaths_given, by_mouth ? 0 : 1) << aside;
  }
  // The same way in, with the mouth's corner on this and on that side of it.
  for (const float half_width : {0.030f, 0.001f}) {
    d.intubation->mouth = Vec3(0.040 + 0.005, 0.015, testing::kMouthZ);
    d.intubation->mouth_half_width_m = half_width;
    Trial t(d);
    EXPECT_EQ(t.go(kBeforeMouth, testing::kInTrachea).place,
              half_width > 0.01f ? TipPlace::trachea : TipPlace::outside);
  }
}

// What the tube presses on the tongue with is what the hand feels, and the tongue gives way.
TEST(Intubation, TheTonguePressedByTheTubeGivesWayAndBears) {
  SceneDescription d = intubation_scene({10, 10, 5});
  d.intubation->stylet = Stylet{};
  d.intubation->stylet->bend_rad = 0;
  Trial t(d);
  const Vec3 above(0.015, 0.015, 0.020), pressed(0.015, 0.015, 0.012);  // the tongue's top is at 15 mm
  t.hold(0.1, above);
  EXPECT_EQ(t.record.intubation.loads_n[kLoadTongue], 0.0);
  t.go(above, pressed);
  const IntubationRecord& r = t.hold(1.0, pressed);
  const double load = r.loads_n[kLoadTongue];
  EXPECT_GT(load, 0.05);
  // Its sides press on the round tip as well, and cancel.
  EXPECT_GT(r.model_force_n.z(), 0.5 * load);
  EXPECT_LT(r.model_force_n.z(), load);
  EXPECT_NEAR(r.tip_load_n, r.model_force_n.z(), 0.2 * load);
  EXPECT_EQ(r.tip_against, kLoadTongue);
  // As the tissue itself has it.
  EXPECT_NEAR(load, testing::soft_loads(*t.scene, t.loop.state.intubation->soft).tongue_n, 0.1 * load);
  double deepest = 0.0;
  for (const Vec3& u : t.loop.state.tissue.displacement) deepest = std::max(deepest, -u.z());
  EXPECT_GT(deepest, 0.001);
  EXPECT_LT(deepest, 0.004);
  EXPECT_EQ(t.record.faults | r.faults, 0u);
  t.go(pressed, above);
  t.hold(1.0, above);
  for (const Vec3& u : t.loop.state.tissue.displacement) ASSERT_LT(u.norm(), 2e-5);
}

/// Both hands' way to where the tube ends, then `breaths` of 40 a minute through it.
struct Ventilated {
  double before = 0.0, after = 0.0;
  IntubationRecord record;
};
Ventilated ventilate(const std::vector<Vec3>& way, int breaths, TipPlace place) {
  Trial t(intubation_scene());
  t.hold(20.0, way.front());
  for (std::size_t i = 1; i < way.size(); ++i) t.go(way[i - 1], way[i]);
  t.hold(0.2, way.back());
  Ventilated v;
  v.before = t.record.intubation.sao2;
  EXPECT_EQ(t.record.intubation.place, place);
  EXPECT_FALSE(t.record.intubation.detector_yellow);
  v.record = t.hold(1.5 * breaths, way.back(), kActionBreath);
  v.after = v.record.sao2;
  EXPECT_EQ(v.record.breaths_given, breaths);
  EXPECT_EQ(v.record.faults, 0u);
  EXPECT_EQ(t.record.faults, 0u);
  return v;
}

TEST(Intubation, ThroughATubeInTheTracheaTheInfantRecoversAndTheDetectorTurnsYellow) {
  const Ventilated v = ventilate({kBeforeMouth, testing::kInTrachea}, 20, TipPlace::trachea);
  EXPECT_GT(v.after, v.before + 0.05);
  EXPECT_TRUE(v.record.detector_yellow);
  EXPECT_NEAR(v.record.past_cords_m, 0.028, 0.001);
  EXPECT_NEAR(v.record.at_mouth_m, testing::kMouthZ - testing::kInTrachea.z(), 0.001);
}

TEST(Intubation, InAMainBronchusHalfOfTheLungsIsReached) {
  const Ventilated trachea = ventilate({kBeforeMouth, testing::kInTrachea}, 8, TipPlace::trachea);
  const Ventilated bronchus = ventilate({kBeforeMouth, testing::kInBronchus}, 8, TipPlace::main_bronchus);
  EXPECT_EQ(trachea.record.side, -1);
  EXPECT_EQ(bronchus.record.side, 1) << "the left one: the point of a tube held like this goes ahead there";
  EXPECT_GT(bronchus.record.tip_m.x(), 0.040 + 0.001) << "and that is where the tip is: x grows to the left";
  EXPECT_TRUE(bronchus.record.detector_yellow);
  EXPECT_LT(bronchus.after - bronchus.before, trachea.after - trachea.before);
}

TEST(Intubation, InTheOesophagusNothingIsReachedAndTheDetectorStaysPurple) {
  const Ventilated v =
      ventilate({kBeforeMouth, testing::kBeforeOesophagus, testing::kInOesophagus}, 20, TipPlace::oesophagus);
  EXPECT_LT(v.after, v.before - 0.05);
  EXPECT_FALSE(v.record.detector_yellow);
}

// Between two attempts the mask brings the infant back, the tube being out.
TEST(Intubation, BetweenAttemptsTheMaskBringsItBack) {
  Trial t(intubation_scene());
  t.hold(20.0, kBeforeMouth);
  t.go(kBeforeMouth, testing::kBeforeOesophagus);
  t.go(testing::kBeforeOesophagus, testing::kInOesophagus);
  t.hold(9.0, testing::kInOesophagus, kActionBreath);
  t.go(testing::kInOesophagus, testing::kBeforeOesophagus);
  t.go(testing::kBeforeOesophagus, kBeforeMouth);
  EXPECT_EQ(t.record.intubation.place, TipPlace::outside);
  const double low = t.record.intubation.sao2;
  t.hold(30.0, kBeforeMouth, kActionBreath);
  EXPECT_GT(t.record.intubation.sao2, low + 0.1);
  EXPECT_FALSE(t.record.intubation.detector_yellow);
  t.go(kBeforeMouth, testing::kInTrachea);
  EXPECT_EQ(t.hold(0.1, testing::kInTrachea).place, TipPlace::trachea);
}

TEST(Intubation, TubeAndCatheterChangeOutsideTheMouthOnlyAndTheStyletGoesForGood) {
  SceneDescription d = intubation_scene();
  d.intubation->stylet = Stylet{};
  d.intubation->stylet->bend_rad = 0;
  Trial t(d);
  EXPECT_EQ(t.hold(0.01, kBeforeMouth).in_hand, InHand::tube_with_stylet);
  EXPECT_EQ(t.hold(0.01, kBeforeMouth, kActionCatheter).in_hand, InHand::catheter);
  EXPECT_EQ(t.hold(0.01, kBeforeMouth).in_hand, InHand::tube_with_stylet);
  const Vec3 in_mouth(0.040, 0.015, 0.015);
  t.go(kBeforeMouth, in_mouth);
  EXPECT_EQ(t.hold(0.01, in_mouth, kActionCatheter).in_hand, InHand::tube_with_stylet);
  const Vec3 tip = t.record.intubation.tip_m;
  EXPECT_EQ(t.hold(0.001, in_mouth, kActionStyletOut).in_hand, InHand::tube);
  EXPECT_LT((t.record.intubation.tip_m - tip).norm(), 1e-4);  // it keeps its shape, and goes into its own from there
  EXPECT_EQ(t.hold(0.1, in_mouth).in_hand, InHand::tube);
  EXPECT_EQ(t.hold(0.5, kBeforeMouth, kActionCatheter).in_hand, InHand::catheter);
  EXPECT_EQ(t.hold(0.01, kBeforeMouth).in_hand, InHand::tube);
}

TEST(Intubation, SecretionsHideTheGlottisUntilTheCatheterHasDrawnThem) {
  SceneDescription d = intubation_scene();
  // The child lies on its back: the floor is behind the glottis, whose outline reaches from y 12 to 18 mm.
  d.intubation->secretions.floor = Vec3(0.040, 0.019, -0.006);
  d.intubation->secretions.volume_m3 = 1e-6;  // 4 mm high: up to y = 15
  Trial clear(intubation_scene()), t(d);
  const double all = clear.hold(0.03, kBeforeMouth + Vec3(0.1, 0, 0)).faults == 0 ? clear.record.glottis_visible : 0.0;
  ASSERT_GT(all, 0.9);
  t.hold(0.03, kBeforeMouth + Vec3(0.1, 0, 0), kActionCatheter);
  EXPECT_NEAR(t.record.glottis_visible, 0.5 * all, 0.08);
  EXPECT_NEAR(t.record.intubation.secretions_ml, 1.0, 1e-12);

  // Without suction, and with suction beyond the pool, it stays.
  const Vec3 above(0.040, 0.012, -0.002), within(0.040, 0.0178, -0.006);
  t.go(kBeforeMouth, above, kActionCatheter);
  t.hold(0.3, above, kActionCatheter | kActionSuction);
  EXPECT_EQ(t.record.intubation.secretions_ml, 1.0);
  t.go(above, within, kActionCatheter);
  EXPECT_EQ(t.record.intubation.secretions_ml, 1.0);
  t.hold(0.3, within, kActionCatheter | kActionSuction);
  EXPECT_NEAR(t.record.intubation.secretions_ml, 0.7, 0.02);  // an 8 F draws 1 ml/s
  t.hold(1.5, within, kActionCatheter | kActionSuction);
  EXPECT_LT(t.record.intubation.secretions_ml, 0.6);
  t.go(within, kBeforeMouth, kActionCatheter);
  t.hold(0.03, kBeforeMouth + Vec3(0.1, 0, 0));
  EXPECT_GT(t.record.glottis_visible, 0.9 * all);
}

TEST(Intubation, TheTubeHidesWhatIsBehindIt) {
  Trial t(intubation_scene());
  t.hold(0.03, kBeforeMouth + Vec3(0.1, 0, 0));
  const double free = t.record.glottis_visible;
  const Vec3 before_glottis(0.040, 0.012, 0.005);
  t.hold(0.5, before_glottis);
  EXPECT_LT(t.record.glottis_visible, 0.6 * free);
  EXPECT_GT(t.record.glottis_visible, 0.0);  // 5 mm of tube do not hide a glottis of 6 x 6 mm
}

TEST(Intubation, ThePressMovesTheLarynxByThreeMillimetresAndLetsItBack) {
  SceneDescription d = intubation_scene();
  const double n = press_for(*d.intubation, d.soft.bodies, 0.003);
  EXPECT_NEAR(n, 0.003 * 80.0 / 0.25, 1e-12);  // half of the body's way, by half of the force
  d.intubation->press_n = n;
  d.sight.followers = {{testing::kSceneLarynx, 0.5, {}}};
  Trial t(d);
  const auto way = [&t] { return 0.5 * t.loop.state.tissue.body_displacement[testing::kSceneLarynx]; };
  double fastest = 0.0, last = 0.0;
  for (int k = 0; k < 1500; ++k) {
    t.hold(0.001, kBeforeMouth, kActionPress);
    fastest = std::max(fastest, std::abs(way().y() - last) / 0.001);
    last = way().y();
  }
  EXPECT_LT((way() - Vec3(0, 0.003, 0)).norm(), 5e-5);
  EXPECT_LT(fastest, 0.02);  // m/s: it does not fall in
  t.hold(1.5, kBeforeMouth);
  EXPECT_LT(way().norm(), 5e-5);
  EXPECT_EQ(t.record.faults, 0u);
  EXPECT_EQ(t.record.intubation.faults, 0u);
}

}  // namespace
}  // namespace vallecula::engine
