#include "curricula/scenario.h"

#include <regex>
#include <set>

#include "tests/curricula/temporary_folder.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;
using testing::error_of;

const char* const kGood = R"(schema: 1
id: test-course
title: A course
blades_by_weight:
  - { below_kg: 1.0, blade: miller-00 }
  - { below_kg: 3.0, blade: miller-0 }
scenarios:
  - id: first
    title: First
    briefing: Do it.
    debriefing: Done.
    manikin: { weight_kg: 1.5, seed: 4 }
    sight_percent: 25
    max_attempt_s: 60
    targets:
      tongue_force_n: 5
      gum_force_n: 2
    pass:
      peak_tongue_force_n: 6.5
      peak_gum_force_n: 3
      glottis_visible_percent: 50
      attempt_time_s: 30
      time_over_target_s: 3
      time_over_device_limit_s: 0.2
)";

/// The same with an intubation, from line 25 on.
const char* const kIntubation = R"(    intubation:
      tube: "3.0"
      stylet: true
      stylet_mm: 1.5
      catheter_f: 6
      course: delivery-room
      gestation_weeks: 31.5
      infant_seed: 17
      added_oxygen_percent: 20
      premedicated: false
      laryngospasm_s: 25
      laryngospasm_from_start: true
      cord_closure_s: 2
      secretions_ml: 1.5
      laryngeal_pressure_n: 4
      breaths_to_confirm: 5
      pass:
        outcomes: [good-depth, too-shallow]
        lowest_spo2_percent: 60
        lowest_heart_per_min: 80
        tube_force_n: 2
        time_to_pass_s: 20
        attempts: 2
        co2_confirmed: true
        depth_neutral: true
        oesophagus_in_time: true
        no_severe_desaturation: true
      breathes: false
)";

