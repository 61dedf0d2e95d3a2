// What a passage is built from and given: descriptions that contradict themselves, numbers that are none, wild hands.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "engine/physiology/draw.h"
#include "tests/engine/allocations.h"
#include "tests/engine/tube/airways.h"

namespace vallecula::engine {
namespace {

using namespace testing;  // airways.h

std::string refusal(const std::function<void(AirwayCourse&)>& spoil, const Vec3& mouth_inward = -Vec3::UnitZ()) {
  AirwayCourse course = straight_airway();
  spoil(course);
  try {
    const Passage passage(course, Glottis{}, Vec3::Zero(), mouth_inward);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(PassageInput, ADescriptionThatIsNoAirwayIsRefusedByName) {
  EXPECT_EQ(refusal([](AirwayCourse&) {}), "");
  struct Case {
    std::function<void(AirwayCourse&)> spoil;
    std::string named;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Case> cases = {
      {[](AirwayCourse& c) { c.airway.resize(1); }, "has 1 rings"},
      {[](AirwayCourse& c) { c.oesophagus.clear(); }, "oesophagus has 0 rings"},
      {[](AirwayCourse& c) { c.bronchi[1].resize(1); }, "left main bronchus has 1 rings"},
      {[](AirwayCourse& c) { c.airway.resize(7); }, "has 0 rings at the cords"},
      {[](AirwayCourse& c) { c.airway[6].part = AirwayPart::cords; }, "has 2 rings at the cords"},
      {[](AirwayCourse& c) { c.airway[9].part = AirwayPart::trachea; }, "ring 10 is out of order"},
      {[](AirwayCourse& c) { c.airway[20].part = AirwayPart::oesophagus; }, "ring 20 is out of order"},
      {[](AirwayCourse& c) { c.airway.resize(15); }, "no ring in the trachea"},
      {[](AirwayCourse& c) { c.oesophagus[3].part = AirwayPart::trachea; }, "a ring of another part"},
      {[](AirwayCourse& c) { c.airway[4].along *= 1.5; }, "ring 4 has a length of 1.5"},
      {[](AirwayCourse& c) { c.airway[4].left = Vec3(0, 0.6, -0.8); }, "ring 4 are not at right angles"},
      {[](AirwayCourse& c) { c.airway[5].to_back_m = 0.0; }, "ring 5 is 0.000000 mm"},
      {[nan](AirwayCourse& c) { c.airway[5].to_left_m = nan; }, "ring 5 is nan mm"},
      {[nan](AirwayCourse& c) { c.oesophagus[2].centre.y() = nan; }, "oesophagus's ring 2 is not finite"},
      {[](AirwayCourse& c) { c.airway[8].larynx_share = 1.2; }, "share of 1.2"},
      {[](AirwayCourse& c) { c.airway.erase(c.airway.begin() + 20, c.airway.begin() + 24); }, "lies 5.000000 mm from"},
      {[](AirwayCourse& c) { c.airway[21].centre = c.airway[20].centre; }, "lies 0.000000 mm from"},
      {[](AirwayCourse& c) { c.airway[21].centre.z() += 0.002; }, "ring 21 does not lie beyond"},
      {[](AirwayCourse& c) {
         for (AirwayRing& r : c.bronchi[0]) r.centre.x() -= 0.02;
       },
       "right main bronchus's ring 0 lies"}};
  for (const Case& c : cases) {
    const std::string said = refusal(c.spoil);
    EXPECT_NE(said.find(c.named), std::string::npos) << "\"" << said << "\" does not say: " << c.named;
  }
  EXPECT_NE(refusal([](AirwayCourse&) {}, Vec3(0, 0, -2)).find("length is 2"), std::string::npos);
}

/// A hand that wanders about the airway, pushes, turns and draws back; the same for the same seed.
class WildHand {
 public:
  WildHand(const Rod& rod, std::uint64_t seed) : start_(hand_with_tip_at(rod, Vec3(0, 0, 0.002))) {
    draw_.state = seed;
  }

  Pose next() {
    if (left_ <= 0) {
      left_ = draw_.between(50, 300);
      from_ = at_;
      to_ = {draw_.between(-0.02, 0.02), draw_.between(-0.02, 0.02), draw_.between(-0.08, 0.01),
             draw_.between(-0.5, 0.5),   draw_.between(-0.5, 0.5),   draw_.between(-2.0, 2.0)};
      ticks_ = left_;
    }
    left_ -= 1;
    for (std::size_t i = 0; i < 6; ++i) at_[i] = from_[i] + (to_[i] - from_[i]) * (1 - std::max(0.0, left_) / ticks_);
    Pose hand;
    hand.position = start_.position + Vec3(at_[0], at_[1], at_[2]);
    hand.rotation = Quat(Eigen::AngleAxisd(at_[3], Vec3::UnitX())) * Quat(Eigen::AngleAxisd(at_[4], Vec3::UnitY())) *
                    start_.rotation * Quat(Eigen::AngleAxisd(at_[5], Vec3::UnitX()));
    return hand;
  }

 private:
  Pose start_;
  Draw draw_;
  double left_ = 0.0, ticks_ = 1.0;
  std::array<double, 6> at_{}, from_{}, to_{};
};

/// How far the tube's axis lies outside a ring's outline where it crosses the ring's plane; the farthest of all, where
/// the tube is whole (beside the bevel its axis is not in it).
double farthest_outside(const TubeInAirway& a) {
  double most = -1.0;
  const Passage::Chain& chain = a.passage.chain(a.in.canal, a.in.side);
  const int whole = static_cast<int>(std::ceil(a.outside.bevel_length() / a.rod.segment_m()));
  for (int i = whole; i + 1 < a.in.inside; ++i)
    for (int k = a.in.passed[static_cast<std::size_t>(i) + 1] + 1; k <= a.in.passed[static_cast<std::size_t>(i)]; ++k) {
      const Passage::Ring& r = chain[static_cast<std::size_t>(k)];
      const Vec3 &deep = a.state.position[static_cast<std::size_t>(i)],
                 &high = a.state.position[static_cast<std::size_t>(i) + 1];
      const double in = r.beyond(deep, Vec3::Zero()), out = r.beyond(high, Vec3::Zero());
      if (!(in >= 0 && out < 0)) continue;
      const Vec3 offset = deep + in / (in - out) * (high - deep) - r.cut.centre;
      const double x = offset.dot(r.cut.left), y = offset.dot(r.front);
      const double a_x = x > 0 ? r.cut.to_left_m : r.cut.to_right_m, a_y = y > 0 ? r.cut.to_front_m : r.cut.to_back_m;
      const double within = std::hypot(x / a_x, y / a_y);  // 1 on the outline
      most = std::max(most, within > 0 ? std::hypot(x, y) * (1 - 1 / within) : -1.0);
    }
  return most;
}

TEST(PassageInput, NoHandPushesATubeThroughAWall) {
  double most = -1.0, most_force = 0.0;
  int inside = 0, deep = 0, gullet = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const TubeDesign design = tube_design(seed % 2 == 0 ? "3.5" : "2.5");
    Stylet stylet;
    const RodDescription d = tube_rod(design, seed % 3 == 0 ? &stylet : nullptr, 0.1);
    const Rod rod(d);
    WildHand hand(rod, seed);
    TubeInAirway a(straight_airway(), design, d, hand.next());
    a.input.glottis_opening = 0.55;
    for (int n = 0; n < 2000; ++n) {
      const RodStep r = a.step(hand.next());
      ASSERT_EQ(r.faults, kRodFaultNone) << seed << " " << n;
      ASSERT_EQ(a.faults, kPassageFaultNone) << seed << " " << n;
      most_force = std::max(most_force, r.on_hand.force.norm());
      inside += a.in.inside > 0;
      deep += a.in.inside > 8;
      gullet += a.in.canal == Canal::oesophagus;
      if (r.on_hand.force.norm() > 10 || a.in.inside == 0 || a.in.canal == Canal::oesophagus) continue;
      const double outside = farthest_outside(a);
      most = std::max(most, outside);
      ASSERT_LT(outside, 0.001) << seed << " " << n;
    }
  }
  EXPECT_GT(inside, 4000);
  EXPECT_GT(deep, 1000);
  EXPECT_GT(most_force, 3.0);
  EXPECT_GT(gullet, 0);
  RecordProperty("farthest_um", static_cast<int>(1e6 * most));
}

TEST(PassageInput, ATickAllocatesNothingAndIsTheSameToTheBit) {
  const TubeDesign design = tube_design("3.5");
  const RodDescription d = tube_rod(design, nullptr, 0.1);
  const Rod rod(d);
  WildHand hands(rod, 4), again(rod, 4);
  TubeInAirway a(straight_airway(), design, d, hands.next()), b(straight_airway(), design, d, again.next());
  int most_contacts = 0;
  for (int n = 0; n < 1500; ++n) {
    const Pose hand = hands.next(), same = again.next();
    const long before = allocations;
    a.step(hand);
    EXPECT_EQ(allocations, before);
    b.step(same);
    ASSERT_EQ(std::memcmp(a.state.position.data(), b.state.position.data(), sizeof a.state.position), 0) << n;
    ASSERT_EQ(a.contacts->count, b.contacts->count);
    most_contacts = std::max(most_contacts, a.contacts->count);
    ASSERT_EQ(a.in.passed, b.in.passed);
    ASSERT_EQ(std::memcmp(a.loads.loads_n.data(), b.loads.loads_n.data(), sizeof a.loads.loads_n), 0);
  }
  EXPECT_GT(most_contacts, 20);
}

TEST(PassageInput, WhatIsNoNumberIsLeftOutAndNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TubeDesign design = tube_design("3.5");
  const RodDescription d = tube_rod(design, nullptr, 0.1);
  const Pose hand = hand_with_tip_at(Rod(d), Vec3(0, 0, -0.001));
  TubeInAirway a(straight_airway(), design, d, hand);
  a.step(hand);
  EXPECT_EQ(a.faults, kPassageFaultNone);
  ASSERT_EQ(a.in.canal, Canal::airway);

  a.input.larynx_way.x() = nan;
  a.step(hand);
  EXPECT_EQ(a.faults, kPassageFaultLarynx);
  a.input.larynx_way.setZero();
  a.input.glottis_opening = nan;
  a.step(hand);
  EXPECT_EQ(a.faults, kPassageFaultLarynx);
  a.input.glottis_opening = 1.0;
  a.input.friction = nan;  // the usual one is taken
  a.step(hand);
  EXPECT_EQ(a.faults, kPassageFaultNone);
  for (const Vec3& x : a.state.position) ASSERT_TRUE(x.allFinite());

  a.state.position[7].y() = nan;
  EXPECT_EQ(find_contacts(a.passage, a.in, a.outside, a.rod, a.state, a.input, 0.001, *a.contacts), kPassageFaultTube);
  EXPECT_EQ(a.contacts->count, 0);
  EXPECT_EQ(a.in.canal, Canal::none);
}

TEST(PassageInput, MoreContactsThanThereIsRoomForAreCounted) {
  TubeContacts contacts;
  for (int n = 0; n < kMostTubeContacts + 3; ++n) contacts.add(RodContact{}, ContactTag{});
  EXPECT_EQ(contacts.count, kMostTubeContacts);
  EXPECT_EQ(contacts.left_out, 3);
  contacts.clear();
  EXPECT_EQ(contacts.left_out, 0);
}

}  // namespace
}  // namespace vallecula::engine
