// A hand-made intubation whose every figure is known beforehand, and ways to change it.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "curricula/score/score.h"

namespace vallecula::curricula::testing {

constexpr double kTick = 0.001;
constexpr std::array<double, 3> kOutside{0.0, -0.10, 0.10}, kInMouth{0.0, 0.02, -0.02};
using Change = std::function<void(LogTick&)>;

inline Scenario scenario() {
  Scenario s;
  s.id = "tube";
  s.title = "Tube";
  s.sight_percent = 25;
  s.max_attempt_s = 180;
  s.targets = {5.0, 2.0};
  s.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  IntubationSpec& i = s.intubation.emplace();
  i.tube = "3.5";
  i.breaths_to_confirm = 6;
  i.pass.lowest_spo2_percent = 70;
  i.pass.lowest_heart_per_min = 100;
  i.pass.tube_force_n = 2;
  i.pass.time_to_pass_s = 20;
  i.pass.attempts = 2;
  i.pass.co2_confirmed = true;
  return s;
}

inline bool between(const LogTick& t, double from_s, double to_s) {
  return t.time_s > from_s - kTick / 2 && t.time_s < to_s - kTick / 2;
}

/// 40 s. Breaths by mask at 1, 2 and 3 s. Blade in from 5 to 20 s, 80 % of the glottis in sight from 9 s on. The tube's
/// tip is in the mouth from 11 s, in the larynx from 12 s, past the cords from 14 s, in the trachea from 14.5 s, and
/// from 16 s on 24 mm deep, of 48 mm to the carina. Breaths through it every second from 22 s; the third turns the
/// detector yellow. Saturation 95 % before, 80 % from 20 to 28 s, then 93 %; heart 140, from 18 to 26 s 110.
inline TrialLog log_of(const Change& change = {}, double seconds = 40.0) {
  TrialLog log;
  log.header.has_intubation = true;
  log.header.schema = 3;
  log.header.settings[kCordsToCarina] = 0.048;
  log.header.settings[kLipsBeforeGums] = 0.0056;
  log.header.landmarks_m = {{"upper_gum_midline", {0, 0, 0}},
                            {"lower_gum_midline", {0, 0.0032, -0.0208}},
                            {"vallecula", {0, 0.0285, -0.0415}}};
  log.footer = {true, "finished", 0.0, 0, 0, "", {}};
  const int ticks = static_cast<int>(std::lround(seconds / kTick));
  for (int n = 0; n < ticks; ++n) {
    LogTick t;
    t.tick = t.step_fed = t.step_used = n;
    t.time_s = n * kTick;
    t.proxy_pose.position_m = between(t, 5, 20) ? kInMouth : kOutside;
    t.has_sight = n % 20 == 0;
    if (between(t, 9, 20) && t.has_sight) t.glottis_visible = 0.8;
    t.has_intubation = true;
    LogIntubation& i = t.intubation;
    i.place = t.time_s < 11 - kTick / 2     ? LoggedPlace::outside
              : t.time_s < 12 - kTick / 2   ? LoggedPlace::mouth
              : t.time_s < 14.5 - kTick / 2 ? LoggedPlace::larynx
                                            : LoggedPlace::trachea;
    i.tip_m = {0.0, 0.0, 0.008 * (14.0 - t.time_s)};
    if (t.time_s > 14 - kTick / 2) i.past_cords_m = std::min(0.024, 0.012 * (t.time_s - 14) + 1e-6);
    i.glottis_opening = 0.8;
    i.breaths_given = std::min(3, n / 1000) + std::max(0, (n - 21000) / 1000);
    i.detector_yellow = n >= 24000;
    i.sao2 = i.spo2 = between(t, 20, 28) ? 0.80 : t.time_s < 20 ? 0.95 : 0.93;
    i.heart_per_min = between(t, 18, 26) ? 110.0 : 140.0;
    if (t.tick == 14250) i.tip_load_n = 1.5, i.tip_against = kTubeCords, i.loads_n[kTubeCords] = 1.7;
    if (t.tick == 14600) i.loads_n[kTubeCricoid] = 2.5, i.model_force_n = {0.6, 0, 0.8};
    i.secretions_ml = n < 8000 ? 1.5 : 0.25;
    if (change) change(t);
    log.ticks.push_back(t);
  }
  return log;
}

inline Score score_of(const Change& change = {}, const Scenario& s = scenario()) {
  return score_trial(log_of(change), s);
}

/// The tube's tip goes nowhere of itself: outside for the whole trial, until `change` puts it somewhere.
inline Change never_in(const Change& change = {}) {
  return [change](LogTick& t) {
    t.intubation.place = LoggedPlace::outside;
    t.intubation.past_cords_m = 0.0;
    t.intubation.detector_yellow = false;
    t.intubation.tip_load_n = 0.0;
    if (change) change(t);
  };
}

inline Change pushed(double from_s, double to_s, std::uint8_t against, double opening) {
  return never_in([=](LogTick& t) {
    if (!between(t, from_s, to_s)) return;
    t.intubation.place = LoggedPlace::larynx;
    t.intubation.past_cords_m = against == kTubeCricoid ? 0.008 : 0.0;
    t.intubation.tip_against = against;
    t.intubation.tip_load_n = against == kTubeCricoid ? 2.0 : 1.0;
    t.intubation.glottis_opening = opening;
  });
}

inline std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& t : texts) all += t + "\n";
  return all;
}

}  // namespace vallecula::curricula::testing