std::string with_other(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class CurriculumFile : public testing::TemporaryFolder {
 protected:
  std::string error(const std::string& text) {
    const fs::path file = write("course.yaml", text);
    return error_of<CurriculumError>([&] { load_curriculum(file); });
  }
};

TEST_F(CurriculumFile, ReadsEveryField) {
  const Curriculum c = load_curriculum(write("course.yaml", kGood));
  EXPECT_EQ(c.id, "test-course");
  EXPECT_EQ(c.title, "A course");
  ASSERT_EQ(c.scenarios.size(), 1u);
  const Scenario& s = c.scenarios[0];
  EXPECT_EQ(c.find("first"), &s);
  EXPECT_EQ(c.find("second"), nullptr);
  EXPECT_EQ(s.title, "First");
  EXPECT_EQ(s.briefing.in("en"), "Do it.");
  EXPECT_EQ(s.debriefing.in("en"), "Done.");
  EXPECT_EQ(s.manikin.weight_kg, 1.5);
  EXPECT_EQ(s.manikin.seed, 4u);
  EXPECT_EQ(s.blade, "miller-0");  // from the table
  EXPECT_EQ(s.tongue_young_pa, 0.0);
  EXPECT_EQ(s.sight_percent, 25.0);
  EXPECT_EQ(s.max_attempt_s, 60.0);
  EXPECT_EQ(s.targets.tongue_force_n, 5.0);
  EXPECT_EQ(s.targets.gum_force_n, 2.0);
  EXPECT_EQ(s.pass.peak_tongue_force_n, 6.5);
  EXPECT_EQ(s.pass.peak_gum_force_n, 3.0);
  EXPECT_EQ(s.pass.glottis_visible_percent, 50.0);
  EXPECT_EQ(s.pass.attempt_time_s, 30.0);
  EXPECT_EQ(s.pass.time_over_target_s, 3.0);
  EXPECT_EQ(s.pass.time_over_device_limit_s, 0.2);
}

TEST_F(CurriculumFile, ReadsEveryFieldOfAnIntubation) {
  EXPECT_FALSE(load_curriculum(write("course.yaml", kGood)).scenarios[0].intubation);
  const Curriculum c = load_curriculum(write("course.yaml", std::string(kGood) + kIntubation));
  for (const Scenario& scenario : {c.scenarios[0], parse_scenario(c.scenarios[0].yaml, "log")}) {
    ASSERT_TRUE(scenario.intubation);
    const IntubationSpec& i = *scenario.intubation;
    EXPECT_EQ(i.tube, "3.0");
    EXPECT_TRUE(i.stylet);
    EXPECT_EQ(i.stylet_mm, 1.5);
    EXPECT_EQ(i.catheter_f, 6);
    EXPECT_EQ(i.course, InfantCourse::delivery_room);
    EXPECT_EQ(i.gestation_weeks, 31.5);
    EXPECT_EQ(i.infant_seed, 17u);
    EXPECT_EQ(i.added_oxygen_percent, 20.0);
    EXPECT_FALSE(i.premedicated);
    EXPECT_EQ(i.laryngospasm_s, 25.0);
    EXPECT_TRUE(i.laryngospasm_from_start);
    EXPECT_EQ(i.cord_closure_s, 2.0);
    EXPECT_EQ(i.secretions_ml, 1.5);
    EXPECT_EQ(i.laryngeal_pressure_n, 4.0);
    EXPECT_EQ(i.breaths_to_confirm, 5);
    EXPECT_EQ(i.pass.outcomes, (std::vector<Outcome>{Outcome::good_depth, Outcome::too_shallow}));
    EXPECT_EQ(i.pass.lowest_spo2_percent, 60.0);
    EXPECT_EQ(i.pass.lowest_heart_per_min, 80.0);
    EXPECT_EQ(i.pass.tube_force_n, 2.0);
    EXPECT_EQ(i.pass.time_to_pass_s, 20.0);
    EXPECT_EQ(i.pass.attempts, 2);
    EXPECT_TRUE(i.pass.co2_confirmed);
    EXPECT_TRUE(i.pass.depth_neutral);
    EXPECT_TRUE(i.pass.oesophagus_in_time);
    EXPECT_TRUE(i.pass.no_severe_desaturation);
    EXPECT_FALSE(i.breathes);
  }
}

TEST_F(CurriculumFile, WhatAnIntubationDoesNotSayFollowsFromItsCourseAndWeight) {
  const std::string with_tubes =
      with_other(kGood, "scenarios:", "tubes_by_weight:\n  - { below_kg: 2.0, tube: 3.0 }\nscenarios:");
  const struct {
    const char *course, *weeks;
    bool premedicated;
    double added_oxygen, closure_s;
  } cases[] = {{"premedicated-preterm", "32", true, 10.0, 0.0},
               {"term", "32.5", false, 10.0, 1.0},
               {"preoxygenated", "30", true, 0.0, 0.0},
               {"delivery-room", "33", false, 10.0, 1.0}};
  for (const auto& c : cases) {
    const std::string block =
        std::string("    intubation: { course: ") + c.course + ", gestation_weeks: " + c.weeks + " }\n";
    const Curriculum course = load_curriculum(write("course.yaml", with_tubes + block));
    for (const Scenario& scenario : {course.scenarios[0], parse_scenario(course.scenarios[0].yaml, "log")}) {
      ASSERT_TRUE(scenario.intubation) << c.course;
      const IntubationSpec& i = *scenario.intubation;
      EXPECT_EQ(i.tube, "3.0") << "settled by weight, also in the scenario's own text";
      EXPECT_EQ(i.premedicated, c.premedicated) << c.course;
      EXPECT_EQ(i.breathes, !c.premedicated) << c.course << ": whoever has no relaxant breathes, and its cords open";
      EXPECT_EQ(i.added_oxygen_percent, c.added_oxygen) << c.course;
      EXPECT_EQ(i.cord_closure_s, c.closure_s) << c.course;
      EXPECT_EQ(i.pass.outcomes, std::vector<Outcome>{Outcome::good_depth});
      EXPECT_FALSE(i.pass.lowest_spo2_percent || i.pass.lowest_heart_per_min || i.pass.tube_force_n ||
                   i.pass.time_to_pass_s || i.pass.attempts || i.pass.co2_confirmed ||
                   i.pass.depth_neutral || i.pass.oesophagus_in_time || i.pass.no_severe_desaturation);
    }
  }
}

TEST_F(CurriculumFile, EveryMistakeInAnIntubationNamesItsFieldAndWhatIsAllowed) {
  const std::string good = std::string(kGood) + kIntubation;
  const struct {
    const char *from, *to;
    int line;
    const char *field, *value, *allowed;
  } cases[] = {
      {"tube: \"3.0\"", "tube: 4", 26, "tube", "'4'", "one of 2.5, 3.0, 3.5, 4.0"},
      {"      tube: \"3.0\"\n", "", 26, "tube", "missing", "tubes_by_weight above 1.5 kg"},
      {"stylet: true", "stylet: yes", 27, "stylet", "'yes'", "true or false"},
      {"stylet: true", "stylet: \"true\"", 27, "stylet", "'true'", "true or false"},
      {"stylet: true", "stylet: [true]", 27, "stylet", "a list", "true or false"},
      {"stylet: true", "stylet: false", 28, "stylet_mm", "'1.5'", "none where stylet is false"},
      {"stylet_mm: 1.5", "stylet_mm: 3", 28, "stylet_mm", "'3'", "thinner than the tube of 3.0 mm"},
      {"catheter_f: 6", "catheter_f: 7", 29, "catheter_f", "'7'", "one of 0, 6, 8, 10"},
      {"course: delivery-room", "course: theatre", 30, "course", "'theatre'", "premedicated-preterm, term"},
      {"      course: delivery-room\n", "", 26, "course", "missing", "premedicated-preterm, term"},
      {"gestation_weeks: 31.5", "gestation_weeks: 20", 31, "gestation_weeks", "'20'", "from 22 to 44"},
      {"      gestation_weeks: 31.5\n", "", 26, "gestation_weeks", "missing", "from 22 to 44"},
      {"infant_seed: 17", "infant_seed: -1", 32, "infant_seed", "'-1'", "a whole number from 0"},
      {"added_oxygen_percent: 20", "added_oxygen_percent: 80", 33, "added_oxygen_percent", "'80'", "from 0 to 79"},
      {"laryngospasm_s: 25", "laryngospasm_s: 121", 35, "laryngospasm_s", "'121'", "from 0 to 120"},
      {"laryngospasm_s: 25", "laryngospasm_s: 0", 36, "laryngospasm_from_start", "'true'", "false where"},
      {"secretions_ml: 1.5", "secretions_ml: 6", 38, "secretions_ml", "'6'", "from 0 to 5"},
      {"laryngeal_pressure_n: 4", "laryngeal_pressure_n: true", 39, "laryngeal_pressure_n", "'true'", "from 0 to 10"},
      {"breaths_to_confirm: 5", "breaths_to_confirm: 0", 40, "breaths_to_confirm", "'0'", "from 1 to 20"},
      {"[good-depth, too-shallow]", "[good-depth, deep]", 42, "pass.outcomes[1]", "'deep'", "one of good-depth"},
      {"[good-depth, too-shallow]", "[mainstem, mainstem]", 42, "pass.outcomes[1]", "'mainstem'", "once"},
      {"[good-depth, too-shallow]", "[]", 42, "pass.outcomes", "a list of 0", "a list of 1 to 9"},
      {"lowest_spo2_percent: 60", "lowest_spo2_percent: 0.6", 43, "pass.lowest_spo2_percent", "'0.6'", "from 1 to 100"},
      {"attempts: 2", "attempts: none", 47, "pass.attempts", "'none'", "from 1 to 20"},
      {"co2_confirmed: true", "co2: true", 48, "pass.co2", "'true'", "co2_confirmed"},
      {"breathes: false", "breathes: often", 52, "breathes", "'often'", "true or false"},
      // What contradicts what.
      {"catheter_f: 6", "catheter_f: 0", 38, "secretions_ml", "'1.5'", "0 where catheter_f is 0"},
      {"breaths_to_confirm: 5", "breaths_to_confirm: 4", 40, "breaths_to_confirm", "'4'", "5 or 6 where pass.co2"},
      {"breaths_to_confirm: 5", "breaths_to_confirm: 7", 40, "breaths_to_confirm", "'7'", "5 or 6 where pass.co2"},
      {"premedicated: false", "premedicated: true", 34, "premedicated", "'true'", "false in the course delivery-room"},
      {"course: delivery-room", "course: term", 31, "gestation_weeks", "'31.5'",
       "more than 32 weeks in the course term"},
      {"course: delivery-room\n      gestation_weeks: 31.5", "course: premedicated-preterm\n      gestation_weeks: 33",
       31, "gestation_weeks", "'33'", "at most 32 weeks in the course premedicated-preterm"},
      {"course: delivery-room", "course: premedicated-preterm", 34, "premedicated", "'false'", "true in the course"},
      {"course: delivery-room", "course: preoxygenated", 33, "added_oxygen_percent", "'20'", "0 in the course"},
      {"course: delivery-room\n      gestation_weeks: 31.5\n      infant_seed: 17\n      added_oxygen_percent: 20\n"
       "      premedicated: false",
       "course: premedicated-preterm\n      gestation_weeks: 30", 32, "laryngospasm_s", "'25'",
       "0 where the infant is premedicated"},
      {"course: delivery-room\n      gestation_weeks: 31.5\n      infant_seed: 17\n      added_oxygen_percent: 20\n"
       "      premedicated: false\n      laryngospasm_s: 25\n      laryngospasm_from_start: true",
       "course: premedicated-preterm\n      gestation_weeks: 30", 32, "cord_closure_s", "'2'",
       "0 where the infant is premedicated"},
  };
  for (const auto& c : cases) {
    const std::string message = error(with_other(good, c.from, c.to));
    for (const std::string& part : {":" + std::to_string(c.line) + ": scenarios[0].intubation." + c.field + " is",
                                    std::string(c.value), std::string(c.allowed)}) {
      EXPECT_NE(message.find(part), std::string::npos) << c.to << " lacks '" << part << "' -> " << message;
    }
  }
  const std::string relaxed = with_other(with_other(good, "course: delivery-room", "course: premedicated-preterm"),
                                         "premedicated: false", "premedicated: true");
  const std::string still = with_other(with_other(with_other(relaxed, "laryngospasm_s: 25", "laryngospasm_s: 0"),
                                                  "from_start: true", "from_start: false"),
                                       "cord_closure_s: 2", "cord_closure_s: 0");
  EXPECT_EQ(error(still), "");
  EXPECT_NE(error(with_other(still, "breathes: false", "breathes: true"))
                .find("intubation.breathes is 'true'; allowed: false where the infant is premedicated"),
            std::string::npos);
  // By the growth chart 1.50 kg at 31.5 weeks (half to 1.6 times of it allowed, assumed); 0.65 at 24, 3.1 at 38.
  EXPECT_NE(error(with_other(good, "gestation_weeks: 31.5", "gestation_weeks: 39"))
                .find(":12: scenarios[0].manikin.weight_kg is '1.5'; allowed: from 1.74 kg to 5.54 kg at 39 weeks "
                      "(intubation.gestation_weeks)"),
            std::string::npos)
      << error(with_other(good, "gestation_weeks: 31.5", "gestation_weeks: 39"));
  EXPECT_NE(error(with_other(good, "gestation_weeks: 31.5", "gestation_weeks: 24"))
                .find("from 0.33 kg to 1.04 kg at 24 weeks"),
            std::string::npos);
  const std::string twice =
      with_other(kGood, "scenarios:",
                 "tubes_by_weight:\n  - { below_kg: 2, tube: 3.0 }\n  - { below_kg: 2, tube: 3.5 }\n"
                 "scenarios:");
  EXPECT_NE(error(twice).find(":9: tubes_by_weight[1].below_kg is '2'; allowed: more than the row before, 2 kg"),
            std::string::npos)
      << error(twice);
}

TEST(Outcomes, EachHasAWordOfItsOwn) {
  std::set<std::string> words;
  for (int i = 0; i < kOutcomes; ++i) {
    const auto outcome = static_cast<Outcome>(i);
    words.insert(name_of(outcome));
    EXPECT_EQ(outcome_named(name_of(outcome)), outcome);
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(kOutcomes));
  EXPECT_FALSE(outcome_named("deep"));
}

TEST_F(CurriculumFile, AScenariosOwnTextSaysTheSame) {
  const Curriculum shipped = load_curriculum(fs::path(VALLECULA_SOURCE_DIR) / "curricula/courses/first-steps.yaml");
  ASSERT_EQ(shipped.scenarios.size(), 3u);
  for (const Scenario& s : shipped.scenarios) {
    const Scenario again = parse_scenario(s.yaml, "log");
    EXPECT_EQ(again.id, s.id);
    EXPECT_EQ(again.title, s.title);
    EXPECT_EQ(again.briefing.by_language(), s.briefing.by_language());
    EXPECT_EQ(again.debriefing.by_language(), s.debriefing.by_language());
    EXPECT_EQ(again.blade, s.blade);
    EXPECT_EQ(again.manikin.weight_kg, s.manikin.weight_kg);
    EXPECT_EQ(again.manikin.seed, s.manikin.seed);
    EXPECT_EQ(again.tongue_young_pa, s.tongue_young_pa);
    EXPECT_EQ(again.pass.peak_tongue_force_n, s.pass.peak_tongue_force_n);
    EXPECT_EQ(again.pass.time_over_device_limit_s, s.pass.time_over_device_limit_s);
    EXPECT_EQ(again.yaml, s.yaml);
  }
}

/// What a trainee is told to do is what the rubric judges: numbers in the briefing are the pass limits.
TEST_F(CurriculumFile, ABriefingAsksForWhatTheRubricAsksFor) {
  int percentages = 0, times = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(VALLECULA_SOURCE_DIR) / "curricula/courses")) {
    if (entry.path().extension() != ".yaml") continue;
    for (const Scenario& s : load_curriculum(entry.path()).scenarios) {
      const std::string briefing = s.briefing.in("en");
      const auto each = [&](const std::regex& number, double limit, int& count) {
        for (std::sregex_iterator it(briefing.begin(), briefing.end(), number), end; it != end; ++it, ++count) {
          EXPECT_EQ(std::stod((*it)[1]), limit) << entry.path() << ", " << s.id << ": " << briefing;
        }
      };
      each(std::regex("([0-9.]+) *(?:%|percent)"), s.pass.glottis_visible_percent, percentages);
      each(std::regex("([0-9.]+) seconds"), s.pass.attempt_time_s, times);
      EXPECT_EQ(briefing.find("half of the glottis"), std::string::npos) << s.id;
    }
  }
  EXPECT_GE(percentages, 3) << "the shipped briefings state the share of the glottis";
  EXPECT_GE(times, 3);
}

