// What a trainee has mastered and what is open, from the results so far: pure functions, no database.
#pragma once

#include <string>
#include <vector>

#include "curricula/progress/cusum.h"
#include "curricula/scenario.h"

namespace vallecula::curricula {

/// What counts of one finished trial.
struct PastResult {
  std::string scenario_id, device_kind;
  Mode mode = Mode::practice;
  bool passed = false;
  int attempts = 1;
};

struct ModuleProgress {
  std::string module_id;
  bool open = false;                        ///< every module it comes after is mastered
  bool mastered = false;                    ///< once reached it stays
  int trials = 0, succeeded = 0;            ///< that count
  int scenarios_done = 0;                   ///< that did what the rule asks of each scenario
  std::vector<std::string> open_scenarios;  ///< in order; none while the module is closed
  std::vector<CusumPoint> cusum;            ///< one point for each trial that counts; empty under another rule
};

/// Of each module in order, from one trainee's results, oldest first. Only those of `device_kind` count: what was
/// learned with one kind of device says nothing about another.
std::vector<ModuleProgress> progress_of(const Curriculum& curriculum, const std::vector<PastResult>& results,
                                        const std::string& device_kind);

}  // namespace vallecula::curricula
