// vallecula_physiology_bench [TICKS]: what a tick of the infant and of the cords costs, on average and of those that
// take an inner step.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "engine/physiology/infant.h"
#include "engine/tube/glottis.h"

namespace {

using namespace vallecula::engine;
using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration d) { return std::chrono::duration<double, std::micro>(d).count(); }

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(1000, std::atoi(argv[1])) : 2000000;
  const Infant infant = build_infant({});
  InfantState state = start(infant);
  const Glottis glottis;
  GlottisState cords = start(glottis);
  double sum = 0.0;

  const auto begin = Clock::now();
  for (int k = 0; k < ticks; ++k) {
    InfantInput input;
    input.breath = k % 1500 == 0 ? Breath::mask : Breath::none;
    input.blade_load_n = 1.0;
    sum += step(infant, state, input, 0.001).sao2;
  }
  const double mean = microseconds(Clock::now() - begin) / ticks;

  std::vector<double> inner;
  for (int k = 0; k < 2000; ++k) {
    const auto before = Clock::now();
    sum += step(infant, state, {}, kMonitorStep).sao2;
    inner.push_back(microseconds(Clock::now() - before));
  }
  std::sort(inner.begin(), inner.end());

  const auto cords_begin = Clock::now();
  for (int k = 0; k < ticks; ++k) {
    GlottisInput input;
    input.breathing = true;
    input.breath_phase = k % 1000 * 0.001;
    input.touched = k % 5000 > 4000;
    step(glottis, cords, input, 0.001);
    sum += cords.opening;
  }
  std::printf("infant: %.4f us a tick, inner step median %.2f us, p99 %.2f us; cords: %.4f us a tick (checksum %.6f)\n",
              mean, inner[inner.size() / 2], inner[inner.size() * 99 / 100],
              microseconds(Clock::now() - cords_begin) / ticks, sum);
  return 0;
}
