// Tubes as they are made: sizes that are in order, sections by hand, the stylet's shape, and errors that name the
// number.
#include "engine/tube/tube_design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "tests/engine/tube/rods.h"

namespace vallecula::engine {
namespace {

TEST(TubeDesign, SizesAreThoseOfTheTable) {
  const char* name[] = {"2.5", "3.0", "3.5", "4.0"};
  const double outer_least[] = {3.4, 4.0, 4.9, 5.4}, outer_most[] = {3.6, 4.3, 4.9, 5.6}, mark[] = {24, 26, 28, 30};
  for (int i = 0; i < 4; ++i) {
    const TubeDesign tube = tube_design(name[i]);
    EXPECT_NEAR(1e3 * tube.inner_diameter, std::stod(name[i]), 1e-9);
    EXPECT_GE(1e3 * tube.outer_diameter, outer_least[i] - 1e-9);
    EXPECT_LE(1e3 * tube.outer_diameter, outer_most[i] + 1e-9);
    EXPECT_NEAR(1e3 * tube.cord_mark_from_tip, mark[i], 1e-9);
    EXPECT_NO_THROW(Rod(tube_rod(tube, nullptr, usual_grip_from_tip(tube))));
  }
  EXPECT_THROW(tube_design("7.5"), std::invalid_argument);
}

TEST(TubeDesign, SectionsAreThoseOfARing) {
  const TubeDesign tube = tube_design("3.5");
  const RodDescription rod = tube_rod(tube, nullptr, 0.14);
  // pi/64 (4.9^4 - 3.5^4) = 20.93 mm^4, times 30 MPa; G J = E I / (1 + nu); 9.236 mm^2 of 1250 kg/m^3.
  EXPECT_NEAR(rod.section[3].bending_n_m2, 6.279e-4, 2e-7);
  EXPECT_NEAR(rod.section[3].twisting_n_m2, 6.279e-4 / 1.45, 2e-7);
  EXPECT_NEAR(rod.mass_kg_m, 0.011545, 1e-5);
  EXPECT_DOUBLE_EQ(rod.outer_radius_m, 0.00245);
}

/// The angle between the rod's ends, rad.
double bend_of(const RodState& s) {
  return std::acos((s.rotation.front() * Vec3::UnitX()).dot(s.rotation.back() * Vec3::UnitX()));
}

TEST(TubeDesign, TheStyletMakesAHockeyStick) {
  const TubeDesign tube = tube_design("3.5");
  Stylet stylet;
  const Rod rod(tube_rod(tube, &stylet, 0.14));
  RodState state(rod, Pose{});
  testing::settle(rod, state, Pose{}, {}, 500);
  // E I of the metal: 69 GPa pi/64 1.2^4 mm^4 = 7.02e-3, eleven times the wall's, whose own curve is 0.98 rad.
  EXPECT_NEAR(bend_of(state), (7.02e-3 * stylet.bend_rad + 6.28e-4 * 0.98) / (7.02e-3 + 6.28e-4), 0.03);
  const Rod bare(tube_rod(tube, nullptr, 0.14));
  EXPECT_NEAR(bend_of(RodState(bare, Pose{})), 0.14 / 0.14, 0.05);
  // Straight behind the bend: 10 mm of the tip's rise lie before it.
  const double lever = stylet.bend_from_tip * std::sin(stylet.bend_rad);
  EXPECT_NEAR(state.position[0].z(), lever, 0.4 * lever);
  EXPECT_LT(std::abs(frame_at(rod, state, 0.045).position.z()), 0.004);
  // And stiffer: a push at the tip that bends the bare tube by 10 mm.
  RodState loaded = state, soft(bare, Pose{});
  const Vec3 bare_tip = soft.position[0], tip = state.position[0];
  testing::settle(rod, loaded, Pose{}, {testing::dead_load(0, Vec3(0, 0.005, 0))}, 3000);
  testing::settle(bare, soft, Pose{}, {testing::dead_load(0, Vec3(0, 0.005, 0))}, 3000);
  EXPECT_LT((loaded.position[0] - tip).norm(), 0.2 * (soft.position[0] - bare_tip).norm());
}

TEST(TubeDesign, TheFrameAlongTheTubeIsWhereTheNodesAre) {
  const TubeDesign tube = tube_design("3.0");
  const Rod rod(tube_rod(tube, nullptr, usual_grip_from_tip(tube)));
  const RodState state(rod, Pose{});
  EXPECT_LT((frame_at(rod, state, 0).position - state.position[0]).norm(), 1e-12);
  EXPECT_LT((frame_at(rod, state, -1).position - state.position[0]).norm(), 1e-12);
  EXPECT_LT((frame_at(rod, state, 1).position - state.position.back()).norm(), 1e-12);
  EXPECT_LT(
      (frame_at(rod, state, 7.25 * rod.segment_m()).position - (0.75 * state.position[7] + 0.25 * state.position[8]))
          .norm(),
      1e-9);
}

TEST(TubeDesign, SaysWhatDoesNotMakeATube) {
  const auto message = [](const std::function<void(TubeDesign&, Stylet&, double&)>& change) {
    TubeDesign tube = tube_design("3.5");
    Stylet stylet;
    double grip = 0.14;
    change(tube, stylet, grip);
    try {
      tube_rod(tube, &stylet, grip);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_EQ(message([](TubeDesign&, Stylet&, double&) {}), "nothing");
  EXPECT_TRUE(has(message([](TubeDesign& t, Stylet&, double&) { t.outer_diameter = 0.003; }), "leaves no wall"));
  EXPECT_TRUE(has(message([](TubeDesign& t, Stylet&, double&) { t.length = 0; }), "length"));
  EXPECT_TRUE(has(message([](TubeDesign& t, Stylet&, double&) { t.poisson = 0.6; }), "0.6"));
  EXPECT_TRUE(has(message([](TubeDesign& t, Stylet&, double&) { t.cord_mark_from_tip = 0.2; }), "200.0"));
  EXPECT_TRUE(has(message([](TubeDesign&, Stylet& s, double&) { s.diameter = 0.004; }), "lumen of 3.5"));
  EXPECT_TRUE(has(message([](TubeDesign&, Stylet& s, double&) { s.short_of_tip = 0.2; }), "200.0"));
  EXPECT_TRUE(has(message([](TubeDesign&, Stylet& s, double&) { s.bend_rad = NAN; }), "bend"));
  EXPECT_TRUE(has(message([](TubeDesign&, Stylet&, double& grip) { grip = 0.19; }), "190.0"));
}

}  // namespace
}  // namespace vallecula::engine