TEST_F(CurriculumFile, TheShippedCourseGoesFromTermToPretermToDifficult) {
  const Curriculum c = load_curriculum(fs::path(VALLECULA_SOURCE_DIR) / "curricula/courses/first-steps.yaml");
  ASSERT_EQ(c.scenarios.size(), 3u);
  EXPECT_EQ(c.scenarios[0].manikin.weight_kg, 3.2);
  EXPECT_EQ(c.scenarios[0].blade, "miller-1");
  EXPECT_EQ(c.scenarios[1].manikin.weight_kg, 1.2);
  EXPECT_EQ(c.scenarios[1].blade, "miller-0");
  EXPECT_GT(c.scenarios[2].tongue_young_pa, 6000.0);  // CLINICAL's default tongue
  EXPECT_NE(c.scenarios[2].manikin.seed, c.scenarios[0].manikin.seed);
  // A limit above what the simulated devices give (7.9 N) could never be exceeded.
  for (const Scenario& s : c.scenarios) EXPECT_LT(s.pass.peak_tongue_force_n, 7.9);
}

TEST_F(CurriculumFile, TheShippedIntubationsGoThroughTheCoursesWithTheirTubes) {
  const Curriculum c = load_curriculum(fs::path(VALLECULA_SOURCE_DIR) / "curricula/courses/first-intubation.yaml");
  ASSERT_EQ(c.scenarios.size(), 5u);
  std::set<InfantCourse> courses;
  for (const Scenario& s : c.scenarios) {
    ASSERT_TRUE(s.intubation) << s.id;
    courses.insert(s.intubation->course);
    // By weight the preterm infant would have a 3.0, which its manikin's cricoid does not let through.
    EXPECT_EQ(s.intubation->tube, s.id == "preterm-premedicated" ? "2.5" : "3.5") << s.id;
    EXPECT_EQ(s.intubation->pass.outcomes, std::vector<Outcome>{Outcome::good_depth}) << s.id;
    EXPECT_TRUE(s.intubation->pass.co2_confirmed) << s.id;
    EXPECT_TRUE(s.intubation->pass.oesophagus_in_time) << s.id;
    if (s.briefing.in("en").find("open with a breath") != std::string::npos) {
      EXPECT_TRUE(s.intubation->breathes) << s.id << ": cords that open with no breath";
    }
    EXPECT_LT(*s.intubation->pass.tube_force_n, 3.3) << s.id << ": no device here could exceed it";
    EXPECT_GE(s.max_attempt_s, *s.intubation->pass.attempts * s.pass.attempt_time_s + 30.0)
        << s.id << ": no time to ventilate between its attempts";
    EXPECT_EQ(parse_scenario(s.yaml, "log").intubation->tube, s.intubation->tube) << s.id;
  }
  EXPECT_EQ(courses, (std::set<InfantCourse>{InfantCourse::premedicated_preterm, InfantCourse::term,
                                             InfantCourse::delivery_room}));
  EXPECT_GT(c.find("secretions")->intubation->secretions_ml, 0.0);
  EXPECT_GT(c.find("secretions")->intubation->catheter_f, 0);
  EXPECT_GT(c.find("laryngospasm")->intubation->laryngospasm_s, 0.0);
}

