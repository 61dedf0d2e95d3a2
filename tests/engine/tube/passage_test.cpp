// A tube's way in: what passes and what jams, where its tip is, in and out again, sides, the gullet.
#include "engine/tube/passage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/tube/airways.h"

namespace vallecula::engine {
namespace {

using namespace testing;  // airways.h

constexpr double kStart = 0.002;  // m above the inlet
constexpr double kSpeed = 0.01;   // m/s, of a hand that pushes

struct Pushed {
  double most_n = 0.0;        ///< back along the tube, on the hand
  double past_cords_m = 0.0;  ///< in the end
};

/// The hand goes down by `way` and then holds still for a moment; it stops at `limit_n`, as a hand does.
Pushed push(TubeInAirway& a, const Pose& hand, double way, double limit_n) {
  Pushed p;
  Pose h = hand;
  for (double gone = 0; gone < way; gone += kSpeed * TubeInAirway::kStep) {
    const double force = a.step(h).on_hand.force.z();
    p.most_n = std::max(p.most_n, force);
    if (force >= limit_n) break;
    h.position.z() -= kSpeed * TubeInAirway::kStep;
  }
  p.past_cords_m = a.past_cords();
  return p;
}

/// Held a centimetre before the lips when it is as deep as the rule of CLINICAL has it (weight + 6 cm).
double grip_of(const TubeDesign& tube) {
  return tube.inner_diameter < 0.003 ? 0.08 : tube.inner_diameter < 0.0035 ? 0.09 : 0.10;
}

/// A usual tube that points straight down the airway.
struct UsualTube {
  explicit UsualTube(const char* size, const AirwaySizes& sizes = {}, const Stylet* stylet = nullptr,
                     const Glottis& glottis = {}, double turn = 0.0)
      : design(tube_design(size)),
        description(tube_rod(design, stylet, grip_of(design))),
        hand(hand_with_tip_at(Rod(description), Vec3(0, 0, kStart), turn)),
        airway(straight_airway(sizes), design, description, hand, glottis) {}

