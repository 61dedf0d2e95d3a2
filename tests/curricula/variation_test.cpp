// Attempts drawn from a scenario's variation.
#include <gtest/gtest.h>

#include <set>

#include "curricula/scenario.h"
#include "tests/curricula/full_course.h"
#include "tests/curricula/temporary_folder.h"

namespace vallecula::curricula {
namespace {

class Attempts : public testing::TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    course_ = load_curriculum(write("course.yaml", testing::kFullCourse));
  }
  Scenario drawn(std::uint32_t seed, Mode mode = Mode::practice) const {
    return attempt_of(*course_.find("two"), mode, seed);
  }
  Curriculum course_;
};

TEST_F(Attempts, TheSameSeedIsTheSameAttemptAndItsOwnTextSaysSo) {
  for (const std::uint32_t seed : {1u, 77u, 4294967295u}) {
    const Scenario s = drawn(seed);
    EXPECT_EQ(s.yaml, drawn(seed).yaml);
    EXPECT_EQ(s.attempt.seed, seed);
    EXPECT_EQ(s.attempt.mode, Mode::practice);
    const Scenario again = parse_scenario(s.yaml, "log");
    EXPECT_EQ(again.attempt.seed, seed);
    EXPECT_EQ(again.tongue_young_pa, s.tongue_young_pa);
    EXPECT_EQ(again.manikin.seed, s.manikin.seed);
    EXPECT_EQ(again.intubation->secretions_ml, s.intubation->secretions_ml);
    EXPECT_EQ(again.distractions[1].at_s, s.distractions[1].at_s);
  }
}

TEST_F(Attempts, NoTwoOfAThousandAreTheSameAndEachStaysInItsRanges) {
  std::set<std::string> texts;
  std::set<unsigned> infants;
  std::set<std::string> shapes;
  double softest = 1e9, stiffest = 0.0, least = 1e9, most = 0.0;
  for (std::uint32_t seed = 1; seed <= 1000; ++seed) {
    const Scenario s = drawn(seed);
    texts.insert(s.yaml.substr(0, s.yaml.find("attempt:")));
    infants.insert(s.manikin.seed);
    char shape[128];
    std::snprintf(shape, sizeof shape, "%u %g %g %g %g", s.manikin.seed, *s.manikin.mouth_opening,
                  *s.manikin.tongue_size, *s.manikin.larynx_height_mm, *s.manikin.epiglottis_length);
    shapes.insert(shape);
    EXPECT_GE(*s.manikin.mouth_opening, 0.9);
    EXPECT_LE(*s.manikin.mouth_opening, 1.0);
    EXPECT_GE(*s.manikin.larynx_height_mm, -1.0);
    EXPECT_LE(*s.manikin.larynx_height_mm, 1.0);
    EXPECT_GE(*s.manikin.epiglottis_length, 0.9);
    EXPECT_LE(*s.manikin.epiglottis_length, 1.15);
    softest = std::min(softest, s.tongue_young_pa);
    stiffest = std::max(stiffest, s.tongue_young_pa);
    least = std::min(least, s.intubation->secretions_ml);
    most = std::max(most, s.intubation->secretions_ml);
    const double delay = s.distractions[0].at_s - 10.0;
    EXPECT_GE(delay, 1.0 - 1e-9);
    EXPECT_LE(delay, 9.0 + 1e-9);
    EXPECT_NEAR(s.distractions[2].at_s - s.distractions[0].at_s, 20.0, 1e-9) << "all by the same";
    EXPECT_NE(s.intubation->infant_seed, 0u);
    EXPECT_EQ(s.blade, "miller-1");  // what is not varied stays
    EXPECT_EQ(s.intubation->tube, "3.0");
  }
  EXPECT_EQ(texts.size(), 1000u);
  // Of 1000 evenly drawn, the ends are met to within 1 %; the chance of missing one by that is 4e-5.
  EXPECT_GE(softest, 5000.0);
  EXPECT_LT(softest, 5030.0);
  EXPECT_LE(stiffest, 8000.0);
  EXPECT_GT(stiffest, 7970.0);
  EXPECT_GE(least, 0.5);
  EXPECT_LT(least, 0.515);
  EXPECT_LE(most, 2.0);
  EXPECT_GT(most, 1.985);
  EXPECT_EQ(infants.size(), 3u) << "as many patients to be made as the file says, the written one among them";
  EXPECT_EQ(infants.count(7), 1u);
  EXPECT_EQ(shapes.size(), 3u) << "an infant keeps its shape";
}

TEST_F(Attempts, SeedNoneAndScenariosWithoutVariationAreWhatIsWritten) {
  const Scenario& written = *course_.find("two");
  const Scenario same = drawn(0);
  EXPECT_EQ(same.manikin.seed, written.manikin.seed);
  EXPECT_EQ(same.tongue_young_pa, written.tongue_young_pa);
  EXPECT_EQ(same.intubation->secretions_ml, written.intubation->secretions_ml);
  EXPECT_EQ(same.distractions[0].at_s, written.distractions[0].at_s);
  EXPECT_EQ(attempt_of(*course_.find("one"), Mode::practice, 5).attempt.seed, 0u);
}

TEST_F(Attempts, AssessmentLocksTheSeedAndTakesTheHelpsAway) {
  const Scenario s = drawn(1234, Mode::assessment);
  EXPECT_EQ(s.attempt.mode, Mode::assessment);
  EXPECT_EQ(s.attempt.seed, 0u);
  EXPECT_EQ(s.yaml, drawn(99, Mode::assessment).yaml);
  EXPECT_EQ(s.manikin.seed, 7u);
  for (const Scenario& each : {s, attempt_of(*course_.find("one"), Mode::assessment, 0)}) {
    EXPECT_FALSE(each.assistance.ghost_path);
    EXPECT_FALSE(each.assistance.glottis_highlight);
    EXPECT_FALSE(each.assistance.cut_view);
    EXPECT_FALSE(each.assistance.force_bar);
    EXPECT_FALSE(each.assistance.video_view);
    EXPECT_FALSE(each.assistance.expert_loop);
  }
  EXPECT_TRUE(drawn(1).assistance.ghost_path) << "practice leaves what the scenario has";
  const ModeRules practice = rules_of(Mode::practice), assessment = rules_of(Mode::assessment);
  EXPECT_TRUE(practice.replay && practice.assistance && practice.variation && !practice.self_rating_before);
  EXPECT_TRUE(!assessment.replay && !assessment.assistance && !assessment.variation && assessment.self_rating_before);
}

TEST_F(Attempts, OneMoreRangeLeavesWhatTheOthersDraw) {
  std::string fewer = testing::kFullCourse;
  for (const char* gone : {"      secretions_ml: [0.5, 2]\n", "      mouth_opening: [0.9, 1]\n"})
    fewer.erase(fewer.find(gone), std::string(gone).size());
  const Curriculum other = load_curriculum(write("fewer.yaml", fewer));
  for (std::uint32_t seed = 1; seed < 20; ++seed) {
    const Scenario a = drawn(seed), b = attempt_of(*other.find("two"), Mode::practice, seed);
    EXPECT_EQ(a.tongue_young_pa, b.tongue_young_pa);
    EXPECT_EQ(a.manikin.seed, b.manikin.seed);
    EXPECT_EQ(*a.manikin.epiglottis_length, *b.manikin.epiglottis_length);
    EXPECT_EQ(b.intubation->secretions_ml, 1.5);
    EXPECT_EQ(*b.manikin.mouth_opening, 0.9);
  }
}

}  // namespace
}  // namespace vallecula::curricula
