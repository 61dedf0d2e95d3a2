#include "curricula/score/checklist_to_watch.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vallecula::curricula {
namespace {

std::vector<std::string> ids_of(const std::vector<ChecklistItem>& items) {
  std::vector<std::string> ids;
  for (const ChecklistItem& item : items) ids.push_back(item.id);
  return ids;
}

TEST(ChecklistToWatch, HasTheItemsOfItsScenarioAndJudgesNone) {
  Scenario plain;
  EXPECT_EQ(ids_of(checklist_to_watch(plain)),
            (std::vector<std::string>{"equipment_checked", "handle_in_left_hand", "blade_in_right_or_middle",
                                      "vallecula_reached", "no_levering", "team_told"}));
  Scenario tube;
  tube.intubation.emplace();
  tube.intubation->stylet = false;
  const auto without = ids_of(checklist_to_watch(tube));
  EXPECT_EQ(std::count(without.begin(), without.end(), "depth_good"), 1);
  EXPECT_EQ(std::count(without.begin(), without.end(), "stylet_out"), 0);
  tube.intubation->stylet = true;
  const auto items = checklist_to_watch(tube);
  const auto with = ids_of(items);
  EXPECT_EQ(std::count(with.begin(), with.end(), "stylet_out"), 1);
  for (const ChecklistItem& item : items) {
    EXPECT_EQ(item.done, ChecklistItem::Done::not_seen) << item.id;
    EXPECT_EQ(item.at_s, -1.0) << item.id;
    EXPECT_FALSE(item.text.empty()) << item.id;
  }
}

}  // namespace
}  // namespace vallecula::curricula
