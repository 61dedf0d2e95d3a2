#include "gui/session/past_results.h"

#include <algorithm>

#include "curricula/records/progress.h"

namespace vallecula::gui {
namespace {

constexpr int kMostTrials = 20000;  // ten a day for more than five years

}  // namespace

PastResults past_results(curricula::Records& records, const curricula::Who& who) {
  std::vector<curricula::RecordRow> rows =
      who ? curricula::Progress(records).trials(who, who->id(), kMostTrials) : records.newest(kMostTrials);
  std::reverse(rows.begin(), rows.end());
  PastResults results;
  for (const curricula::RecordRow& row : rows) {
    if (!row.score.complete) continue;
    curricula::PastResult result;
    result.scenario_id = row.scenario_id;
    result.device_kind = row.device_kind;
    result.mode = row.mode;
    result.passed = row.score.passed;
    result.attempts = std::max(1, row.attempts);
    results[row.curriculum_id].push_back(std::move(result));
  }
  return results;
}

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