TEST_F(CurriculumFile, EveryMistakeNamesFileLineFieldValueAndWhatIsAllowed) {
  const struct {
    const char *from, *to;
    int line;
    const char *field, *value, *allowed;
  } cases[] = {
      {"seed: 4", "seed: 4, sed: 5", 12, "scenarios[0].manikin.sed", "'5'", "weight_kg"},
      {"sight_percent: 25", "sight_percnt: 25", 13, "scenarios[0].sight_percnt", "'25'", "sight_percent"},
      {"    sight_percent: 25\n", "", 8, "scenarios[0].sight_percent", "missing", "from 1 to 100"},
      {"weight_kg: 1.5", "weight_kg: light", 12, "scenarios[0].manikin.weight_kg", "'light'", "from 0.6 to 4.5"},
      {"weight_kg: 1.5", "weight_kg: \"1.5\"", 12, "scenarios[0].manikin.weight_kg", "'1.5'", "a number"},
      {"weight_kg: 1.5", "weight_kg: .nan", 12, "scenarios[0].manikin.weight_kg", "'.nan'", "from 0.6 to 4.5"},
      {"weight_kg: 1.5", "weight_kg: .inf", 12, "scenarios[0].manikin.weight_kg", "'.inf'", "from 0.6 to 4.5"},
      {"weight_kg: 1.5", "weight_kg: 9", 12, "scenarios[0].manikin.weight_kg", "'9'", "from 0.6 to 4.5"},
      {"weight_kg: 1.5", "weight_kg: 1,5", 12, "scenarios[0].manikin", "", "weight_kg"},
      {"weight_kg: 1.5", "weight_kg: ", 12, "scenarios[0].manikin.weight_kg", "empty", "from 0.6 to 4.5"},
      {"seed: 4", "seed: -4", 12, "scenarios[0].manikin.seed", "'-4'", "a whole number from 0"},
      {"seed: 4", "seed: 4.5", 12, "scenarios[0].manikin.seed", "'4.5'", "a whole number"},
      {"seed: 4", "seed: 4294967296", 12, "scenarios[0].manikin.seed", "'4294967296'", "4294967295"},
      {"seed: 4", "seed: [4]", 12, "scenarios[0].manikin.seed", "a list", "a whole number"},
      {"attempt_time_s: 30", "attempt_time_s: -3", 22, "scenarios[0].pass.attempt_time_s", "'-3'", "from 1 to 600"},
      {"attempt_time_s: 30", "attempt_time_s: 90", 22, "scenarios[0].pass.attempt_time_s", "'90'",
       "max_attempt_s = 60"},
      {"tongue_force_n: 5", "tongue_force_n: 7", 16, "scenarios[0].targets.tongue_force_n", "'7'",
       "pass.peak_tongue_force_n = 6.5"},
      {"      gum_force_n: 2", "      gum_force_n: 4", 17, "scenarios[0].targets.gum_force_n", "'4'",
       "pass.peak_gum_force_n = 3"},
      {"sight_percent: 25", "sight_percent: 60", 13, "scenarios[0].sight_percent", "'60'",
       "glottis_visible_percent = 50"},
      {"max_attempt_s: 60", "max_attempt_s: 60\n    max_attempt_s: 50", 15, "scenarios[0].max_attempt_s", "'50'",
       "once"},
      {"title: First", "title: First\n    blade: macintosh", 10, "scenarios[0].blade", "'macintosh'",
       "miller-00, miller-0, miller-1, miller-2, miller-3"},
      {"weight_kg: 1.5", "weight_kg: 3.0", 8, "scenarios[0].blade", "missing", "blades_by_weight above 3 kg"},
      {"below_kg: 3.0", "below_kg: 0.9", 6, "blades_by_weight[1].below_kg", "'0.9'", "more than the row before, 1 kg"},
      {"id: first", "id: First One", 8, "scenarios[0].id", "'First One'", "lower-case"},
      {"title: A course", "title: \"\"", 3, "title", "''", "1 to 120 characters"},
      {"schema: 1", "schema: 3", 1, "schema", "'3'", "1 or 2"},
      {"schema: 1\n", "", 1, "schema", "missing", "1"},
      {"briefing: Do it.", "briefing: { do: it }", 10, "scenarios[0].briefing", "a group of fields",
       "text of 1 to 4000"},
      {"    manikin: { weight_kg: 1.5, seed: 4 }", "    manikin: 3", 12, "scenarios[0].manikin", "'3'",
       "seed, weight_kg"},
  };
  for (const auto& c : cases) {
    const std::string message = error(with_other(kGood, c.from, c.to));
    EXPECT_NE(message.find((folder_ / "course.yaml").string() + ":" + std::to_string(c.line) + ":"), std::string::npos)
        << c.to << " -> " << message;
    for (const char* part : {c.field, c.value, c.allowed}) {
      EXPECT_NE(message.find(part), std::string::npos) << c.to << " lacks '" << part << "' -> " << message;
    }
  }
}

