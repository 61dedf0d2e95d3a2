#include "gui/session/past_results.h"

namespace vallecula::gui {

std::vector<curricula::PastResult> with_hands(std::vector<curricula::PastResult> results,
                                              const curricula::Curriculum& curriculum, const std::string& hands) {
  const std::string blade = hands.substr(0, hands.find('+'));
  for (curricula::PastResult& result : results) {
    const curricula::Scenario* scenario = curriculum.find(result.scenario_id);
    if (scenario != nullptr && !scenario->intubation && result.device_kind == blade) result.device_kind = hands;
  }
  return results;
}

}  // namespace vallecula::gui
