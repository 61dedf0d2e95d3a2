// The passage against what can be reckoned from outside: the bevelled end's shape by points of its surface, rings by
// points of their outlines, friction and work by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/tube/airways.h"

namespace vallecula::engine {
namespace {

using namespace testing;  // airways.h

/// Without a wall, so without a rounded rim.
TubeDesign sharp_tube() {
  TubeDesign t = tube_design("3.5");
  t.inner_diameter = t.outer_diameter * (1 - 1e-9);
  return t;
}

/// A canal of one width from the inlet to the carina: the part is the cricoid's, then the trachea's.
AirwayCourse even_canal(double side, double front, double spacing, AirwayPart part = AirwayPart::trachea) {
  AirwayCourse c;
  for (double deep = 0; deep < 0.06; deep += spacing)
    c.airway.push_back(ring_at(-deep, side, front, deep == 0 ? AirwayPart::cords : part));
  if (part != AirwayPart::trachea) c.airway.back().part = AirwayPart::trachea;
  const double carina = -c.airway.back().centre.z();
  for (int i = 0; i < 2; ++i)
    c.bronchi[static_cast<std::size_t>(i)] =
        branch(Vec3(0, 0, -carina - spacing), 0.0, side, 0.02, spacing, AirwayPart::main_bronchus);
  c.oesophagus = branch(Vec3(0, 0.02, 0), 0.0, 0.0005, 0.02, 0.001, AirwayPart::oesophagus);
  return c;
}

TEST(PassageTruth, TheBevelledEndReachesAsFarAsItsPoints) {
  const TubeDesign design = sharp_tube();
  const TubeOutside outside(design);
  const double r = design.outer_diameter / 2;
  EXPECT_NEAR(outside.bevel_length(), design.outer_diameter / std::tan(design.bevel_rad), 1e-12);
  // Axis x from the tip, the opening faces -y: a point of the tube is there if it lies beyond the plane through the
  // tip's point (0, r, 0) whose angle to the axis is the bevel's.
  const auto there = [&](double s, double y) { return s * std::tan(design.bevel_rad) >= r - y - 1e-12; };
  for (double s : {0.0003, 0.001, 0.002, 0.0032, 0.005, 0.0063, 0.008})
    for (int n = 0; n < 16; ++n) {
      const double angle = 2 * M_PI * n / 16 + 0.1;
      const Vec3 u(0, std::cos(angle), std::sin(angle));
      double most = -1.0;
      for (int i = 0; i < 2000; ++i)
        for (double radius : {r, 0.0}) {
          const double a = 2 * M_PI * i / 2000;
          const Vec3 p(s, radius * std::cos(a), radius * std::sin(a));
          if (radius > 0 && there(s, p.y())) most = std::max(most, p.dot(u));
        }
      // The chord's own points lie between two of the rim.
      EXPECT_NEAR(outside.reach(u, s).m, most, 2e-5) << s << " " << angle;
      const double step = 1e-7;
      const double slope = (outside.reach(u, s + step).m - outside.reach(u, s - step).m) / (2 * step);
      EXPECT_NEAR(outside.reach(u, s).slope, std::min(slope, 3.0), 1e-3);
    }
  // With its round rim it nowhere reaches farther, and the balls in it lie within it.
  const TubeOutside round(tube_design("3.5"));
  for (double s = 0; s < 0.01; s += 0.0002)
    for (int n = 0; n < 16; ++n) {
      const Vec3 u(0, std::cos(0.4 * n), std::sin(0.4 * n));
      EXPECT_LE(round.reach(u, s).m, outside.reach(u, s).m + 1e-12);
      const TubeOutside::Ball ball = round.ball(s);
      if (s < 0.001) continue;
      EXPECT_LE(ball.aside_m * u.y() + ball.radius_m, outside.reach(u, s).m + 1e-9) << s;
    }
}

TEST(PassageTruth, ARingIsMetWhereItsOutlineIs) {
  // A short stiff tube across one place of an elliptical canal, at many places of its middle: the deepest contact is as
  // deep as the tube's rim lies outside the outline, measured by points of it; what eight directions leave open between
  // them is a tenth of the play at most.
  const TubeDesign design = sharp_tube();
  const double r = design.outer_diameter / 2, side = 0.0032, front = 0.0041;
  const RodDescription d = stiff_rod(design);
  for (int n = 0; n < 24; ++n)
    for (double beyond : {0.0001, 0.0002}) {
      const double angle = 2 * M_PI * n / 24;
      const Vec3 u(std::cos(angle), -std::sin(angle), 0);
      // The tube's middle as far out as makes its rim lie `beyond` the outline.
      const auto outside_by = [&](double way) {
        double most = -1.0;
        for (int i = 0; i < 720; ++i) {
          const double a = 2 * M_PI * i / 720;
          const Vec3 out(std::cos(a), -std::sin(a), 0);
          const double reach = std::hypot(side * std::cos(a), front * std::sin(a));
          most = std::max(most, (way * u).dot(out) + r - reach);
        }
        return most;
      };
      double low = 0, high = 0.003;
      for (int i = 0; i < 60; ++i) (outside_by((low + high) / 2) < beyond ? low : high) = (low + high) / 2;
      TubeInAirway a(even_canal(side, front, 0.001), design, d, hand_above(low * u + Vec3(0, 0, -0.04), d.length_m));
      a.in.canal = Canal::airway;  // put there
      a.in.inside = 1;
      find_contacts(a.passage, a.in, a.outside, a.rod, a.state, a.input, 0.0, *a.contacts);
      double deepest = -1.0;
      for (int i = 0; i < a.contacts->count; ++i) {
        const RodContact& c = a.contacts->contact[static_cast<std::size_t>(i)];
        if (c.node < 4 || a.contacts->tag[static_cast<std::size_t>(i)].load == 1) continue;  // bevel; cords
        deepest = std::max(deepest, c.depth_m);
      }
      EXPECT_LT(deepest, beyond + 1e-6) << angle;
      EXPECT_GT(deepest, beyond - 0.10 * (low + 1e-4)) << angle;
      if (n % 6 != 0) continue;
      EXPECT_NEAR(deepest, beyond, 1e-6);  // at the ellipse's apices exactly
    }
}

TEST(PassageTruth, ForcesDoNotDependOnHowCloselyRingsFollow) {
  // Pressed aside along 40 mm of an even canal by a stiff straight tube: the wall's springs add up to length times
  // depth.
  const TubeDesign design = tube_design("3.5");
  const RodDescription d = stiff_rod(design);
  const double room = 0.003 - design.outer_diameter / 2;
  // From one depth to another, since the cords, aside of whose middle it lies, push as well.
  double first = 0.0;
  for (double spacing : {0.0005, 0.001, 0.002, 0.004}) {
    double force[2];
    for (int n_depth = 0; n_depth < 2; ++n_depth) {
      const double depth = 0.0001 * (1 + n_depth);
      TubeInAirway a(even_canal(0.003, 0.003, spacing), design, d, hand_above(Vec3(0, 0, 0.001), d.length_m));
      a.input.friction = 0.0;
      for (int n = 0; n < 1020; ++n) a.step(hand_above(Vec3(0, 0, 0.001 - 4e-5 * n), d.length_m));
      Pose hand;
      for (int n = 0; n < 200; ++n) {
        hand = hand_above(Vec3((room + depth) * std::min(1.0, n / 100.0), 0, 0.001 - 0.0408), d.length_m);
        a.step(hand);
      }
      force[n_depth] = -a.step(hand).on_hand.force.x();
    }
    const double stiffness = (force[1] - force[0]) / 0.0001;
    if (first == 0) first = stiffness;
    // Half of the first interval is the cords': with rings 4 mm apart 2 of 40 mm.
    EXPECT_NEAR(stiffness, first, 0.05 * first) << spacing;
  }
  EXPECT_GT(first, 1000.0);
}

/// A narrow stretch of 8 mm, 20 mm below the inlet.
AirwayCourse narrow_canal(double side, double spacing) {
  AirwayCourse c = even_canal(0.004, 0.004, spacing, AirwayPart::cricoid);
  for (AirwayRing& r : c.airway)
    if (r.centre.z() < -0.02 && r.centre.z() > -0.028) r.to_left_m = r.to_right_m = side;
  return c;
}

struct Work {
  double in_j = 0.0, most_n = 0.0, last_n = 0.0, normal_n = 0.0;
  double stored_j = 0.0;  ///< of the walls' springs, from their forces and depths
};

/// Pushes on from `from` to `to` (m below the inlet) and adds up the hand's work.
Work work_of(TubeInAirway& a, double length, double from, double to) {
  Work w;
  const int steps = static_cast<int>(std::abs(to - from) / 1e-5);
  const double move = (to - from) / steps;
  for (int n = 0; n < steps; ++n) {
    w.last_n = a.step(hand_above(Vec3(0, 0, -from - move * n), length)).on_hand.force.z();
    w.in_j += w.last_n * move;
    w.most_n = std::max(w.most_n, std::abs(w.last_n));
  }
  for (int i = 0; i < a.contacts->count; ++i) {
    const RodContact& c = a.contacts->contact[static_cast<std::size_t>(i)];
    const double push = c.force.dot(c.normal);
    w.normal_n += push;
    w.stored_j += push * push / (2 * c.stiffness_n_m);
  }
  return w;
}

TEST(PassageTruth, WorkGoesIntoTheWallsAndComesBack) {
  // Without friction: what pushing a tube into a narrow stretch takes is what its walls then hold, whatever their
  // springs, and drawing it out gives most of it back: a rim that slips past a ring springs.
  for (double side : {0.00235, 0.0023}) {  // within the mucosa's give
    for (double spacing : {0.0005, 0.001, 0.002}) {
      const TubeDesign design = tube_design("3.5");
      const RodDescription d = stiff_rod(design);
      TubeInAirway a(narrow_canal(side, spacing), design, d, hand_above(Vec3(0, 0, 0.001), d.length_m));
      a.input.friction = 0.0;
      const Work in = work_of(a, d.length_m, -0.001, 0.045);
      EXPECT_GT(in.stored_j, 1e-5);
      EXPECT_NEAR(in.in_j, in.stored_j, 0.15 * in.stored_j) << side << " " << spacing;
      const Work out = work_of(a, d.length_m, 0.045, -0.001);
      EXPECT_GT(in.in_j + out.in_j, -0.01 * in.in_j) << side << " " << spacing;  // never more than was put in
      EXPECT_LT(in.in_j + out.in_j, 0.25 * in.in_j) << side << " " << spacing;
    }
  }
}

TEST(PassageTruth, FrictionIsMuTimesTheWallsPressureBothWays) {
  const TubeDesign design = tube_design("3.5");
  const RodDescription d = stiff_rod(design);
  for (double mu : {0.05, 0.1, 0.3}) {
    TubeInAirway a(narrow_canal(0.00235, 0.001), design, d, hand_above(Vec3(0, 0, 0.001), d.length_m));
    a.input.friction = mu;
    const Work in = work_of(a, d.length_m, -0.001, 0.045);
    EXPECT_NEAR(in.last_n, mu * in.normal_n, 0.03 * mu * in.normal_n);
    const Work out = work_of(a, d.length_m, 0.045, 0.044);
    EXPECT_NEAR(-out.last_n, mu * out.normal_n, 0.03 * mu * out.normal_n);
  }
}

TEST(PassageTruth, ABentTubeLiesInABentAirwayOfItsOwnCurve) {
  // An airway bent as the tube is: the tube follows it without touching more than its own stiffness in the hand makes
  // it.
  const TubeDesign design = tube_design("3.5");
  const double radius = design.bend_radius, spacing = 0.002;
  AirwayCourse c;
  for (int n = 0; n <= 30; ++n) {
    const double angle = n * spacing / radius;
    AirwayRing r = ring_at(0, 0.003, 0.003, n == 0 ? AirwayPart::cords : AirwayPart::trachea);
    r.centre = Vec3(0, radius * (std::cos(angle) - 1), -radius * std::sin(angle));  // bends to the front
    r.along = Vec3(0, -std::sin(angle), -std::cos(angle));
    c.airway.push_back(r);
  }
  AirwayRing last = c.airway.back();
  last.part = AirwayPart::main_bronchus;
  for (int n = 0; n < 3; ++n) {
    last.centre += spacing * last.along;
    c.bronchi[0].push_back(last);
    c.bronchi[1].push_back(last);
  }
  c.oesophagus = branch(Vec3(0, 0.02, 0), 0.0, 0.0005, 0.02, 0.001, AirwayPart::oesophagus);
  const RodDescription d = tube_rod(design, nullptr, 0.1);
  const Rod rod(d);
  // The hand goes round the bend's middle, (0, -radius, 0).
  const Pose start = hand_with_tip_at(rod, Vec3(0, 0, 0.0001));
  TubeInAirway a(c, design, d, start);
  a.input.glottis_opening = 1.0;
  double most = 0.0, walls = 0.0;
  for (int n = 0; n < 2500; ++n) {
    const double angle = 2e-5 * n / radius;
    const Quat turn(Eigen::AngleAxisd(angle, -Vec3::UnitX()));
    const Vec3 middle(0, -radius, 0);
    Pose hand;
    hand.position = middle + turn * (start.position - middle);
    hand.rotation = turn * start.rotation;
    most = std::max(most, a.step(hand).on_hand.force.norm());
    double sum = 0.0;
    for (std::size_t part = 4; part < 6; ++part) sum += a.loads.loads_n[part];
    walls = std::max(walls, sum);
  }
  EXPECT_GT(a.past_cords(), 0.045);
  EXPECT_LT(most, 0.1);
  EXPECT_LT(walls, 0.1);
}

}  // namespace
}  // namespace vallecula::engine