TEST_F(CurriculumFile, EveryRequiredFieldIsMissedByName) {
  for (const char* field : {"id: test-course", "title: A course", "    title: First", "briefing: Do it.",
                            "debriefing: Done.", "manikin: { weight_kg: 1.5, seed: 4 }", "weight_kg: 1.5, ",
                            ", seed: 4", "max_attempt_s: 60", "tongue_force_n: 5", "      gum_force_n: 2",
                            "peak_tongue_force_n: 6.5", "peak_gum_force_n: 3", "glottis_visible_percent: 50",
                            "attempt_time_s: 30", "time_over_target_s: 3", "time_over_device_limit_s: 0.2"}) {
    const std::string text(field);
    const auto start = text.find_first_not_of(" ,"), end = text.find(':');
    const std::string message = error(with_other(kGood, text, ""));
    EXPECT_NE(message.find(text.substr(start, end - start) + " is missing"), std::string::npos)
        << field << " -> " << message;
  }
}

TEST_F(CurriculumFile, TwoScenariosMayNotShareAnId) {
  std::string twice = kGood;
  twice += twice.substr(twice.find("  - id: first"));
  const std::string message = error(twice);
  EXPECT_NE(message.find(":25: scenarios[1].id is 'first'"), std::string::npos) << message;
}

