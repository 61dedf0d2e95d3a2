// Learning curves and cohorts out of the records. Nothing is ever pooled across device kinds.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "curricula/progress/progress.h"
#include "curricula/records/people.h"

namespace vallecula::curricula {

/// What one learning curve is of.
struct CurveKey {
  long long trainee_id = 0;  ///< 0: the trials that belong to nobody
  std::string curriculum_id, scenario_id, device_kind;
};

struct CurveSummary {
  CurveKey key;
  std::string trainee_name;         ///< in a cohort; else empty
  int trials = 0;                   ///< whole ones
  int interrupted = 0;              ///< cut off: in no figure below
  int set_aside = 0;  ///< by an instructor's change, for beginning at the vallecula or for want of an attempt: likewise
  int passed = 0;                   ///< within two attempts (procedure_succeeded)
  int passed_in_a_row = 0;          ///< up to the last trial
  int to_three_in_a_row = -1;       ///< trials up to and with the third success in a row; -1: not reached
  std::vector<CusumPoint> cusum;    ///< one point a whole trial, by the published rule
  std::string first_utc, last_utc;  ///< by the time they finished
};

struct Day {
  std::string date;  ///< "2026-05-03", UTC
  int trials = 0, passed = 0;
};

/// Empty fields: any.
struct CohortFilter {
  std::string curriculum_id, scenario_id, device_kind;
  std::string since_utc, until_utc;  ///< ISO 8601; finished at or after, and before
};

/// Passed, and where there was an intubation, within two attempts (PMC8290971): one trial is one procedure.
bool procedure_succeeded(const RecordRow& row);

/// Uses the connection of `records`, which must outlive it. A trainee sees their own, an instructor everybody's,
/// anybody what belongs to nobody. Every call throws RecordsError (NotAllowed).
class Progress {
 public:
  explicit Progress(Records& records) : records_(records) {}

  /// The curves there are, by curriculum, scenario and device kind.
  std::vector<CurveSummary> curves(const Who& who, long long trainee_id) const;
  /// One curve's trials in the order they were recorded (a clock that went back does not change it), interrupted ones
  /// too: their score is not complete.
  std::vector<RecordRow> curve(const Who& who, const CurveKey& key) const;
  /// The newest `count` of all their trials, newest first.
  std::vector<RecordRow> trials(const Who& who, long long trainee_id, int count) const;
  /// What counts towards the mastery of a curriculum's modules, oldest first, for progress_of(), by the curriculum's id;
  /// without interrupted ones and those set aside.
  std::map<std::string, std::vector<PastResult>> results(const Who& who, long long trainee_id) const;
  std::vector<Day> calendar(const Who& who, long long trainee_id) const;  ///< days with trials, by date
  /// Every trainee's curves, by name; instructors only.
  std::vector<CurveSummary> cohort(const SignedIn& instructor, const CohortFilter& filter) const;

 private:
  Records& records_;
};

}  // namespace vallecula::curricula
