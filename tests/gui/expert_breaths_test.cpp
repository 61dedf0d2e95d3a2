// Breaths by mask before the laryngoscopy: where a shipped briefing asks for them the scripted expert gives them and
// they suffice; where it does not, the infant begins with what it needs, and keeps it if it breathes by itself. Judged
// by the infant of the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/physiology/infant.h"
#include "engine/tube/intubation_record.h"
#include "gui/session/intubation_of.h"
#include "gui/session/scripted_pairs.h"
#include "gui/session/user_paths.h"
#include "tests/gui/coarse_infant.h"

namespace vallecula::gui::test {
namespace {

constexpr double kTick = 0.001, kBreathEvery = 1.5;  // s; 40 a minute while held

bool asks_for_breaths(const std::string& briefing) {
  const auto has = [&](const char* words) { return briefing.find(words) != std::string::npos; };
  return has("breaths by mask until") || (has("breaths by mask first") && !has("no breaths by mask first"));
}

/// Seconds of breaths by mask before the blade first moves.
double breaths_before_blade_s(const ScriptedPair& pair) {
  double for_s = 0.0, since_s = -1.0;
  const auto& keys = pair.blade.keyframes();
  const auto moved = std::find_if(keys.begin(), keys.end(),
                                  [&](const device::Keyframe& k) { return k.position_m != keys.front().position_m; });
  const double blade_s = moved == keys.begin() || moved == keys.end() ? 0.0 : std::prev(moved)->time_s;
  for (const device::TimedActions& change : pair.actions.changes()) {
    if (since_s >= 0.0) for_s += std::min(change.time_s, blade_s) - since_s;
    since_s = (change.bits & engine::kActionBreath) != 0 && change.time_s < blade_s ? change.time_s : -1.0;
  }
  return for_s;
}

struct Course {
  engine::InfantSigns begin, ready;
  double lowest_spo2 = 1.0;
};

/// Ventilated by mask for so long, then none for as long as an attempt may last.
Course lived(const engine::IntubationDescription& d, double ventilated_s, double attempt_s) {
  const engine::Infant infant = engine::build_infant(d.infant);
  engine::InfantState state = engine::start(infant);
  Course course;
  const auto live = [&](double for_s, bool breaths) {
    engine::InfantSigns now;
    for (long tick = 0; tick < std::lround(for_s / kTick); ++tick) {
      engine::InfantInput in;
      in.breathing = d.breathes;
      in.glottis_opening = 0.5;
      if (breaths && tick % std::lround(kBreathEvery / kTick) == 0) in.breath = engine::Breath::mask;
      now = engine::step(infant, state, in, kTick);
      course.lowest_spo2 = std::min(course.lowest_spo2, now.spo2);
    }
    return now;
  };
  course.begin = course.ready = live(kTick, false);
  if (ventilated_s > 0.0) course.ready = live(ventilated_s, true);
  live(attempt_s, false);
  return course;
}

TEST(ExpertBreaths, AreGivenWhereTheBriefingAsksAndNoInfantIsLookedAtThatNeedsThem) {
  const pipeline::PatientPackage package = pipeline::read_package(coarse_infant());
  int asking = 0, others = 0;
  for (const auto& file : std::filesystem::directory_iterator(curricula_folder())) {
    const curricula::Curriculum course = curricula::load_curriculum(file.path());
    for (const curricula::Scenario& one : course.scenarios) {
      if (!one.intubation) continue;
      const engine::IntubationDescription d = intubation_of(package, one);
      const double given_s = breaths_before_blade_s(scripted_pair("expert", package, one, d));
      const Course infant = lived(d, given_s, one.pass.attempt_time_s);
      const std::string name = course.id + ": " + one.id;
      const bool asks = asks_for_breaths(one.briefing.in("en"));
      EXPECT_EQ(given_s > 0.0, asks) << name;
      (asks ? asking : others)++;
      if (asks) {
        EXPECT_LT(infant.begin.heart_per_min, 100.0) << name;
        EXPECT_GT(infant.ready.heart_per_min, 100.0) << name << " after " << given_s << " s";
        EXPECT_LT(given_s, 60.0) << name << ": where the expert would go on whatever the heart";
      } else {
        EXPECT_GE(infant.begin.spo2, 0.9) << name;
        EXPECT_GE(infant.begin.heart_per_min, 100.0) << name;
        if (d.breathes) {  // by itself: what it has it keeps, so breaths first would bring it nothing
          EXPECT_GE(infant.lowest_spo2, 0.95) << name;
        }
      }
    }
  }
  EXPECT_EQ(asking, 2) << "the delivery rooms";
  EXPECT_GE(others, 10);
}

}  // namespace
}  // namespace vallecula::gui::test