TEST_F(CurriculumFile, BrokenYamlIsRefusedWithItsLine) {
  for (const char* broken : {"schema: 1\nid: [unclosed\n", "schema: 1\n id: x\n", "schema: 1\nid: \"open\n",
                             "a: b: c\n", "\t- x\n", "{", "%YAML 9.9\n", "!!binary |\n"}) {
    const std::string message = error(broken);
    EXPECT_NE(message.find("course.yaml:"), std::string::npos) << broken;
  }
  EXPECT_NE(error("schema: 1\nid: [unclosed\n").find("broken YAML"), std::string::npos);
  EXPECT_NE(error("").find("empty"), std::string::npos);
  EXPECT_NE(error("# only a comment\n").find("course.yaml"), std::string::npos);
  EXPECT_NE(error("just words").find("allowed"), std::string::npos);
  EXPECT_NE(error(std::string(kGood) + "---\n" + kGood).find("more than one document"), std::string::npos);
}

TEST_F(CurriculumFile, HostileYamlIsRefusedQuickly) {
  std::string bomb = "a: &a [x,x,x,x,x,x,x,x,x]\n";
  for (char c = 'b'; c <= 'z'; ++c) {
    bomb += std::string(1, c) + ": &" + c + " [";
    for (int i = 0; i < 9; ++i) bomb += std::string(i > 0 ? "," : "") + "*" + static_cast<char>(c - 1);
    bomb += "]\n";
  }
  EXPECT_NE(error(bomb).find("anchor"), std::string::npos);
  EXPECT_NE(error("a: *b\n").find("course.yaml:"), std::string::npos);
  EXPECT_NE(error(std::string(500000, '[')).find("deep"), std::string::npos);
  std::string nested;
  for (int i = 0; i < 200; ++i) nested += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_NE(error(nested).find("deep"), std::string::npos);
  EXPECT_NE(error(std::string(kGood) + "#" + std::string(1 << 20, 'x')).find("larger than 1 MB"), std::string::npos);
  EXPECT_NE(error(with_other(kGood, "Do it.", "\"\xff\xfe\"")).find("UTF-8"), std::string::npos);
  EXPECT_NE(error(with_other(kGood, "Do it.", std::string("a\0b", 3))).find("UTF-8"), std::string::npos);
}

