// Hands told apart by their scores: an expert, a novice and five typical faults on one infant of a coarse mesh. Each
// fault shows in its own figure beyond what expert and novice show; in the other faults' figures it stays where these
// two are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "curricula/score/figures.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/coarse_infant.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

const std::string kCurriculum = R"(schema: 1
id: hands
title: Hands
scenarios:
  - id: view
    title: View
    briefing: In.
    debriefing: Out.
)" + usual_demands(60);

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

using Figures = std::map<std::string, double>;

Figures figures_of(const fs::path& trial) {
  const curricula::TrialLog log = curricula::read_trial_log(trial);
  const curricula::Score score = score_trial(log, curricula::parse_scenario(log.header.scenario_yaml, trial.string()));
  Figures figures;
  for (const curricula::Figure& one : curricula::figures())
    if (const auto value = one.value(score)) figures[one.name] = *value;
  return figures;
}

/// What each hand's trial scored, by its name. Two trials at a time: they are most of this test's half a minute.
std::map<std::string, Figures> play(const Sandbox& box, const fs::path& patient) {
  std::vector<std::string> names = {"expert", "novice"};
  for (const Fault& fault : kFaults) names.emplace_back(fault.hand);
  const std::array<Sandbox, 2> at_once;
  std::map<std::string, Figures> hands;
  for (std::size_t n = 0; n < names.size(); n += at_once.size()) {
    std::array<pid_t, 2> trials{};
    const std::size_t count = std::min(at_once.size(), names.size() - n);
    for (std::size_t k = 0; k < count; ++k)
      trials[k] = at_once[k].start({"trial", "--patient", patient.string(), "--scenario",
                                    (box / "hands.yaml").string() + ":view", "--device", "scripted:" + names[n + k],
                                    "--headless", "--asap", "--out", (box / names[n + k]).string()});
    for (std::size_t k = 0; k < count; ++k) {
      const Outcome trial = at_once[k].wait(trials[k]);
      EXPECT_EQ(trial.exit_code, 0) << names[n + k] << ": " << trial.err;
      if (trial.exit_code == 0) hands[names[n + k]] = figures_of(box / names[n + k]);
    }
  }
  return hands;
}

TEST(ScriptedFaults, EachIsToldByItsOwnFigure) {
  const Sandbox box;
  write_text(box / "hands.yaml", kCurriculum);
  std::map<std::string, Figures> hands = play(box, coarse_infant());
  ASSERT_EQ(hands.size(), 2 + std::size(kFaults));

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
  // The novice levers as well, and with as much of the load: the fault presses harder, and nothing else is wrong with
  // it.
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
