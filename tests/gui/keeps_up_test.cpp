#include "gui/session/keeps_up.h"

#include <gtest/gtest.h>

namespace vallecula::gui::test {
namespace {

TEST(PaceTest, IsTheLastSecondsAndNotTheWholeTrials) {
  Pace pace;
  EXPECT_TRUE(pace.keeps_up({50, 1, 0})) << "one late force at the start is none to speak of";
  long long ticks = 0, late = 0;
  for (; ticks < 300000; ticks += 33) ASSERT_TRUE(pace.keeps_up({ticks, 0, 0}));
  long long until = ticks;
  while (pace.keeps_up({until, late, 0})) {
    until += 33;
    late += 3;
    ASSERT_LT(until - ticks, 4000) << "every tenth is late, and five good minutes do not hide it";
  }
  // And again well within a few seconds.
  for (until += 33; !pace.keeps_up({until, late, 0}); until += 33) ASSERT_LT(until - ticks, 12000);
  EXPECT_TRUE(pace.keeps_up({10, 5, 0})) << "begun anew";
  Pace dropping;
  EXPECT_FALSE(dropping.keeps_up({9000, 11, 250}));
}

}  // namespace
}  // namespace vallecula::gui::test
