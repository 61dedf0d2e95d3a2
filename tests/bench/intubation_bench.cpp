// vallecula_intubation_bench [TICKS]: what tube, cords and infant add to a tick of a scene of about 5,000 tetrahedra.
// Two scenes that differ by nothing else are stepped in turns, so that whatever else the machine does meets both.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "engine/stage_clock.h"
#include "tests/engine/tube/intubation_scene.h"

namespace {

using namespace vallecula::engine;

/// The blade presses the tongue all the while; the tube goes into the trachea, is held and turned there, and comes out.
StepInput hands(const Rod& rod, std::int64_t n) {
  const double t = static_cast<double>(n % 4000) * 0.001;
  const double in = std::clamp(t / 1.5, 0.0, 1.0) - std::clamp((t - 2.5) / 1.5, 0.0, 1.0);
  StepInput input;
  input.device = testing::press_on(testing::kTongueTop, 0.004 + 0.001 * std::sin(20 * t), 0.3);
  input.second = testing::hand_of_tip(rod, testing::kBeforeMouth + in * (testing::kInTrachea - testing::kBeforeMouth));
  if (in == 1)
    input.second.rotation = input.second.rotation * Quat(Eigen::AngleAxisd(0.2 * std::sin(6 * t), Vec3::UnitX()));
  return input;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void tell(const char* what, const std::vector<double>& ms) {
  std::printf("%-28s p50 %.4f  p99 %.4f  p99.9 %.4f  max %.4f ms\n", what, quantile(ms, 0.5), quantile(ms, 0.99),
              quantile(ms, 0.999), quantile(ms, 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(100, std::atoi(argv[1])) : 16000;
  SceneDescription with = testing::intubation_scene({13, 13, 5});
  with.intubation->stylet = Stylet{};
  SceneDescription without = with;
  without.intubation.reset();
  const auto scene = build_scene(with), bare = build_scene(without);
  SceneState state(*scene), bare_state(*bare);
  const Rod& rod = scene->intubation->rod(InHand::tube_with_stylet);
  std::vector<double> with_ms, without_ms, added_ms;
  double walls_n = 0.0;
  int inside = 0;
  for (int n = 0; n < ticks; ++n) {
    const StepInput input = hands(rod, n);
    const double begin = thread_seconds();
    step(*bare, bare_state, input);
    const double between = thread_seconds();
    const StepResult r = step(*scene, state, input);
    const double end = thread_seconds();
    without_ms.push_back(1e3 * (between - begin));
    with_ms.push_back(1e3 * (end - between));
    added_ms.push_back(with_ms.back() - without_ms.back());
    inside += r.intubation.place == TipPlace::trachea;
    for (int part = 0; part < kAirwayParts; ++part)
      walls_n = std::max(walls_n, r.intubation.loads_n[static_cast<std::size_t>(part)]);
  }
  std::printf("%d tetrahedra, %d ticks, tip in the trachea in %d, walls up to %.2f N\n", scene->model.tets, ticks,
              inside, walls_n);
  tell("without", without_ms);
  tell("with", with_ms);
  tell("added, tick by tick", added_ms);
  std::printf("added: p50 %.4f ms, p99 %.4f ms (budget 0.2 ms)\n", quantile(with_ms, 0.5) - quantile(without_ms, 0.5),
              quantile(with_ms, 0.99) - quantile(without_ms, 0.99));
  return 0;
}
