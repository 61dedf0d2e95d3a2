#include "curricula/progress/progress.h"

#include <algorithm>
#include <set>

namespace vallecula::curricula {
namespace {

bool contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool succeeded(const PastResult& result, const MasteryRule& rule) {
  return result.passed && result.attempts <= rule.attempts;
}

/// What the rule asks of each scenario: a success at some time, or so many running, whatever was done between.
bool scenario_done(const std::string& id, const MasteryRule& rule, const std::vector<PastResult>& counted) {
  const int passes = rule.by_cusum ? 1 : rule.passes;
  int running = 0;
  for (const PastResult& result : counted) {
    if (result.scenario_id != id) continue;
    running = succeeded(result, rule) ? running + 1 : 0;
    if (running == passes) return true;
  }
  return false;
}

bool competent(const std::vector<CusumPoint>& points) {
  return std::any_of(points.begin(), points.end(),
                     [](const CusumPoint& p) { return p.verdict == CusumVerdict::competent; });
}

}  // namespace

std::vector<ModuleProgress> progress_of(const Curriculum& curriculum, const std::vector<PastResult>& results,
                                        const std::string& device_kind) {
  std::vector<ModuleProgress> all;
  std::set<std::string> mastered;
  for (const Module& module : curriculum.modules) {
    std::vector<PastResult> counted;
    std::vector<bool> successes;
    for (const PastResult& result : results) {
      if (result.device_kind != device_kind || !contains(module.scenarios, result.scenario_id)) continue;
      if (module.mastery.assessments_only && result.mode != Mode::assessment) continue;
      counted.push_back(result);
      successes.push_back(succeeded(result, module.mastery));
    }
    ModuleProgress progress;
    progress.module_id = module.id;
    if (module.mastery.by_cusum) progress.cusum = cusum(module.mastery.cusum, successes);
    progress.trials = static_cast<int>(counted.size());
    progress.succeeded = static_cast<int>(std::count(successes.begin(), successes.end(), true));
    progress.scenarios_done = static_cast<int>(
        std::count_if(module.scenarios.begin(), module.scenarios.end(),
                      [&](const std::string& id) { return scenario_done(id, module.mastery, counted); }));
    progress.mastered = progress.scenarios_done == static_cast<int>(module.scenarios.size()) &&
                        (!module.mastery.by_cusum || competent(progress.cusum));
    if (progress.mastered) mastered.insert(module.id);
    all.push_back(std::move(progress));
  }
  const auto reached = [&](const std::vector<std::string>& after) {
    return std::all_of(after.begin(), after.end(), [&](const std::string& id) { return mastered.count(id) != 0; });
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Module& module = curriculum.modules[i];
    all[i].open = reached(module.after);
    if (!all[i].open) continue;
    for (const std::string& id : module.scenarios)
      if (reached(curriculum.find(id)->after)) all[i].open_scenarios.push_back(id);
  }
  return all;
}

}  // namespace vallecula::curricula
