// vallecula_tube_bench [TICKS]: what a tick of the tube costs, alone, pressed against something along its whole length,
// and with a stylet within; and what it adds to a tick of a tongue that it lies on.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "engine/state.h"
#include "engine/tube/soft_contacts.h"
#include "engine/tube/tube_design.h"
#include "tests/engine/box_mesh.h"

namespace {

using namespace vallecula::engine;
using Clock = std::chrono::steady_clock;

/// The hand goes to and fro by 20 mm, up and down by 10 mm and turns by half a radian; half of the points lie under a
/// ceiling that the tube's curve presses against.
void measure(const char* what, const Stylet* stylet, int contact_count, int ticks) {
  const TubeDesign tube = tube_design("3.5");
  const Rod rod(tube_rod(tube, stylet, usual_grip_from_tip(tube)));
  RodState state(rod, Pose{});
  const double ceiling = state.position[0].z() / 3;
  std::vector<RodContact> contacts(static_cast<std::size_t>(contact_count));
  std::vector<double> cost(static_cast<std::size_t>(ticks));
  double sum = 0.0;
  for (int t = 0; t < ticks; ++t) {
    const double phase = 2 * M_PI * t / 1000.0;
    Pose hand;
    hand.position = Vec3(0.02 * std::sin(phase), 0, 0.01 * std::sin(0.7 * phase));
    hand.rotation = Eigen::AngleAxisd(0.5 * std::sin(0.3 * phase), Vec3::UnitX());
    for (int n = 0; n < contact_count; ++n) {
      RodContact& c = contacts[static_cast<std::size_t>(n)];
      c.node = n * kTubeSegments / contact_count;
      c.weight = 0.5;
      c.friction = 0.2;
      const Vec3 at = 0.5 * (state.position[static_cast<std::size_t>(c.node)] +
                             state.position[static_cast<std::size_t>(c.node) + 1]);
      c.normal = -Vec3::UnitZ();
      c.depth_m = at.z() - ceiling;
    }
    const auto begin = Clock::now();
    const RodStep r = step(rod, state, hand, contacts.data(), contact_count, 0.001);
    cost[static_cast<std::size_t>(t)] = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    sum += r.on_hand.force.norm();
  }
  std::sort(cost.begin(), cost.end());
  const auto at = [&](double share) { return cost[static_cast<std::size_t>(share * (ticks - 1))]; };
  std::printf("%-34s median %6.1f us   p99 %6.1f us   p99.9 %6.1f us   max %7.1f us   (mean force %.3f N)\n", what,
              at(0.5), at(0.99), at(0.999), cost.back(), sum / ticks);
}

/// Sorts `cost` (us).
void tell(const char* what, std::vector<double>& cost) {
  std::sort(cost.begin(), cost.end());
  const auto at = [&](double share) { return cost[static_cast<std::size_t>(share * (cost.size() - 1))]; };
  std::printf("  %-32s median %6.1f us   p99 %6.1f us   p99.9 %6.1f us   max %7.1f us\n", what, at(0.5), at(0.99), at(0.999),
              cost.back());
}

/// A tongue of 50 x 25 x 15 mm, 4,860 tetrahedra, and a tube with its stylet along it: away from it (press < 0), or moved
/// to and fro while it is pressed in; the same ticks of the tongue alone for comparison.
void measure_on_tongue(const char* what, double press, int ticks) {
  SceneDescription d = testing::block_scene();
  d.soft = testing::box_body(Vec3(0.05, 0.025, 0.015), {18, 9, 5}, {6000.0, 0.45, 1040.0});
  const auto scene = build_scene(d);
  const TubeDesign design = tube_design("3.5");
  const Stylet stylet;
  const double held = 0.07;
  RodDescription description = tube_rod(design, &stylet, held);
  for (RodSection& s : description.section) s.natural_curvature_per_m = 0.0;
  const Rod rod(description);
  const auto hand_at = [&](double t) {
    Pose hand;
    hand.position = Vec3(0.003 + held + 0.004 * std::sin(2 * M_PI * t), 0.0125 + 0.002 * std::sin(3.1 * t),
                         0.015 + description.outer_radius_m - std::min(press, 0.01 * t - 0.0005));
    return hand;
  };
  SceneState state(*scene), alone(*scene);
  SoftContactState soft(*scene);
  RodState tube(rod, hand_at(0));
  std::vector<RodContact> contacts(kMostSoftContacts);
  std::vector<double> find, rods, tissue, bare;
  double pressing = 0.0, force = 0.0;
  for (int n = 0; n < ticks; ++n) {
    const auto begin = Clock::now();
    const int count =
        find_soft_contacts(*scene, state.tissue, rod, tube, 0.0, 0.1, soft, contacts.data(), kMostSoftContacts);
    const auto found = Clock::now();
    step(rod, tube, hand_at(0.001 * n), contacts.data(), count, 0.001);
    const auto moved = Clock::now();
    press_tissue(*scene, tube, contacts.data(), soft);
    std::array<StructureLoad, kLoadedStructures> loads{};
    StageTimes times;
    step_tissue(*scene, state, Pose{}, loads, times, &soft);
    const auto pressed = Clock::now();
    step_tissue(*scene, alone, Pose{}, loads, times);
    const auto end = Clock::now();
    const auto us = [](Clock::duration t) { return std::chrono::duration<double, std::micro>(t).count(); };
    find.push_back(us(found - begin));
    rods.push_back(us(moved - found));
    tissue.push_back(us(pressed - moved));
    bare.push_back(us(end - pressed));
    pressing += count;
    force += soft_loads(*scene, soft).tongue_n;
  }
  std::printf("%s: %.0f contacts, %.3f N on average\n", what, pressing / ticks, force / ticks);
  tell("contacts found", find);
  tell("rod", rods);
  tell("tongue with the tube's contacts", tissue);
  tell("tongue untouched, at rest", bare);
}

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(10, std::atoi(argv[1])) : 10000;
  const Stylet stylet;
  measure("tube 3.5", nullptr, 0, ticks);
  measure("tube 3.5, 60 contacts", nullptr, 60, ticks);
  measure("tube 3.5, stylet", &stylet, 0, ticks);
  measure("tube 3.5, stylet, 60 contacts", &stylet, 60, ticks);
  measure_on_tongue("tube 20 mm above the tongue", -0.02, ticks);
  measure_on_tongue("tube lying on the tongue", 0.0005, ticks);
  measure_on_tongue("tube pressed 3 mm into it", 0.003, ticks);
  return 0;
}
