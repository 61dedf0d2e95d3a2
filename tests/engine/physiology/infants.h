// Infants for the tests, and how they are brought through a time.
#pragma once

#include <vector>

#include "engine/physiology/infant.h"

namespace vallecula::engine::testing {

/// As in Kothari 2021: 27 weeks, 946 g, premedicated.
inline InfantDescription preterm(std::uint64_t seed = 1) {
  InfantDescription d;
  d.weight_kg = 0.946;
  d.gestation_weeks = 27;
  d.seed = seed;
  return d;
}

inline InfantDescription term(std::uint64_t seed = 1, Course course = Course::term) {
  InfantDescription d;
  d.course = course;
  d.weight_kg = 3.3;
  d.gestation_weeks = 39;
  d.premedicated = false;
  d.seed = seed;
  return d;
}

/// A blade that presses on the larynx.
inline InfantInput load(double newton) {
  InfantInput input;
  input.blade_load_n = newton;
  return input;
}

/// A patient with its clock, stepped by 1 ms or as told.
struct Patient {
  Infant infant;
  InfantState state;
  InfantSigns signs;
  double tick_s = 0.001;
  double time_s = 0.0;

  explicit Patient(const InfantDescription& d, double tick = 0.001)
      : infant(build_infant(d)), state(start(infant)), tick_s(tick) {
    signs.sao2 = state.oxygen.arterial;
    signs.spo2 = state.oximeter.percent / 100.0;
    signs.heart_per_min = state.heart.per_min;
  }

  void tick(const InfantInput& input) {
    signs = step(infant, state, input, tick_s);
    time_s += tick_s;
  }
  /// `seconds` under the same input.
  void live(double seconds, const InfantInput& input = {}) {
    for (const double end = time_s + seconds - tick_s / 2; time_s < end;) tick(input);
  }
  /// `count` breaths, each at the begin of its interval.
  void ventilate(int count, Breath breath, TubeTip tip = TubeTip::none, double per_min = 40.0) {
    InfantInput input;
    input.tip = tip;
    for (int k = 0; k < count; ++k) {
      input.breath = breath;
      tick(input);
      input.breath = Breath::none;
      live(60.0 / per_min - tick_s, input);
    }
  }
};

/// The value below which `share` (0..1) of the values lie.
double quantile(std::vector<double> values, double share);

}  // namespace vallecula::engine::testing
