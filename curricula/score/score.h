// Scores are pure functions of the trial log.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/score/blade_figures.h"
#include "curricula/score/checklist.h"
#include "curricula/score/dual_task.h"
#include "curricula/score/force_figures.h"
#include "curricula/score/intubation_score.h"
#include "curricula/score/motion_figures.h"
#include "curricula/score/view_figures.h"
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

/// A help beside the hands, or an instructor's change: how often and how long it was asked for, trial time.
struct Use {
  int times = 0;
  double for_s = 0.0;
  double first_s = -1.0;  ///< -1: never
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
  double time_of_first_sight_s = -1.0;               ///< trial time of time_to_trachea_visible_s; -1: never
  double time_of_glottis_max_s = -1.0;               ///< trial time of glottis_visible_max_percent; -1: never seen
  bool attempt_begun = false;                        ///< the blade tip was in the mouth at least once
  bool blade_out = false;                            ///< and was out again in the last tick that was not paused
  bool mouth_unknown = false;                        ///< the log's landmarks do not tell where an attempt begins
  int mouth_entries = 0;  ///< times the tip came in after a second or more outside, less pauses
  bool complete = false;  ///< the log has its end; otherwise the trial was interrupted
  /// The rubric, met or not. A limit that no attempt put to the test was neither: it is among them only where it was
  /// exceeded all the same.
  std::vector<Criterion> criteria;
  std::optional<IntubationScore> intubation;  ///< none: laryngoscopy alone

  Use eye_moves, extension, saturation_driven, heart_driven, spasm_driven;  ///< the last three by an instructor
  Use aided;                  ///< shown an expert's hands, or told a line by an instructor; in pauses as well
  bool at_vallecula = false;  ///< begun there: what the blade was led through is in no figure
  bool no_attempt = false;    ///< practice that was ended or reset before blade or tube had entered the mouth, unharmed
  /// Why the trial counts neither as passed nor as failed, whatever `passed` says: a sentence each; they stand first
  /// among the reasons. Empty: it counts.
  std::vector<std::string> set_aside;
  bool counts() const { return complete && set_aside.empty(); }

  // Each defined at its struct; told, not judged.
  ForceFigures force;
  ViewFigures view;
  BladeFigures blade;
  MotionFigures motion;
  std::optional<DualTask> dual_task;  ///< none: nothing was asked beside the hands
  std::vector<ChecklistItem> checklist;
};

/// Definitions (times are trial time; a tick counts for servo_period_s):
/// - a tick is paused when a device that a hand needs could not be used (device_valid, or hand_valid of the second
/// hand,
///   is false): the tools stand still and nothing that happens then is the hand's doing. Paused ticks count for nothing
///   below but that a figure is a number: no time, no force, no sight.
/// - the attempt runs from the first tick with the proxy's tip in the mouth (score/mouth.h) to the last one: blade into
/// the
///   mouth to blade out (NEAR4NEOS). Short ways out do not stop the clock. Simplification: in a trial without an
///   intubation there is one attempt, since there is nothing between attempts (ventilation); mouth_entries tells when
///   the blade went in more than once.
/// - peaks are the largest single tick of the model force's magnitude, over the whole trial, unfiltered.
/// - in sight: the first sight sample since the attempt's start with at least scenario.sight_percent of the glottis.
/// - over the device limit: the haptic state was not `tracking`, so a tick counts while the device is at its limit,
///   while it is lost (it let go after too long a stay there), and until it has taken hold again; but taking hold again
///   after a pause does not count. The reason cites the start of the longest such stay.
/// - over the target: model force on the tongue above it.
/// With an intubation (IntubationScore; "in" below: tip past the cords in larynx, trachea or a main bronchus, by the
/// tube, never the catheter):
/// - an attempt is one way of the blade into the mouth and out, out for a second or more less pauses; there may be
///   several. attempt_time_s, attempt_start_s and attempt_paused_s are the longest one's, for the limit holds for each;
///   time_to_trachea_visible_s is that of the first attempt with a view, from its own start.
/// - time to view: as above, of each attempt. Time to pass: from then to the last time the tip came in, until the next
///   attempt (the blade may be out by then); from its start where there was no view before.
/// - desaturation: displayed saturation, whole percents, from the highest between the attempts to the lowest until the
///   next (the display is late); 20 points or more. Bradycardia: below 100 per minute over the same time.
/// - outcome: by the last tick that was not paused. Tip in the oesophagus, in a main bronchus, or in the trachea: in
/// the
///   middle third of cords_to_carina_m (both thirds' ends included) good depth, above too shallow, below too deep. In
///   the larynx past the cords: too shallow, but cricoid too narrow where the cricoid stopped it last. Else, where the
///   tube stood against it within the last second, cricoid too narrow or cords closed; else out of time when
///   max_attempt_s is over; else by what stopped the tube last in the whole trial, or cords closed where a laryngospasm
///   lasted when the last attempt ended; else abandoned. "Stopped" by cords: 0.5 N or more along the tube
///   (assumed), mostly of cords in spasm or less than a quarter open (assumed); by the cricoid: 2 N or more for 0.1 s
///   (assumed; tubes that fit take up to 1.5 N, and knock on it for milliseconds when cords that open let them go), of
///   one that was never passed, and not longer ago than 10 s (assumed) without pauses: whoever touched it once and then
///   went elsewhere was not stopped by it.
/// - with the head neutral the tip lies 0.2 mm deeper for each degree of extension (assumed), where the header's
/// settings
///   know it (kHeadExtension). Judged again there where pass.depth_neutral asks for it.
/// - confirmed: the detector was yellow at some tick of the stay "in" that lasts to the end, after a breath in it;
///   breaths are counted from that stay's begin.
/// - recognised late: more than breaths_to_confirm breaths in one stay in the oesophagus.
/// - the lowest saturation and heart rate count from the first attempt's start.
/// - a trial begun at the vallecula is scored from where the hand took the blade over; no time of it is judged, and it
///   earns no points.
/// - a practice trial that the trainee ended or reset before the blade's or the tube's tip had been in the mouth is no
///   attempt, and set aside: what has no attempt was neither passed nor failed. Not where the mouth is not known or a
///   limit of force was passed; an assessment that was begun counts.
/// - passed: the log is complete and finite, the attempt took place, and every limit of scenario.pass is kept.
/// Never throws for a log that read_trial_log gave.
Score score_trial(const TrialLog& log, const Scenario& scenario);

/// One JSON object, indented; units are in the names. Figures that do not exist (never in sight, unknown loop rate) are
/// null.
std::string score_to_json(const Score& score, const TrialLog& log, const Scenario& scenario);

}  // namespace vallecula::curricula
