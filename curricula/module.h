// A module of a curriculum, when it opens and when it is mastered.
#pragma once

#include <string>
#include <vector>

#include "curricula/mode.h"
#include "curricula/progress/cusum.h"
#include "curricula/text.h"

namespace vallecula::curricula {

struct MasteryRule {
  bool by_cusum = false;  ///< over the module's trials, each scenario passed once; else `passes` running in each
  int passes = 1;         ///< running
  int attempts = 20;      ///< a trial that took more is no success
  CusumRule cusum;
  bool assessments_only = false;  ///< practice does not count
  std::string source = "assumed: the curriculum names no rule";
};

struct Module {
  std::string id, title;
  Text goal;
  std::vector<std::string> scenarios;  ///< ids, in order
  std::vector<std::string> after;      ///< modules to be mastered before this one opens
  std::vector<Mode> modes{Mode::practice, Mode::assessment};
  MasteryRule mastery;
};

}  // namespace vallecula::curricula
