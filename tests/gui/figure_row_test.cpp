// What a trial's verdict and a figure that it has not are called for people.
#include <gtest/gtest.h>

#include <algorithm>

#include "gui/pages/result_figures.h"
#include "gui/report/figure_row.h"

namespace vallecula::gui {
namespace {

TEST(FigureRow, ATrialThatIsNotCountedSaysSoAndWhy) {
  curricula::Score score;
  EXPECT_STREQ(verdict(score), "Not passed");
  score.passed = true;
  EXPECT_STREQ(verdict(score), "Passed");
  score.set_aside = {"The instructor closed the vocal cords"};
  EXPECT_STREQ(verdict(score), "Changed by the instructor: not counted for the course");
  score.at_vallecula = true;
  EXPECT_STREQ(verdict(score), "Practice with help: not counted for the course");
}

TEST(FigureRow, WhereTheBladeNeverEnteredTheMouthThatIsSaid) {
  TrialOutcome outcome;
  outcome.score.intubation.emplace();
  outcome.score.criteria.push_back({"lowest_spo2_percent", "%", 0.0, 80.0, -1.0, false, ""});
  const auto rows = result_figures(outcome, {});
  for (const char* name : {"Lowest SpO2", "Lowest heart rate", "Attempt"}) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    ASSERT_NE(found, rows.end()) << name;
    EXPECT_EQ(found->value, "no attempt") << name;
    EXPECT_EQ(found->limit, "the blade did not enter the mouth") << name;
    EXPECT_EQ(found->verdict, "") << name << ": what was never tried is neither met nor missed";
  }
}

}  // namespace
}  // namespace vallecula::gui
