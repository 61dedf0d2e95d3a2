// A scenario for the size of the patient that is to be practised on. Sizes by the shipped courses' weights.
#include "gui/pages/fitting_scenario.h"

#include <gtest/gtest.h>

#include "gui/session/patient_fit.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {
namespace {

using curricula::Curriculum;

Curriculum shipped(const char* file) { return curricula::load_curriculum(curricula_folder() / file); }

OpenScenarios all_of(const Curriculum& course) {
  OpenScenarios open{&course, {}};
  for (const curricula::Scenario& one : course.scenarios) open.ids.push_back(one.id);
  return open;
}

std::string id_of(const FittingScenario& found) { return found.scenario == nullptr ? "" : found.scenario->id; }

TEST(FittingScenario, IsTheNearestInWeightThatAsksForTheSame) {
  const Curriculum steps = shipped("first-steps.yaml"), tubes = shipped("first-intubation.yaml");
  EXPECT_EQ(id_of(fitting_scenario({all_of(steps)}, steps.find("term"), 1.2)), "preterm");
  EXPECT_EQ(id_of(fitting_scenario({all_of(steps)}, steps.find("preterm"), 3.2)), "term");
  EXPECT_EQ(id_of(fitting_scenario({all_of(tubes)}, tubes.find("term-tube"), 1.2)), "preterm-premedicated");
  EXPECT_EQ(id_of(fitting_scenario({all_of(tubes), all_of(steps)}, tubes.find("term-tube"), 0.8)),
            "preterm-premedicated")
      << "with a tube, as was wanted, though none fits";
  EXPECT_EQ(id_of(fitting_scenario({all_of(steps)}, nullptr, 1.0)), "preterm");
}

TEST(FittingScenario, IsOfAnotherCourseWhereNoneThatIsOpenFits) {
  const Curriculum whole = shipped("neonatal-intubation.yaml"), steps = shipped("first-steps.yaml");
  const OpenScenarios begun{&whole, {"way-in", "lift", "light-hand"}};
  const FittingScenario found = fitting_scenario({begun, all_of(steps)}, whole.find("way-in"), 1.2);
  ASSERT_EQ(id_of(found), "preterm");
  EXPECT_EQ(found.course, &steps);
  EXPECT_EQ(id_of(fitting_scenario({begun}, whole.find("way-in"), 1.2)), "") << "3.4 kg is no nearer than 3.2";
}

TEST(FittingScenario, ASizeFitsWithinFifteenPercent) {
  curricula::Scenario term;
  term.manikin.weight_kg = 3.2;
  EXPECT_TRUE(fits(term, 3.2 * 1.14 * 1.14 * 1.14));
  EXPECT_FALSE(fits(term, 3.2 * 1.16 * 1.16 * 1.16));
  EXPECT_TRUE(fits(term, 3.2 * 0.86 * 0.86 * 0.86));
  EXPECT_FALSE(fits(term, 3.2 * 0.84 * 0.84 * 0.84));
}

}  // namespace
}  // namespace vallecula::gui
