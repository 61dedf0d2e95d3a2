// vallecula_tube_bench [TICKS]: what a tick of the tube costs, alone, pressed against something along its whole length,
// with a stylet within, and in an airway: finding its contacts with walls, a pharynx and a blade, the rod, the loads, the
// cords; and what it adds to a tick of a tongue that it lies on.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "engine/state.h"
#include "engine/tool/shapes.h"
#include "engine/tube/soft_contacts.h"
#include "engine/tube/tube_design.h"
#include "tests/engine/box_mesh.h"
#include "tests/engine/tube/airways.h"
#include "tests/engine/tube/soft_loads.h"

namespace {

using namespace vallecula::engine;
using Clock = std::chrono::steady_clock;

void print(const char* what, std::vector<double>& cost, double mean_force) {
  std::sort(cost.begin(), cost.end());
  const auto at = [&](double share) { return cost[static_cast<std::size_t>(share * (cost.size() - 1))]; };
  std::printf("%-34s median %6.1f us   p99 %6.1f us   p99.9 %6.1f us   max %7.1f us   (mean force %.3f N)\n", what,
              at(0.5), at(0.99), at(0.999), cost.back(), mean_force);
}

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
  print(what, cost, sum / ticks);
}

/// A usual tube goes to and fro in an airway of `spacing` between rings, beside a blade and between the walls of a
/// mouth.
void measure_in_airway(const char* what, double spacing, Canal canal, const Stylet* stylet, int ticks) {
  testing::AirwaySizes sizes;
  sizes.spacing = spacing;
  const TubeDesign tube = tube_design("3.5");
  const RodDescription d = tube_rod(tube, stylet, 0.12);
  const double behind = canal == Canal::oesophagus ? 0.010 : 0.0;
  const Pose start = testing::hand_with_tip_at(Rod(d), Vec3(0, behind, 0.001));
  testing::TubeInAirway a(testing::straight_airway(sizes), tube, d, start);
  RigidAnatomy mouth;
  mouth.surface = box_surface(Vec3(0, 0.045, 0.04), Vec3(0.06, 0.06, 0.06));
  mouth.triangle_structure.assign(mouth.surface.triangles.size(), Structure::other);
  const RigidField rigid(mouth, {}, Vec3(-0.03, -0.03, 0.0), Vec3(0.03, 0.03, 0.08), 0.0007, 0.005);
  const ToolField blade(box_surface(Vec3::Zero(), Vec3(0.002, 0.012, 0.06)), Vec3::Constant(-1), Vec3::Constant(1));
  const PartPoses parts;
  a.input.rigid = &rigid;
  a.input.parts = &parts;
  a.input.blade = &blade;
  a.input.blade_pose.position = Vec3(0.004, -0.01, 0.04);
  Glottis glottis;
  GlottisState cords = vallecula::engine::start(glottis);
  std::vector<double> cost;
  double sum = 0.0;
  int contacts = 0;
  for (int t = -3000; t < ticks; ++t) {  // first the way in
    Pose hand = start;
    hand.position.z() -= t < 0 ? 0.04 * (t + 3000) / 3000.0 : 0.04 + 0.005 * std::sin(2 * M_PI * t / 1000.0);
    hand.position.x() += 0.003 * std::sin(2 * M_PI * t / 1700.0);
    const auto begin = Clock::now();
    GlottisInput breath;
    breath.breathing = true;
    breath.breath_phase = (t + 3000) % 1500 / 1500.0;
    breath.touched = a.loads.glottis_n > 0.02;
    vallecula::engine::step(glottis, cords, breath, 0.001);
    a.input.glottis_opening = cords.opening;
    const double force = a.step(hand).on_hand.force.norm();
    const auto end = Clock::now();
    if (t < 0) continue;
    cost.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    sum += force;
    contacts = std::max(contacts, a.contacts->count);
  }
  char line[96];
  std::snprintf(line, sizeof line, "%s, %d contacts", what, contacts);
  print(line, cost, sum / ticks);
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
    force += testing::soft_loads(*scene, soft).tongue_n;
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
  measure_in_airway("tube 3.5 in the airway", 0.001, Canal::airway, nullptr, ticks);
  measure_in_airway("rings 0.5 mm apart, stylet", 0.0005, Canal::airway, &stylet, ticks);
  measure_in_airway("tube 3.5 in the gullet", 0.001, Canal::oesophagus, nullptr, ticks);
  return 0;
}
