// vallecula_tube_bench [TICKS]: what a tick of the tube costs, alone, pressed against something along its whole length,
// and with a stylet within.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "engine/tube/tube_design.h"

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

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(10, std::atoi(argv[1])) : 10000;
  const Stylet stylet;
  measure("tube 3.5", nullptr, 0, ticks);
  measure("tube 3.5, 60 contacts", nullptr, 60, ticks);
  measure("tube 3.5, stylet", &stylet, 0, ticks);
  measure("tube 3.5, stylet, 60 contacts", &stylet, 60, ticks);
  return 0;
}
