// vallecula_intubation_bench [TICKS]: what tube, cords and infant add to a tick of a scene of about 5,000 tetrahedra,
// on the tube's real way in: along the tongue, beside a blade that presses it, through the cords into the trachea. Two
// scenes that differ by nothing else are stepped in turns, so that whatever else the machine does meets both. Exit code
// 1: the median is over the budget.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "engine/stage_clock.h"
#include "tests/engine/tube/intubation_scene.h"

namespace {

using namespace vallecula::engine;

constexpr double kBudget = 0.2;   // ms
constexpr double kFace = 0.0390;  // m, of the tongue: the tube, at x = 40 mm, is pressed 1.5 mm into it

/// The tongue stands beside the way in, from the inlet to before the mouth's front: 45 mm of it.
SceneDescription real_way_in() {
  SceneDescription d = testing::intubation_scene();
  const double length = 0.045, thick = 0.024;
  const std::vector<SprungBody> bodies = d.soft.bodies;
  d.soft = testing::box_body(Vec3(length, 0.03, thick), {14, 10, 6}, {6000.0, 0.45, 1040.0});
  d.soft.bodies = bodies;
  for (Vec3& x : d.soft.nodes) x = Vec3(kFace - thick + x.z(), x.y(), length - x.x());
  d.intubation->stylet = Stylet{};
  d.intubation->stylet->bend_rad = 0;
  return d;
}

/// The blade's plate presses the tongue all the while; the tube goes into the trachea along its edge, is held and
/// turned there, and comes out.
StepInput hands(const Rod& rod, double radius, std::int64_t n) {
  const double t = static_cast<double>(n % 4000) * 0.001;
  const double in = std::clamp(t / 1.5, 0.0, 1.0) - std::clamp((t - 2.5) / 1.5, 0.0, 1.0);
  StepInput input;
  const double down = std::min(1.0, static_cast<double>(n) / 300.0);
  const double edge = testing::kInTrachea.y() - radius + 0.0004;  // the tube lies on it
  input.device.position = Vec3(kFace + 0.002 - down * (0.004 + 0.001 * std::sin(20 * t)), edge - 0.007, 0.020);
  input.device.rotation = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY());
  input.second = testing::hand_of_tip(rod, testing::kBeforeMouth + in * (testing::kInTrachea - testing::kBeforeMouth));
  if (in == 1)
    input.second.rotation = input.second.rotation * Quat(Eigen::AngleAxisd(0.2 * std::sin(6 * t), Vec3::UnitX()));
  return input;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void tell(const char* what, const std::vector<double>& values, const char* unit) {
  std::printf("%-28s p50 %.4f  p99 %.4f  p99.9 %.4f  max %.4f %s\n", what, quantile(values, 0.5),
              quantile(values, 0.99), quantile(values, 0.999), quantile(values, 1.0), unit);
}

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(100, std::atoi(argv[1])) : 16000;
  const SceneDescription with = real_way_in();
  SceneDescription without = with;
  without.intubation.reset();
  const auto scene = build_scene(with), bare = build_scene(without);
  SceneState state(*scene), bare_state(*bare);
  const Rod& rod = scene->intubation->rod(InHand::tube_with_stylet);
  std::vector<double> with_ms, without_ms, added_ms, lying_ms, tongue_n, blade_n, walls_n, points;
  int faults = 0;
  for (int n = 0; n < ticks; ++n) {
    const StepInput input = hands(rod, with.intubation->tube.outer_diameter / 2, n);
    const double begin = thread_seconds();
    step(*bare, bare_state, input);
    const double between = thread_seconds();
    const StepResult r = step(*scene, state, input);
    const double end = thread_seconds();
    without_ms.push_back(1e3 * (between - begin));
    with_ms.push_back(1e3 * (end - between));
    added_ms.push_back(with_ms.back() - without_ms.back());
    const auto& loads = r.intubation.loads_n;
    faults += (r.faults | r.intubation.faults) != 0;
    if (r.intubation.place != TipPlace::trachea || !(loads[kLoadTongue] > 0)) continue;
    lying_ms.push_back(added_ms.back());
    tongue_n.push_back(loads[kLoadTongue]);
    blade_n.push_back(loads[kLoadBlade]);
    points.push_back(state.intubation->soft.count);
    double walls = 0.0;
    for (int part = 0; part < kAirwayParts; ++part) walls += loads[static_cast<std::size_t>(part)];
    walls_n.push_back(walls);
  }
  if (lying_ms.empty()) {
    std::printf("the tube never lay on the tongue with its tip in the trachea\n");
    return 1;
  }
  std::printf("%d tetrahedra, %d ticks, on the tongue and in the trachea in %zu, with a fault in %d\n",
              scene->model.tets, ticks, lying_ms.size(), faults);
  tell("without", without_ms, "ms");
  tell("with", with_ms, "ms");
  tell("added, tick by tick", added_ms, "ms");
  std::printf("in the trachea and on the tongue:\n");
  tell("  added", lying_ms, "ms");
  tell("  points of the tongue", points, "");
  tell("  load on the tongue", tongue_n, "N");
  tell("  on the blade", blade_n, "N");
  tell("  on the airway's walls", walls_n, "N");
  const double median = std::max(quantile(added_ms, 0.5), quantile(lying_ms, 0.5));
  std::printf("median added: %.4f ms (budget %.1f ms)\n", median, kBudget);
  return median <= kBudget ? 0 : 1;
}
