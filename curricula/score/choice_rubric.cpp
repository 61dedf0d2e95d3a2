#include "curricula/score/choice_rubric.h"

#include "curricula/score/criterion.h"

namespace vallecula::curricula {
namespace {

Criterion choice(const char* name, const std::string& what, const std::string& taken, const std::string& right) {
  const bool met = taken == right;
  return fact(name, met, 0.0,
              met ? what + taken + " was taken, which is right for this infant"
                  : what + taken + " was taken; right for this infant is " + right);
}

}  // namespace

void judge_choice(const Scenario& scenario, std::vector<Criterion>& criteria) {
  const AttemptOrigin& attempt = scenario.attempt;
  if (!attempt.right_blade.empty())
    criteria.push_back(choice("right_blade", "The blade ", scenario.blade, attempt.right_blade));
  if (scenario.intubation && !attempt.right_tube.empty())
    criteria.push_back(choice("right_tube", "The tube ", scenario.intubation->tube, attempt.right_tube));
}

}  // namespace vallecula::curricula
