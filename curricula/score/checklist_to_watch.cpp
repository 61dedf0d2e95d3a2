#include "curricula/score/checklist_to_watch.h"

#include "curricula/score/score.h"

namespace vallecula::curricula {

std::vector<ChecklistItem> checklist_to_watch(const Scenario& scenario) {
  Score nothing_yet;
  if (scenario.intubation) nothing_yet.intubation.emplace();
  std::vector<ChecklistItem> items = checklist_of(nothing_yet, TrialLog(), scenario);
  for (ChecklistItem& item : items)
    item = {item.id, item.text, ChecklistItem::Done::not_seen, -1.0, "The trial is not over"};
  return items;
}

}  // namespace vallecula::curricula