  TubeDesign design;
  RodDescription description;
  Pose hand;
  TubeInAirway airway;
};

Stylet straight_stylet() {
  Stylet s;
  s.bend_rad = 0.0;
  return s;
}

AirwaySizes with_cricoid(double diameter_m) {
  AirwaySizes a;
  a.cricoid_side = 0.9 * diameter_m / 2;
  a.cricoid_front = diameter_m / 2 / 0.9;
  a.trachea = 1.28 * diameter_m / 2;
  return a;
}

// CLINICAL's table of tubes by weight; the cricoids of smaller infants are assumed to be to theirs as 5.0 mm is to
// a 3.5.
TEST(Passage, TheTableOfSizes) {
  struct Row {
    double cricoid_m;
    const char *smaller, *right, *larger;
  };
  for (const Row& row :
       {Row{0.0036, nullptr, "2.5", "3.0"}, Row{0.0042, "2.5", "3.0", "3.5"}, Row{0.0050, "3.0", "3.5", "4.0"}}) {
    const Stylet stylet = straight_stylet();
    for (const Stylet* with : {static_cast<const Stylet*>(nullptr), &stylet}) {
      if (row.smaller) {
        UsualTube tube(row.smaller, with_cricoid(row.cricoid_m), with);
        const Pushed p = push(tube.airway, tube.hand, 0.035, 7.9);
        EXPECT_GT(p.past_cords_m, 0.020) << row.smaller;
        EXPECT_LT(p.most_n, 0.15) << row.smaller;
      }
      UsualTube right(row.right, with_cricoid(row.cricoid_m), with);
      const Pushed p = push(right.airway, right.hand, 0.035, 7.9);
      EXPECT_GT(p.past_cords_m, 0.020) << row.right;
      EXPECT_GT(p.most_n, 0.25) << row.right;
      EXPECT_LT(p.most_n, 1.5) << row.right;
      EXPECT_EQ(right.airway.tip_place(), TipPlace::trachea);
      UsualTube large(row.larger, with_cricoid(row.cricoid_m), with);
      const Pushed jammed = push(large.airway, large.hand, 0.060, 7.9);
      // Its tip's point enters the ring, its full width does not.
      EXPECT_LT(jammed.past_cords_m, 0.006 + 0.003 + large.airway.outside.bevel_length()) << row.larger;
      EXPECT_GT(jammed.most_n, p.most_n) << row.larger;
    }
  }
}

TEST(Passage, FarTooLargeATubeStopsAtTheCricoid) {
  const Stylet stylet = straight_stylet();
  UsualTube tube("4.0", with_cricoid(0.0042), &stylet);
  const Pushed p = push(tube.airway, tube.hand, 0.06, 7.9);
  EXPECT_GE(p.most_n, 7.9);
  EXPECT_LT(p.past_cords_m, 0.010);
  EXPECT_EQ(tube.airway.loads.tip_against, static_cast<std::uint8_t>(AirwayPart::cricoid));
  EXPECT_GT(tube.airway.loads.tip_load_n, 2.0);
}

TEST(Passage, ATubeThatJamsBuckles) {
  UsualTube tube("4.0");
  const Pushed p = push(tube.airway, tube.hand, 0.060, 7.9);
  EXPECT_LT(p.most_n, 4.0);  // it gives way before the hand's limit
  // The hand has gone on and the tube stands aside of the straight way.
  double aside = 0.0;
  RodState hanging(tube.airway.rod, tube.airway.state.grip);
  for (int i = 0; i < kTubeNodes; ++i)
    aside = std::max(
        aside, (tube.airway.state.position[static_cast<std::size_t>(i)] - hanging.position[static_cast<std::size_t>(i)])
                   .norm());
  EXPECT_GT(aside, 0.015);
}

TEST(Passage, RelaxedCordsYieldAndShutOnesHold) {
  const Stylet stylet = straight_stylet();
  for (const char* size : {"2.5", "3.0", "3.5", "4.0"}) {
    UsualTube relaxed(size, {}, &stylet);
    relaxed.airway.input.glottis_opening = 0.55;  // of cords that nothing moves
    const Pushed through = push(relaxed.airway, relaxed.hand, 0.013, 7.9);
    EXPECT_GT(through.past_cords_m, 0.003) << size;
    EXPECT_LT(through.most_n, 0.5) << size;

    for (const Stylet* with : {static_cast<const Stylet*>(nullptr), &stylet}) {
      UsualTube shut(size, {}, with);
      shut.airway.input.glottis_opening = 0.0;
      const Pushed held = push(shut.airway, shut.hand, 0.030, 3.3);
      EXPECT_LT(held.past_cords_m, shut.airway.outside.bevel_length()) << size;
      EXPECT_GT(shut.airway.loads.glottis_n, 0.3) << size;
      EXPECT_NEAR(shut.airway.loads.vagal_n, shut.airway.loads.glottis_n, 1e-12);
    }
  }
}

TEST(Passage, CordsThatShutAboutATubeHoldItGently) {
  UsualTube tube("3.0");
  push(tube.airway, tube.hand, 0.030, 7.9);
  Pose hand = tube.hand;
  hand.position.z() -= 0.030;
  const double before = tube.airway.loads.loads_n[static_cast<int>(AirwayPart::cords)];
  double most_change = 0.0, last = before;
  for (int n = 0; n < 500; ++n) {
    tube.airway.input.glottis_opening = std::max(0.0, 1.0 - n / 80.0);
    tube.airway.step(hand);
    const double now = tube.airway.loads.loads_n[static_cast<int>(AirwayPart::cords)];
    most_change = std::max(most_change, std::abs(now - last));
    last = now;
  }
  EXPECT_GT(last, before + 0.5);
  EXPECT_LT(last, 2.0);
  EXPECT_LT(most_change, 0.1);  // no blow
}

TEST(Passage, DownTheAirwayAndOutAgain) {
  UsualTube tube("3.0");
  Pose outside = tube.hand;
  outside.position.z() += 0.075;
  tube.airway.state.set_rest(tube.airway.rod, outside);
  std::vector<TipPlace> seen;
  double before = tube.airway.past_cords();
  const auto go = [&](double from, double to) {
    const int steps = static_cast<int>(std::abs(to - from) / (0.04 * TubeInAirway::kStep));
    for (int n = 0; n <= steps; ++n) {
      Pose hand = tube.hand;
      hand.position.z() += from + (to - from) * n / steps;
      tube.airway.step(hand);
      if (seen.empty() || seen.back() != tube.airway.tip_place()) seen.push_back(tube.airway.tip_place());
      const double now = tube.airway.past_cords();
      EXPECT_LT(std::abs(now - before), 0.0012);  // it makes no leaps
      before = now;
    }
  };
  go(0.075, 0.0);
  go(0.0, -0.070);
  const std::vector<TipPlace> in = {TipPlace::outside, TipPlace::mouth, TipPlace::larynx, TipPlace::trachea,
                                    TipPlace::main_bronchus};
  EXPECT_EQ(seen, in);
  EXPECT_EQ(tube.airway.in.side, 0);  // the right, as in life
  EXPECT_GT(tube.airway.past_cords(), 0.050);
  EXPECT_LT(tube.airway.past_cords(), 0.065);
  go(-0.070, 0.075);
  const std::vector<TipPlace> and_out = {TipPlace::outside, TipPlace::mouth,         TipPlace::larynx,
                                         TipPlace::trachea, TipPlace::main_bronchus, TipPlace::trachea,
                                         TipPlace::larynx,  TipPlace::mouth,         TipPlace::outside};
  EXPECT_EQ(seen, and_out);
  EXPECT_EQ(tube.airway.in.inside, 0);
  EXPECT_EQ(tube.airway.contacts->count, 0);
  EXPECT_EQ(tube.airway.loads.tip_against, 255);
}

TEST(Passage, KnowsHowDeepItIs) {
  const TubeDesign design = tube_design("2.5");
  const RodDescription d = stiff_rod(design);
  TubeInAirway a(straight_airway(), design, d, hand_above(Vec3(0, 0, kStart), d.length_m));
  EXPECT_NEAR(a.passage.cords_to_carina_m(), 0.050, 1e-9);
  for (double z = kStart; z > -0.05; z -= 0.0003) {
    a.step(hand_above(Vec3(0, 0, z), d.length_m));
    const double tip = a.state.position[0].z();
    EXPECT_NEAR(at_mouth_m(a.passage, a.rod, a.state, 0.0), 0.06 - tip, 2e-5);  // the mouth's front is at z = 60 mm
    EXPECT_NEAR(at_mouth_m(a.passage, a.rod, a.state, 0.006), 0.066 - tip, 2e-5) << "lips 6 mm before the gums";
    if (a.in.inside == 0) continue;  // it is let in with the next tick
    EXPECT_NEAR(a.past_cords(), -tip - 0.007, 1e-9);
    EXPECT_NEAR(inside_canal_m(a.passage, a.in, a.rod, a.state, Vec3::Zero()), -tip, 2e-5);
  }
}

TEST(Passage, TheTipsPointChoosesTheBronchus) {
  for (double aside : {-0.0008, 0.0, 0.0008})
    for (double turn : {0.0, M_PI}) {
      const TubeDesign design = tube_design("2.5");
      const RodDescription d = stiff_rod(design);
      TubeInAirway a(straight_airway(), design, d, hand_above(Vec3(aside, 0, kStart), d.length_m, turn));
      int side = -1;
      for (double z = kStart; z > -0.0575 && side < 0; z -= 0.00002) {
        a.step(hand_above(Vec3(aside, 0, z), d.length_m, turn));
        side = a.in.side;
      }
      // The opening faces the patient's left, its point lies at the right; turned round at the left.
      EXPECT_EQ(side, turn == 0 ? 0 : 1) << aside << " " << turn;
      EXPECT_EQ(a.tip_place(), TipPlace::main_bronchus);
      // Drawn back above the carina and turned round it takes the other one.
      for (double z = -0.0575; z < -0.054; z += 0.00002) a.step(hand_above(Vec3(aside, 0, z), d.length_m, turn));
      EXPECT_EQ(a.in.side, -1);
      EXPECT_EQ(a.tip_place(), TipPlace::trachea);
    }
  // In the middle and neither to the right nor to the left: the right.
  TubeDesign blunt = tube_design("2.5");
  blunt.bevel_rad = M_PI / 2;
  const RodDescription d = stiff_rod(blunt);
  TubeInAirway a(straight_airway(), blunt, d, hand_above(Vec3(0, 0, kStart), d.length_m));
  for (double z = kStart; z > -0.0575; z -= 0.00002) a.step(hand_above(Vec3(0, 0, z), d.length_m));
  EXPECT_EQ(a.in.side, 0);
}

TEST(Passage, IntoTheGulletAndNeverAcross) {
  UsualTube tube("3.5");
  Pose hand = tube.hand;
  hand.position.y() += 0.009;  // behind the larynx; 1 mm before the middle of the gullet's mouth
  hand.position.z() += 0.005;
  tube.airway.state.set_rest(tube.airway.rod, hand);
  const Pushed p = push(tube.airway, hand, 0.060, 7.9);
  EXPECT_EQ(tube.airway.tip_place(), TipPlace::oesophagus);
  EXPECT_GT(p.past_cords_m, 0.035);  // there from its mouth
  EXPECT_GT(p.most_n, 0.02);         // collapsed walls rub
  EXPECT_LT(p.most_n, 0.8);
  EXPECT_GT(tube.airway.loads.loads_n[static_cast<int>(AirwayPart::oesophagus)], 0.1);
  EXPECT_EQ(tube.airway.loads.vagal_n, 0.0);
  // The hand goes forward by 20 mm: the tube bends, and is where it was.
  hand.position.z() -= 0.060;
  for (int n = 0; n < 400; ++n) {
    hand.position.y() -= 0.00005;
    tube.airway.step(hand);
    ASSERT_EQ(tube.airway.tip_place(), TipPlace::oesophagus);
  }
}

TEST(Passage, ASlantedTipIsTurnedAwayFromTheFrontWall) {
  // Pointing 20 degrees forward the tip meets the front wall and slides down along it.
  UsualTube tube("2.5");
  Pose hand = tube.hand;
  const Quat forward(Eigen::AngleAxisd(0.35, -Vec3::UnitX()));
  const Vec3 tip(0, 0, kStart);
  hand.position = tip + forward * (hand.position - tip);
  hand.rotation = forward * hand.rotation;
  TubeInAirway& a = tube.airway;
  a.state.set_rest(a.rod, hand);
  const Vec3 way = forward * -Vec3::UnitZ();
  ASSERT_LT(way.y(), -0.3);  // to the front
  double front = 0.0;
  for (int n = 0; n < 3500; ++n) {
    hand.position += 1e-5 * way;
    a.step(hand);
    for (int i = 0; i < a.contacts->count; ++i)
      front = std::max(front, a.contacts->contact[static_cast<std::size_t>(i)].force.y());
  }
  EXPECT_GT(front, 0.01);
  EXPECT_GT(a.past_cords(), 0.010);
  EXPECT_EQ(a.tip_place(), TipPlace::trachea);
}

TEST(Passage, TheLarynxCarriesTheTubeAndIsCarried) {
  AirwaySizes sizes;
  sizes.cord_share = 0.5;
  UsualTube tube("3.5", sizes);
  push(tube.airway, tube.hand, 0.035, 7.9);
  Pose hand = tube.hand;
  hand.position.z() -= 0.035;
  for (int n = 0; n < 300; ++n) tube.airway.step(hand);
  const double at_rest = tube.airway.loads.on_larynx.y();
  for (int n = 0; n < 300; ++n) {
    tube.airway.input.larynx_way = Vec3(0, -1e-5 * n, 0);  // 3 mm to the front, of which the cricoid goes half
    tube.airway.input.larynx_velocity = Vec3(0, -0.01, 0);
    tube.airway.step(hand);
  }
  tube.airway.input.larynx_velocity.setZero();
  for (int n = 0; n < 300; ++n) tube.airway.step(hand);
  EXPECT_GT(tube.airway.loads.on_larynx.y(), at_rest + 0.005);  // the tube holds it back
  const Vec3 crossing = frame_at(tube.airway.rod, tube.airway.state, 0.021).position;
  EXPECT_LT(crossing.y(), -0.0002);
  EXPECT_GT(tube.airway.loads.on_larynx_stiffness(1, 1), 10.0);
}

}  // namespace
}  // namespace vallecula::engine
