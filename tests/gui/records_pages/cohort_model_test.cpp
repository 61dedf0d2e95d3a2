#include "gui/records_pages/cohort_model.h"

#include <gtest/gtest.h>

namespace vallecula::gui {
namespace {

curricula::CurveSummary curve(const std::string& name, const std::string& scenario, const std::string& device,
                              int trials, const std::string& last) {
  curricula::CurveSummary one;
  one.key = {1, "course", scenario, device};
  one.trainee_name = name;
  one.trials = trials;
  one.passed = trials / 2;
  one.set_aside = 2;
  one.last_utc = last;
  one.cusum = curricula::cusum({}, std::vector<bool>(8, true));
  return one;
}

class Cohort : public ::testing::Test {
 protected:
  Cohort() {
    model_.set_curves({curve("Kiwi", "term", "mouse", 12, "2026-05-03T10:00:00Z"),
                       curve("Kiwi", "term", "touch", 3, "2026-05-04T10:00:00Z"),
                       curve("emu", "preterm", "mouse", 100, "2026-01-04T10:00:00Z")});
    shown_.setSourceModel(&model_);
  }
  QString shown(int row, CohortModel::Column column) const {
    return shown_.index(row, column).data(Qt::DisplayRole).toString();
  }
  KnownCourses courses_;
  CohortModel model_{courses_, nullptr};
  CohortFilterModel shown_{nullptr};
};

TEST_F(Cohort, EveryColumnHasItsHeadingAndItsCell) {
  ASSERT_EQ(model_.columnCount(), CohortModel::kColumns);
  for (int column = 0; column < CohortModel::kColumns; ++column) {
    EXPECT_NE(model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(), "");
    EXPECT_NE(model_.index(0, column).data(Qt::DisplayRole).toString(), "") << column;
  }
  EXPECT_EQ(model_.index(0, CohortModel::kCusum).data(Qt::DisplayRole).toString(), "competent (trial 8)");
  EXPECT_EQ(model_.index(0, CohortModel::kSetAside).data(Qt::DisplayRole).toInt(), 2);
  EXPECT_EQ(model_.index(0, CohortModel::kScenario).data(Qt::DisplayRole).toString(), "term")
      << "not known here: its id";
}

TEST_F(Cohort, NumbersSortAsNumbersAndNamesWithoutRegardToCapitals) {
  shown_.sort(CohortModel::kTrials, Qt::DescendingOrder);
  EXPECT_EQ(shown(0, CohortModel::kTrials), "100");
  EXPECT_EQ(shown(1, CohortModel::kTrials), "12");
  shown_.sort(CohortModel::kTrainee, Qt::AscendingOrder);
  EXPECT_EQ(shown(0, CohortModel::kTrainee), "emu");
  shown_.sort(CohortModel::kLast, Qt::DescendingOrder);
  EXPECT_EQ(shown(0, CohortModel::kDevice), "touch");
}

TEST_F(Cohort, FiltersHoldTogether) {
  shown_.set_only(CohortModel::kScenario, "term");
  EXPECT_EQ(shown_.rowCount(), 2);
  shown_.set_only(CohortModel::kDevice, "touch");
  EXPECT_EQ(shown_.rowCount(), 1);
  shown_.set_name_contains("EMU");
  EXPECT_EQ(shown_.rowCount(), 0);
  shown_.set_only(CohortModel::kScenario, "");
  shown_.set_only(CohortModel::kDevice, "");
  EXPECT_EQ(shown_.rowCount(), 1);
}

}  // namespace
}  // namespace vallecula::gui
