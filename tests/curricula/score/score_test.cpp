#include "curricula/score/score.h"

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <functional>
#include <limits>

namespace vallecula::curricula {
namespace {

constexpr double kTick = 0.001;
constexpr std::array<double, 3> kOutside{0.0, -0.10, 0.10}, kInMouth{0.0, 0.02, -0.02};

Scenario scenario() {
  Scenario s;
  s.id = "term";
  s.title = "Term";
  s.sight_percent = 25;
  s.targets = {5.0, 2.0};
  s.pass = {6.8, 3.0, 50.0, 30.0, 3.0, 0.2};
  return s;
}

/// ANATOMY's term infant: upper gum at the origin.
std::map<std::string, std::array<double, 3>> landmarks() {
  return {{"upper_gum_midline", {0, 0, 0}},
          {"lower_gum_midline", {0, 0.0032, -0.0208}},
          {"vallecula", {0, 0.0285, -0.0415}}};
}

/// A log of `seconds`: blade outside, in the mouth from 2 s to 12 s, nothing touched, nothing seen. `change` edits each
/// tick.
TrialLog log_of(double seconds, const std::function<void(LogTick&)>& change = {}) {
  TrialLog log;
  log.header.landmarks_m = landmarks();
  log.header.device_kind = "scripted";
  log.header.software_version = "9.8.7";
  log.footer = {true, "finished", 999.5, 7, 2, "servo: real-time priority 80", {}};
  const int ticks = static_cast<int>(std::lround(seconds / kTick));
  for (int i = 0; i < ticks; ++i) {
    LogTick t;
    t.tick = t.step_fed = t.step_used = i;
    t.time_s = i * kTick;
    t.proxy_pose.position_m = i >= 2000 && i < 12000 ? kInMouth : kOutside;
    t.has_sight = i % 20 == 0;
    if (change) change(t);
    log.ticks.push_back(t);
  }
  return log;
}

/// What a good attempt looks like: half the glottis and more from 7 s to 8 s, 4 N on the tongue, 1 N on the gum.
void good(LogTick& t) {
  if (t.time_s > 6.9995 && t.time_s < 7.9995 && t.has_sight) t.glottis_visible = 0.82;
  if (t.time_s > 5.9995 && t.time_s < 7.9995) t.loads[kTongue].force_n = {0.0, -2.4, 3.2};
  if (t.tick == 6500) t.loads[kGum].force_n = {1.0, 0, 0};
}

bool any_contains(const std::vector<std::string>& texts, const std::string& part) {
  for (const std::string& t : texts) {
    if (t.find(part) != std::string::npos) return true;
  }
  return false;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& t : texts) all += t + "\n";
  return all;
}

TEST(Score, MeasuresAGoodAttempt) {
  const Score s = score_trial(log_of(14, good), scenario());
  EXPECT_TRUE(s.passed) << joined(s.reasons);
  EXPECT_TRUE(s.attempt_begun);
  EXPECT_TRUE(s.blade_out);
  EXPECT_EQ(s.mouth_entries, 1);
  EXPECT_NEAR(s.attempt_start_s, 2.0, 1e-12);
  EXPECT_NEAR(s.attempt_time_s, 10.0, 1e-9);
  EXPECT_NEAR(s.time_to_trachea_visible_s, 5.0, 1e-9);
  EXPECT_NEAR(s.glottis_visible_max_percent, 82.0, 1e-9);
  EXPECT_NEAR(s.time_of_glottis_max_s, 7.0, 1e-9);
  EXPECT_NEAR(s.peak_tongue_force_n, 4.0, 1e-12);
  EXPECT_NEAR(s.time_of_peak_tongue_force_s, 6.0, 1e-9);
  EXPECT_NEAR(s.peak_gum_force_n, 1.0, 1e-12);
  EXPECT_NEAR(s.time_of_peak_gum_force_s, 6.5, 1e-9);
  EXPECT_EQ(s.time_over_target_s, 0.0);
  EXPECT_EQ(s.time_over_force_limit_s, 0.0);
  EXPECT_EQ(s.ticks, 14000);
  EXPECT_EQ(s.loop_rate_hz, 999.5);
  EXPECT_EQ(s.deadline_misses, 7);
  EXPECT_EQ(s.overruns, 2);
  EXPECT_EQ(s.real_time_setup, "servo: real-time priority 80");
  EXPECT_TRUE(any_contains(s.reasons, "Glottis seen to 82 % at 7.00 s")) << joined(s.reasons);
}

TEST(Score, EachLimitFailsAloneForItsOwnReasonWithFigureLimitAndSecond) {
  const struct {
    const char* name;
    std::function<void(LogTick&)> change;
    double seconds;
    std::vector<std::string> says;
  } cases[] = {
      {"tongue",
       [](LogTick& t) {
         if (t.tick == 6700) t.loads[kTongue].force_n = {0, 7.25, 0};
       },
       14,
       {"on the tongue 7.25 N at 6.70 s", "6.8 N allowed"}},
      {"gum",
       [](LogTick& t) {
         if (t.tick == 4321) t.loads[kGum].force_n = {0, 0, -3.5};
       },
       14,
       {"on the gums 3.50 N at 4.32 s", "3 N allowed"}},
      {"sight",
       [](LogTick& t) { t.glottis_visible *= 0.49 / 0.82; },
       14,
       {"Glottis seen to 49 % at 7.00 s", "50 % asked for"}},
      {"never seen", [](LogTick& t) { t.glottis_visible = 0.0; }, 14, {"never in sight", "50 %"}},
      {"time",
       [](LogTick& t) {
         if (t.time_s >= 1.9995 && t.time_s < 32.9995) t.proxy_pose.position_m = kInMouth;
       },
       34,
       {"took 31.00 s (2.00 s to 33.00 s)", "30 s allowed"}},
      {"target",
       [](LogTick& t) {
         if (t.time_s > 3.9995 && t.time_s < 7.4995) t.loads[kTongue].force_n = {5.5, 0, 0};
       },
       14,
       {"target of 5 N for 3.50 s (first at 4.00 s)", "3 s allowed"}},
      {"device",
       [](LogTick& t) {
         if (t.tick >= 8000 && t.tick < 8500) t.state = LoggedState::limited;
       },
       14,
       {"limit of 7.9 N or lost", "for 0.50 s (longest from 8.00 s)", "0.2 s allowed"}},
      {"not a number",
       [](LogTick& t) {
         if (t.tick == 9000) t.loads[kPalate].force_n[1] = std::nan("");
       },
       14,
       {"not a number at 9.00 s"}},
  };
  for (const auto& c : cases) {
    const Score s = score_trial(log_of(c.seconds, [&](LogTick& t) { good(t), c.change(t); }), scenario());
    EXPECT_FALSE(s.passed) << c.name;
    EXPECT_EQ(s.reasons.size(), 1u) << c.name << "\n" << joined(s.reasons);
    for (const std::string& part : c.says)
      EXPECT_TRUE(any_contains(s.reasons, part)) << c.name << ": " << joined(s.reasons);
  }
}

TEST(Score, ExactlyAtTheLimitPasses) {
  const auto at_limit = [](LogTick& t) {
    good(t);
    if (t.has_sight) t.glottis_visible = std::min(t.glottis_visible, 0.5);
    if (t.tick == 6000) t.loads[kTongue].force_n = {6.8, 0, 0};
    if (t.tick == 6000) t.loads[kGum].force_n = {3.0, 0, 0};
    if (t.tick >= 6000 && t.tick < 6200) t.state = LoggedState::recovering;
    if (t.tick > 6000 && t.tick < 9000) t.loads[kTongue].force_n = {5.0000001, 0, 0};
  };
  const Score s = score_trial(log_of(14, at_limit), scenario());
  EXPECT_TRUE(s.passed) << joined(s.reasons);
  EXPECT_EQ(s.time_over_force_limit_s, 0.2);
  EXPECT_EQ(s.time_over_target_s, 3.0);
}

TEST(Score, AHairOverTheLimitDoesNotReadAsEqual) {
  const Score s = score_trial(log_of(14,
                                     [](LogTick& t) {
                                       good(t);
                                       if (t.tick == 6000) t.loads[kTongue].force_n = {6.8004, 0, 0};
                                     }),
                              scenario());
  EXPECT_FALSE(s.passed);
  EXPECT_TRUE(any_contains(s.reasons, "6.8004 N")) << joined(s.reasons);
}

TEST(Score, EveryHapticStateButTrackingCounts) {
  for (const LoggedState state : {LoggedState::limited, LoggedState::lost, LoggedState::recovering}) {
    const Score s = score_trial(log_of(14,
                                       [&](LogTick& t) {
                                         if (t.tick % 100 == 0) t.state = state;
                                       }),
                                scenario());
    EXPECT_NEAR(s.time_over_force_limit_s, 0.14, 1e-12);
  }
}

/// The same with a pause of 3 s before tick `at`, in which nothing is the hand's doing.
TrialLog paused_at(std::int64_t at, const TrialLog& whole) {
  TrialLog broken = whole;
  broken.ticks.clear();
  for (const LogTick& tick : whole.ticks) {
    LogTick t = tick;
    if (t.tick == at) {
      for (int i = 0; i < 3000; ++i) {
        LogTick pause = t;
        pause.tick = at + i;
        pause.time_s = pause.tick * kTick;
        pause.device_valid = false;
        pause.state = LoggedState::lost;
        pause.has_sight = i % 20 == 0;
        pause.glottis_visible = 0.99;
        pause.loads[kTongue].force_n = {9.0, 0, 0};
        broken.ticks.push_back(pause);
      }
    }
    if (t.tick >= at) {
      t.tick += 3000;
      t.time_s = t.tick * kTick;
      if (t.tick < at + 3400) t.state = LoggedState::recovering;
    }
    broken.ticks.push_back(t);
  }
  return broken;
}

// A device that is away takes nothing from the trainee and gives nothing: a good attempt with a pause of 3 s in its
// middle is scored as the same attempt without.
TEST(Score, APauseCountsForNothing) {
  const TrialLog whole = log_of(14, good);
  const Score a = score_trial(whole, scenario()), b = score_trial(paused_at(5000, whole), scenario());
  EXPECT_TRUE(a.passed) << joined(a.reasons);
  EXPECT_TRUE(b.passed) << joined(b.reasons);
  EXPECT_NEAR(a.attempt_time_s, b.attempt_time_s, 1e-9);
  EXPECT_NEAR(a.time_to_trachea_visible_s, b.time_to_trachea_visible_s, 1e-9);
  EXPECT_EQ(a.peak_tongue_force_n, b.peak_tongue_force_n);
  EXPECT_EQ(a.glottis_visible_max_percent, b.glottis_visible_max_percent);
  EXPECT_EQ(a.time_over_target_s, b.time_over_target_s);
  EXPECT_EQ(b.time_over_force_limit_s, 0.0) << "taking hold again after a pause is not the trainee's time";
  EXPECT_NEAR(b.paused_s, 3.0, 1e-9);
  EXPECT_EQ(a.paused_s, 0.0);
  EXPECT_TRUE(any_contains(b.reasons, "2.00 s to 15.00 s, paused for 3.00 s")) << joined(b.reasons);
  EXPECT_EQ(b.mouth_entries, 1) << "the blade stayed in the mouth meanwhile";
  EXPECT_TRUE(b.blade_out);
}

TEST(Score, PausesAreToldWithTheirFaults) {
  TrialLog log = paused_at(9000, paused_at(5000, log_of(14)));
  log.footer.pause_faults = {"unplugged"};  // the second is not known
  const Score score = score_trial(log, scenario());
  ASSERT_EQ(score.pauses.size(), 2u);
  const QJsonArray told = QJsonDocument::fromJson(QByteArray::fromStdString(score_to_json(score, log, scenario())))
                              .object()["pauses"]
                              .toArray();
  ASSERT_EQ(told.size(), 2);
  EXPECT_NEAR(told[0].toObject()["at_s"].toDouble(), 5.0, 1e-9);
  EXPECT_NEAR(told[0].toObject()["for_s"].toDouble(), 3.0, 1e-9);
  EXPECT_EQ(told[0].toObject()["fault"].toString(), "unplugged");
  EXPECT_NEAR(told[1].toObject()["at_s"].toDouble(), 9.0, 1e-9);
  EXPECT_TRUE(told[1].toObject()["fault"].isNull());
}

TEST(Score, APauseIsNoWayOutOfTheMouthAndHidesNone) {
  const auto out_for = [](int ticks) {
    return log_of(14, [ticks](LogTick& t) {
      if (t.tick >= 4000 && t.tick < 4000 + ticks) t.proxy_pose.position_m = kOutside;
    });
  };
  EXPECT_EQ(score_trial(paused_at(4500, out_for(900)), scenario()).mouth_entries, 1) << "0.9 s outside, less the pause";
  EXPECT_EQ(score_trial(paused_at(4500, out_for(1100)), scenario()).mouth_entries, 2);
  for (const std::int64_t at : {8000, 13000}) {  // in the mouth, and out of it again
    TrialLog never_back = paused_at(at, log_of(14));
    never_back.ticks.resize(static_cast<std::size_t>(at + 3000));
    EXPECT_EQ(score_trial(never_back, scenario()).blade_out, at == 13000);
  }
}

TEST(Score, TheReasonCitesTheLongestStayAtTheLimitNotTheFirstTouch) {
  const Score s = score_trial(log_of(14,
                                     [](LogTick& t) {
                                       good(t);
                                       if (t.tick == 3000) t.state = LoggedState::limited;
                                       if (t.tick >= 5000 && t.tick < 5200) t.state = LoggedState::limited;
                                       if (t.tick >= 5200 && t.tick < 5300) t.state = LoggedState::lost;
                                       if (t.tick >= 9000 && t.tick < 9100) t.state = LoggedState::limited;
                                     }),
                              scenario());
  EXPECT_NEAR(s.time_over_force_limit_s, 0.401, 1e-12);
  EXPECT_TRUE(any_contains(s.reasons, "or lost")) << joined(s.reasons);
  EXPECT_TRUE(any_contains(s.reasons, "(longest from 5.00 s)")) << joined(s.reasons);
  for (const Criterion& c : s.criteria) {
    if (c.name == "time_over_force_limit_s") {
      EXPECT_NEAR(c.at_s, 5.0, 1e-9);
    }
  }
}

TEST(Score, GumIsTheGumAloneAndEachStructureHasItsPeak) {
  const Score s = score_trial(log_of(14,
                                     [](LogTick& t) {
                                       for (int k = 0; k < kStructures; ++k) {
                                         if (t.tick == 5000 + k)
                                           t.loads[static_cast<std::size_t>(k)].force_n = {0, k + 1.0, 0};
                                       }
                                     }),
                              scenario());
  for (int k = 0; k < kStructures; ++k) {
    EXPECT_EQ(s.peak_force_n[static_cast<std::size_t>(k)], k + 1.0);
    EXPECT_NEAR(s.time_of_peak_s[static_cast<std::size_t>(k)], 5.0 + k * kTick, 1e-9);
  }
  EXPECT_EQ(s.peak_tongue_force_n, 1.0);
  EXPECT_EQ(s.peak_gum_force_n, 3.0);
}

TEST(Score, SightCountsFromTheAttemptsStartAndOnlyWhereItWasMeasured) {
  const Score before = score_trial(log_of(14,
                                          [](LogTick& t) {
                                            if (t.tick == 1000) t.glottis_visible = 0.9;
                                          }),
                                   scenario());
  EXPECT_LT(before.time_to_trachea_visible_s, 0.0);
  const Score unmeasured = score_trial(log_of(14,
                                              [](LogTick& t) {
                                                if (t.tick == 5001) t.glottis_visible = 0.9;
                                              }),
                                       scenario());
  EXPECT_EQ(unmeasured.glottis_visible_max_percent, 0.0);
  const Score below = score_trial(log_of(14, [](LogTick& t) { t.glottis_visible = 0.2499; }), scenario());
  EXPECT_LT(below.time_to_trachea_visible_s, 0.0);
  EXPECT_NEAR(below.glottis_visible_max_percent, 24.99, 1e-9);
}

TEST(Score, AnAttemptThatNeverBeganSaysSo) {
  const Score s = score_trial(log_of(14, [](LogTick& t) { good(t), t.proxy_pose.position_m = kOutside; }), scenario());
  EXPECT_FALSE(s.passed);
  EXPECT_FALSE(s.attempt_begun);
  EXPECT_EQ(s.attempt_time_s, 0.0);
  EXPECT_LT(s.time_to_trachea_visible_s, 0.0);
  EXPECT_TRUE(any_contains(s.reasons, "never began")) << joined(s.reasons);

  TrialLog log = log_of(14, good);
  log.header.landmarks_m.erase("vallecula");
  const Score without = score_trial(log, scenario());
  EXPECT_FALSE(without.passed);
  EXPECT_TRUE(any_contains(without.reasons, "landmarks")) << joined(without.reasons);
}

/// Names of the criteria that say whether a limit was kept.
std::vector<std::string> limits_of(const Score& s) {
  std::vector<std::string> limits;
  for (const Criterion& c : s.criteria)
    if (c.name.rfind("peak_", 0) == 0 || c.name.rfind("time_over_", 0) == 0)
      limits.push_back(c.name + (c.met ? " met" : " missed"));
  return limits;
}

TEST(Score, WhoDidNothingHasKeptNoLimit) {
  const auto outside = [](LogTick& t) { t.proxy_pose.position_m = kOutside; };
  const Score nothing = score_trial(log_of(14, outside), scenario());
  EXPECT_EQ(limits_of(nothing), std::vector<std::string>{});
  EXPECT_FALSE(nothing.passed);
  // What went over its limit is told wherever the tip was; what was touched lightly on the way tells of no attempt.
  const Score pressed = score_trial(log_of(14,
                                           [&](LogTick& t) {
                                             outside(t);
                                             if (t.tick == 5000) t.loads[kGum].force_n = {0, 0, 3.5};
                                             if (t.tick == 6000) t.loads[kTongue].force_n = {0, 0, 0.5};
                                           }),
                                    scenario());
  EXPECT_EQ(limits_of(pressed), std::vector<std::string>{"peak_gum_force_n missed"});
  EXPECT_TRUE(any_contains(pressed.reasons, "more than the 3 N allowed")) << joined(pressed.reasons);
  // An attempt with a light hand, or with none on the tissue, keeps them all.
  const std::vector<std::string> kept{"peak_tongue_force_n met", "peak_gum_force_n met", "time_over_target_s met",
                                      "time_over_force_limit_s met"};
  EXPECT_EQ(limits_of(score_trial(log_of(14), scenario())), kept);
  EXPECT_EQ(limits_of(score_trial(log_of(14,
                                         [](LogTick& t) {
                                           t.loads[kTongue].force_n = {0, 0, 0.1};
                                         }),
                                  scenario())),
            kept);
  // Where nobody knows the mouth a touch is the only sign of one.
  TrialLog unknown = log_of(14), touched = log_of(14, good);
  for (TrialLog* log : {&unknown, &touched}) log->header.landmarks_m.erase("vallecula");
  EXPECT_EQ(limits_of(score_trial(unknown, scenario())), std::vector<std::string>{});
  EXPECT_EQ(limits_of(score_trial(touched, scenario())), kept);
}

TEST(Score, BeforeTheFirstStepThereIsNoProxy) {
  const Score s = score_trial(log_of(14,
                                     [](LogTick& t) {
                                       good(t);
                                       if (t.tick < 5) t.step_used = -1, t.proxy_pose.position_m = kInMouth;
                                     }),
                              scenario());
  EXPECT_NEAR(s.attempt_start_s, 2.0, 1e-12);
}

TEST(Score, ShortWaysOutDoNotStopTheClock) {
  const auto with_gap = [](int from, int to) {
    return score_trial(log_of(14,
                              [=](LogTick& t) {
                                good(t);
                                if (t.tick >= from && t.tick < to) t.proxy_pose.position_m = kOutside;
                              }),
                       scenario());
  };
  EXPECT_EQ(with_gap(4000, 4900).mouth_entries, 1);
  EXPECT_EQ(with_gap(4000, 5500).mouth_entries, 2);
  EXPECT_NEAR(with_gap(4000, 5500).attempt_time_s, 10.0, 1e-9);
  const Score inside = score_trial(log_of(10, good), scenario());  // ends with the blade in the mouth
  EXPECT_FALSE(inside.blade_out);
  EXPECT_NEAR(inside.attempt_time_s, 8.0, 1e-9);
}

TEST(Score, AnInterruptedTrialIsNotPassed) {
  TrialLog log = log_of(14, good);
  log.footer = LogFooter{};
  log.footer.ended = "interrupted";
  const Score s = score_trial(log, scenario());
  EXPECT_FALSE(s.passed);
  ASSERT_EQ(s.reasons.size(), 1u);
  EXPECT_TRUE(any_contains(s.reasons, "interrupted")) << joined(s.reasons);
  EXPECT_NEAR(s.peak_tongue_force_n, 4.0, 1e-12);

  log.ticks.clear();
  const Score empty = score_trial(log, scenario());
  EXPECT_FALSE(empty.passed);
  EXPECT_EQ(empty.ticks, 0);
}

TEST(Score, IsAPureFunctionOfTheLog) {
  const TrialLog log = log_of(14, good);
  EXPECT_EQ(score_to_json(score_trial(log, scenario()), log, scenario()),
            score_to_json(score_trial(log, scenario()), log, scenario()));
}

TEST(ScoreJson, HasTheKeysThatOthersRead) {
  const TrialLog log = log_of(14, good);
  const QJsonObject o =
      QJsonDocument::fromJson(QByteArray::fromStdString(score_to_json(score_trial(log, scenario()), log, scenario())))
          .object();
  const std::map<std::string, double> numbers = {{"peak_tongue_force_n", 4.0},
                                                 {"time_to_trachea_visible_s", 5.0},
                                                 {"glottis_visible_max_percent", 82.0},
                                                 {"peak_gum_force_n", 1.0},
                                                 {"attempt_time_s", 10.0},
                                                 {"time_over_force_limit_s", 0.0},
                                                 {"time_over_target_s", 0.0},
                                                 {"loop_rate_hz", 999.5},
                                                 {"deadline_misses", 7.0},
                                                 {"overruns", 2.0},
                                                 {"ticks", 14000.0}};
  for (const auto& [name, value] : numbers) {
    ASSERT_TRUE(o.value(QString::fromStdString(name)).isDouble()) << name;
    EXPECT_NEAR(o.value(QString::fromStdString(name)).toDouble(), value, 1e-9) << name;
  }
  EXPECT_TRUE(o.value("passed").toBool());
  EXPECT_TRUE(o.value("reasons").isArray());
  EXPECT_EQ(o.value("scenario_id").toString(), "term");
  EXPECT_EQ(o.value("device_kind").toString(), "scripted");
  EXPECT_EQ(o.value("software_version").toString(), "9.8.7");
  EXPECT_EQ(o.value("real_time_setup").toString(), "servo: real-time priority 80");
  EXPECT_EQ(o.value("criteria").toArray().size(), 8);
  EXPECT_EQ(o.value("mode").toString(), "practice");
  EXPECT_EQ(o.value("attempt_seed").toInt(-1), 0);
  EXPECT_NEAR(o.value("points_of_100").toDouble(), 100.0, 1e-9) << "all of them, since it passed";
  const QJsonArray points = o.value("points").toArray();
  ASSERT_EQ(points.size(), 6) << "one for each limit of scenario.pass";
  for (const QJsonValue& mark : points) {
    EXPECT_NEAR(mark.toObject().value("of").toDouble(), 100.0 / 6.0, 1e-9);
    EXPECT_TRUE(mark.toObject().value("source").toString().endsWith("not validated"));
  }
}

TEST(ScoreJson, EveryPointSaysWhenAndWhyAndTheOtherFiguresHaveTheirGroups) {
  const TrialLog log = log_of(14, [](LogTick& t) {
    good(t);
    if (t.tick == 6700) t.loads[kTongue].force_n = {0, 0, -7.25};
  });
  const QJsonObject o =
      QJsonDocument::fromJson(QByteArray::fromStdString(score_to_json(score_trial(log, scenario()), log, scenario())))
          .object();
  const QJsonArray points = o.value("points").toArray();
  ASSERT_EQ(points.size(), 6);
  double of = 0.0;
  for (const QJsonValue& one : points) {
    of += one.toObject().value("of").toDouble();
    EXPECT_NE(one.toObject().value("sentence").toString(), "");
  }
  EXPECT_NEAR(of, 100.0, 1e-9);
  const QJsonObject tongue = points[2].toObject();
  EXPECT_EQ(tongue.value("mark").toString(), "peak_tongue_force_n");
  EXPECT_EQ(tongue.value("earned").toDouble(), 0.0);
  EXPECT_NEAR(tongue.value("at_s").toDouble(), 6.7, 1e-9);
  EXPECT_TRUE(tongue.value("sentence").toString().contains("7.25 N at 6.70 s"));
  const auto in = [&](const char* group, const char* name) { return o.value(group).toObject().value(name); };
  EXPECT_NEAR(in("force", "mean_tongue_force_n").toDouble(), (1999 * 4.0 + 7.25) / 2000, 1e-9);
  EXPECT_NEAR(in("view", "mean_glottis_visible_percent").toDouble(), 82.0, 1e-9);
  EXPECT_EQ(in("view", "cormack_lehane").toInt(), 1);
  EXPECT_TRUE(in("view", "time_to_stable_view_s").isNull()) << "a second of it is not stable";
  EXPECT_NEAR(in("blade", "entry_left_m").toDouble(), 0.0, 1e-12);
  EXPECT_TRUE(in("motion", "tip_path_m").isDouble());
  EXPECT_FALSE(o.value("motion").toObject().contains("tremor_m")) << "for researchers only";
  EXPECT_TRUE(in("for_researchers", "tremor_m").isDouble());
  EXPECT_FALSE(o.contains("dual_task"));
  EXPECT_GE(o.value("checklist").toArray().size(), 5);
  EXPECT_TRUE(in("global_rating", "given").isNull()) << "a person gives it";
}

TEST(ScoreJson, WhatDoesNotExistIsNullAndNothingIsNan) {
  TrialLog log = log_of(14, [](LogTick& t) { t.loads[kTongue].force_n[0] = std::numeric_limits<double>::infinity(); });
  log.footer = LogFooter{};
  const std::string json = score_to_json(score_trial(log, scenario()), log, scenario());
  const QJsonObject o = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
  ASSERT_FALSE(o.isEmpty());
  EXPECT_TRUE(o.value("time_to_trachea_visible_s").isNull());
  EXPECT_TRUE(o.value("loop_rate_hz").isNull());
  EXPECT_FALSE(o.value("passed").toBool());
  EXPECT_EQ(json.find("nan"), std::string::npos);
  EXPECT_EQ(json.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace vallecula::curricula
