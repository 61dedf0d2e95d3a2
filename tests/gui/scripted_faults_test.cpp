// Hands told apart by their scores: an expert, a novice and five typical faults on one infant of a coarse mesh. Each fault
// shows in its own figure beyond what expert and novice show; in the other faults' figures it stays where these two are.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "curricula/score/figures.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCurriculum = R"(schema: 1
id: hands
title: Hands
scenarios:
  - id: view
    title: View
    briefing: In.
    debriefing: Out.
    manikin: { weight_kg: 3.2, seed: 1 }
    blade: miller-1
    sight_percent: 25
    max_attempt_s: 60
    targets: { tongue_force_n: 5.0, gum_force_n: 2.0 }
    pass:
      peak_tongue_force_n: 6.8
      peak_gum_force_n: 3.0
      glottis_visible_percent: 50
      attempt_time_s: 30
      time_over_target_s: 3
      time_over_device_limit_s: 0.2
)";

struct Fault {
  const char* hand;
  const char* figure;  ///< its own
  double beyond;       ///< at least so many times the larger of expert's and novice's
};
constexpr Fault kFaults[] = {{"levers", "peak_gum_force_n", 1.3},
                             {"too-far", "past_vallecula_mm", 1.5},
                             {"off-midline", "blade_from_midline_mm", 3.0},
                             {"forceful", "tongue_force_integral_ns", 1.3},
                             {"many-tries", "mouth_entries", 2.0}};
/// A hand that does not commit a fault may show so much more of its figure than expert and novice do.
constexpr double kOthers = 1.1;

class ScriptedFaults : public ::testing::Test {
 protected:
  /// Figures by name of the trial that this hand does.
  static std::map<std::string, double> figures_of(const Sandbox& box, const fs::path& patient, const std::string& hand) {
    const std::string out = (box / hand).string();
    const Outcome trial =
        box.run({"trial", "--patient", patient.string(), "--scenario", (box / "hands.yaml").string() + ":view",
                 "--device", "scripted:" + hand, "--headless", "--asap", "--out", out});
    EXPECT_EQ(trial.exit_code, 0) << trial.err;
    const curricula::TrialLog log = curricula::read_trial_log(out);
    const curricula::Score score = score_trial(log, curricula::parse_scenario(log.header.scenario_yaml, hand));
    std::map<std::string, double> figures;
    for (const curricula::Figure& one : curricula::figures())
      if (const auto value = one.value(score)) figures[one.name] = *value;
    return figures;
  }
};

TEST_F(ScriptedFaults, EachIsToldByItsOwnFigure) {
  const Sandbox box;
  write_text(box / "hands.yaml", kCurriculum);
  ASSERT_EQ(box.run({"manikin", "--out", (box / "ct").string(), "--weight", "3.2", "--seed", "1"}).exit_code, 0);
  const fs::path patient = box / "infant.patient";
  const Outcome import = box.run({"import", (box / "ct").string(), "--out", patient.string(), "--tets", "1000"});
  ASSERT_EQ(import.exit_code, 0) << import.err;

  std::map<std::string, std::map<std::string, double>> hands;
  for (const char* hand : {"expert", "novice"}) hands[hand] = figures_of(box, patient, hand);
  for (const Fault& fault : kFaults) hands[fault.hand] = figures_of(box, patient, fault.hand);

  std::printf("%-24s", "");
  for (const auto& [hand, figures] : hands) std::printf("%13s", hand.c_str());
  for (const Fault& fault : kFaults) {
    std::printf("\n%-24s", fault.figure);
    for (const auto& [hand, figures] : hands) std::printf("%13.3f", figures.at(fault.figure));
  }
  std::printf("\n");

  EXPECT_GT(hands["expert"]["glottis_visible_max_percent"], 50.0);
  EXPECT_LT(hands["novice"]["glottis_visible_max_percent"], 25.0);
  EXPECT_GT(hands["expert"]["lift_share_percent"], 90.0);
  // The novice levers as well, and with as much of the load: the fault presses harder, and nothing else is wrong with it.
  for (const char* hand : {"novice", "levers"}) EXPECT_LT(hands[hand]["lift_share_percent"], 60.0) << hand;
  for (const Fault& fault : kFaults) {
    const double usual = std::max(hands["expert"].at(fault.figure), hands["novice"].at(fault.figure));
    EXPECT_GE(hands[fault.hand].at(fault.figure), fault.beyond * usual) << fault.hand << " shows in " << fault.figure;
    for (const Fault& other : kFaults) {
      if (other.hand == fault.hand) continue;
      EXPECT_LE(hands[other.hand].at(fault.figure), kOthers * usual) << other.hand << " shows in " << fault.figure;
    }
  }
}

}  // namespace
}  // namespace vallecula::gui::test
