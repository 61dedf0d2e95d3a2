// Scores are pure functions of the trial log.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/trial_log.h"

namespace vallecula::curricula {

/// One line of the rubric.
struct Criterion {
  std::string name;  ///< "peak_tongue_force_n": the figure it judges
  std::string unit;  ///< "N", "s", "%"; empty for yes or no
  double value = 0.0;
  double limit = 0.0;
  double at_s = -1.0;  ///< trial time at which it happened (the peak, the first excess, the start of the
                       ///< longest stay at the device limit); -1: it never did
  bool met = false;
  std::string sentence;  ///< figure, limit and second, for a person
};

/// A time in which the device could not be used.
struct Pause {
  double at_s = 0.0, for_s = 0.0;  ///< trial time
  std::string fault;               ///< the device's, by name; empty: not known
};

struct Score {
  double peak_tongue_force_n = 0.0;  ///< model force; magnitude, tongue only
  double time_of_peak_tongue_force_s = 0.0;
  double time_to_trachea_visible_s = -1.0;  ///< from the attempt's start; -1: never (null in JSON)
  double glottis_visible_max_percent = 0.0;
  double peak_gum_force_n = 0.0;
  double time_of_peak_gum_force_s = 0.0;
  double attempt_time_s = 0.0;           ///< blade into the mouth to blade out (NEAR4NEOS)
  double attempt_start_s = 0.0;          ///< in trial time
  double time_over_force_limit_s = 0.0;  ///< device at its limit or lost: state not `tracking`
  double paused_s = 0.0;                 ///< the device could not be used; counts for nothing else
  std::vector<Pause> pauses;             ///< what it is made of
  double attempt_paused_s = 0.0;         ///< the part of it within the attempt
  double time_over_target_s = 0.0;       ///< tongue force over the scenario's target
  double loop_rate_hz = 0.0;
  long long deadline_misses = 0;  ///< forces written more than 1 ms after they were due
  long long overruns = 0;         ///< ticks without a new simulation step: the one at hand was not finished
  std::string real_time_setup;    ///< what priority the threads were granted, in words; empty: not recorded
  long long ticks = 0;
  bool passed = false;
  std::vector<std::string> reasons;  ///< each with the figure, the limit and the second it happened: of a failed
                                     ///< trial what was not met, of a passed one everything that was

  std::array<double, kStructures> peak_force_n{};    ///< model force by LoadedStructure
  std::array<double, kStructures> time_of_peak_s{};  ///< trial time
  double peak_displayed_force_n = 0.0;               ///< what the device was told
  double time_of_glottis_max_s = -1.0;               ///< trial time of glottis_visible_max_percent; -1: never seen
  bool attempt_begun = false;                        ///< the blade tip was in the mouth at least once
  bool blade_out = false;                            ///< and was out again in the last tick that was not paused
  int mouth_entries = 0;  ///< times the tip came in after a second or more outside, less pauses
  bool complete = false;                             ///< the log has its end; otherwise the trial was interrupted
  std::vector<Criterion> criteria;                   ///< the whole rubric, met or not
};

/// Definitions (times are trial time; a tick counts for servo_period_s):
/// - a tick is paused when the device could not be used (device_valid is false): the tool stands still and nothing that
///   happens then is the hand's doing. Paused ticks count for nothing below but that a figure is a number: no time, no
///   force, no sight.
/// - the attempt runs from the first tick with the proxy's tip in the mouth (score/mouth.h) to the last one: blade into
/// the
///   mouth to blade out (NEAR4NEOS). Short ways out do not stop the clock. Simplification: one trial holds one attempt,
///   since nothing between attempts (ventilation) exists yet; mouth_entries tells when there were more.
/// - peaks are the largest single tick of the model force's magnitude, over the whole trial, unfiltered.
/// - in sight: the first sight sample since the attempt's start with at least scenario.sight_percent of the glottis.
/// - over the device limit: the haptic state was not `tracking`, so a tick counts while the device is at its limit,
///   while it is lost (it let go after too long a stay there), and until it has taken hold again; but taking hold again
///   after a pause does not count. The reason cites the start of the longest such stay.
/// - over the target: model force on the tongue above it.
/// - passed: the log is complete and finite, the attempt took place, and every limit of scenario.pass is kept.
/// Never throws for a log that read_trial_log gave.
Score score_trial(const TrialLog& log, const Scenario& scenario);

/// One JSON object, indented; units are in the names. Figures that do not exist (never in sight, unknown loop rate) are
/// null.
std::string score_to_json(const Score& score, const TrialLog& log, const Scenario& scenario);

}  // namespace vallecula::curricula