TEST_F(CurriculumFile, WhatCannotBeReadIsNamed) {
  const auto of = [](const fs::path& path) { return error_of<CurriculumError>([&] { load_curriculum(path); }); };
  EXPECT_NE(of(folder_ / "none.yaml").find("none.yaml"), std::string::npos);
  EXPECT_NE(of(folder_).find("folder"), std::string::npos);
}

TEST(Scenario, NeedsABladeWhereNoTableIs) {
  const std::string text =
      "id: a\ntitle: b\nbriefing: c\ndebriefing: d\nmanikin: {weight_kg: 3, seed: 1}\nsight_percent: 25\n"
      "max_attempt_s: 60\ntargets: {tongue_force_n: 5, gum_force_n: 2}\npass: {peak_tongue_force_n: 6, "
      "peak_gum_force_n: 3, glottis_visible_percent: 50, attempt_time_s: 30, time_over_target_s: 3, "
      "time_over_device_limit_s: 0}\n";
  const std::string message = error_of<CurriculumError>([&] { parse_scenario(text, "trial x"); });
  EXPECT_NE(message.find("trial x:1: blade is missing"), std::string::npos) << message;
  EXPECT_EQ(parse_scenario("blade: miller-1\n" + text, "trial x").blade, "miller-1");
  const std::string no_tube = "blade: miller-1\n" + text + "intubation:\n  course: term\n  gestation_weeks: 39\n";
  EXPECT_NE(error_of<CurriculumError>([&] {
              parse_scenario(no_tube, "trial x");
            }).find("trial x:12: intubation.tube is missing; allowed: one of 2.5, 3.0, 3.5, 4.0"),
            std::string::npos)
      << error_of<CurriculumError>([&] { parse_scenario(no_tube, "trial x"); });
}

}  // namespace
}  // namespace vallecula::curricula
