// A trial, its replay and its score as a person would run them, on a small patient of blocks.
#include <gtest/gtest.h>
#include <signal.h>

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "curricula/records/records.h"
#include "curricula/trial_log.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

class TrialCommands : public ::testing::Test {
 protected:
  std::vector<std::string> trial_arguments(const std::string& out, bool realtime = false) {
    std::vector<std::string> arguments = {"trial",
                                          "--patient",
                                          patient_.string(),
                                          "--scenario",
                                          curriculum_.string() + ":plain",
                                          "--device",
                                          "scripted:" + press_.string(),
                                          "--headless",
                                          "--out",
                                          (box_ / out).string()};
    if (!realtime) arguments.push_back("--asap");
    return arguments;
  }

  Sandbox box_;
  fs::path patient_ = write_block_patient(box_.folder());
  fs::path press_ = write_press(box_.folder());
  fs::path curriculum_ = write_curriculum(box_.folder());
};

class TrialCommandsRealTime : public TrialCommands {};

double length_of(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

TEST_F(TrialCommands, AScenarioIsFoundInTheOnlyShippedCourseThatHasIt) {
  const auto with = [&](const std::string& scenario, const std::string& out) {
    return box_.run({"trial", "--patient", patient_.string(), "--scenario", scenario, "--device",
                     "scripted:" + press_.string(), "--headless", "--asap", "--out", (box_ / out).string()});
  };
  const Outcome found = with("light-hand", "found");  // of neonatal-intubation alone
  ASSERT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(curricula::parse_scenario(curricula::read_trial_log(box_ / "found").header.scenario_yaml, "log").id,
            "light-hand");
  const Outcome several = with("delivery-room", "several");
  EXPECT_EQ(several.exit_code, 2);
  for (const char* file : {"first-intubation.yaml", "neonatal-intubation.yaml", "--curriculum"})
    EXPECT_NE(several.err.find(file), std::string::npos) << several.err;
  EXPECT_EQ(with("preterm", "default").exit_code, 0) << "the default course's comes first";
  const Outcome none = with("no-such", "none");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_NE(none.err.find("has no scenario 'no-such'"), std::string::npos) << none.err;
}

TEST_F(TrialCommands, ATrialLeavesItsResultsAndVerifiesAndScores) {
  const Outcome trial = box_.run(trial_arguments("out"));
  ASSERT_EQ(trial.exit_code, 0) << trial.err;
  EXPECT_EQ(box_.names("out"), (std::vector<std::string>{"force.png", "report.html", "score.json", "trial.vtrial"}));

  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  EXPECT_TRUE(log.footer.complete);
  EXPECT_EQ(log.footer.ended, "finished");
  EXPECT_EQ(log.header.device_kind, "scripted");
  EXPECT_FALSE(log.header.realtime);
  EXPECT_DOUBLE_EQ(log.header.landmarks_m.at("vallecula")[1], 0.012);
  EXPECT_DOUBLE_EQ(log.header.landmarks_m.at("glottis_normal")[2], 0.8);
  // The script lasts 1.2 s; the trial ends with it, give or take one look of the recorder.
  ASSERT_GE(log.ticks.size(), 1200u);
  ASSERT_LE(log.ticks.size(), 1220u);
  double peak_n = 0.0, last_n = 0.0;
  for (const curricula::LogTick& tick : log.ticks) {
    last_n = length_of(tick.loads[curricula::kTongue].force_n);
    ASSERT_TRUE(std::isfinite(last_n)) << "tick " << tick.tick;
    peak_n = std::max(peak_n, last_n);
  }
  EXPECT_GT(peak_n, 0.1) << "the blade was pressed 2.5 mm into the tongue";
  EXPECT_LT(peak_n, 7.9);
  EXPECT_EQ(last_n, 0.0) << "the blade ended 6 mm above the tongue";

  const Outcome verified = box_.run({"replay", (box_ / "out").string(), "--verify"});
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_EQ(verified.err, "") << "same build, same kernels: nothing to remark";
  EXPECT_NE(verified.out.find(std::to_string(log.ticks.size()) + " ticks are bit-identical"), std::string::npos);

  const Outcome scored = box_.run({"score", (box_ / "out" / "trial.vtrial").string(), "--json"});
  EXPECT_EQ(scored.exit_code, 0) << scored.err;
  EXPECT_EQ(scored.out, text_of(box_ / "out" / "score.json"));

  const Outcome told = box_.run({"replay", (box_ / "out").string()});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_NE(told.out.find("scenario plain on block"), std::string::npos) << told.out;

  int count = 0;
  QCoreApplication application(count, nullptr);
  const auto rows = curricula::Records(box_.home() / "records.sqlite").newest(5);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].scenario_id, "plain");
  EXPECT_EQ(rows[0].curriculum_id, "test-course");
  EXPECT_NEAR(rows[0].score.peak_tongue_force_n, peak_n, 1e-12);
}

TEST_F(TrialCommandsRealTime, ARealTimeTrialVerifiesToo) {
  const auto begin = std::chrono::steady_clock::now();
  const Outcome trial = box_.run(trial_arguments("out", true));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_EQ(trial.exit_code, 0) << trial.err;
  EXPECT_GE(seconds, 1.2) << "the script lasts 1.2 s in real time";
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  EXPECT_TRUE(log.header.realtime);
  EXPECT_GE(log.ticks.size(), 1200u);
  // 1 kHz, within what a shared machine may lose in one second.
  EXPECT_NEAR(log.footer.loop_rate_hz, 1000.0, 50.0);
  const Outcome verified = box_.run({"replay", (box_ / "out").string(), "--verify"});
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
}

TEST_F(TrialCommands, PredictionAndEnergyAreMeasuredOnATrial) {
  ASSERT_EQ(box_.run(trial_arguments("out")).exit_code, 0);
  const fs::path file = box_ / "prediction.json";
  const Outcome outcome = box_.run({"replay", (box_ / "out").string(), "--prediction", "--json", file.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("energy: the hand put in"), std::string::npos) << outcome.out;
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text_of(file))).object();
  EXPECT_GT(json["peak_force_n"].toDouble(), 0.1);
  const QJsonObject kinds = json["prediction"].toObject();
  for (const char* withheld : {"1", "2", "3", "5", "10"}) {
    const double used = kinds["contact"].toObject()[withheld].toObject()["rms_n"].toDouble();
    EXPECT_GT(used, 0.0) << withheld;
    EXPECT_LT(used, kinds["hold"].toObject()[withheld].toObject()["rms_n"].toDouble()) << withheld;
    EXPECT_LT(used, kinds["spring"].toObject()[withheld].toObject()["rms_n"].toDouble()) << withheld;
  }
  const QJsonObject energy = json["energy"].toObject();
  EXPECT_GT(energy["pushed_in_j"].toDouble(), 1e-5);
  EXPECT_GE(energy["lowest_j"].toDouble(), -1e-9);
  // What was asked together makes no sense: usage.
  EXPECT_EQ(box_.run({"replay", (box_ / "out").string(), "--json", file.string()}).exit_code, 2);
  EXPECT_EQ(box_.run({"replay", (box_ / "out").string(), "--prediction", "--verify"}).exit_code, 2);
}

/// The patient of blocks measures 55.2 mm from gum to vallecula; the infant of 1.2 kg 50.3 mm x 0.72.
TEST_F(TrialCommands, APatientOfAnotherSizeThanTheScenariosIsRemarkedBeforeTheTrial) {
  EXPECT_EQ(box_.run(trial_arguments("fits")).err.find("times as large"), std::string::npos) << "10 % fit";
  std::string text = text_of(curriculum_);
  text.replace(text.find("weight_kg: 3.2"), 14, "weight_kg: 1.2");
  write_text(curriculum_, text);
  const Outcome outcome = box_.run(trial_arguments("out"));
  EXPECT_EQ(outcome.exit_code, 0) << "a remark, not a refusal";
  const auto at = outcome.err.find("1.5 times as large as the scenario's infant");
  ASSERT_NE(at, std::string::npos) << outcome.err;
  EXPECT_LT(at, outcome.err.find("begins"));
  EXPECT_EQ(outcome.err.find("could not bring the glottis"), std::string::npos) << "its report says nothing of it";
}

TEST_F(TrialCommands, TwoTrialsAtFullSpeedAreTheSameToTheBit) {
  ASSERT_EQ(box_.run(trial_arguments("one")).exit_code, 0);
  ASSERT_EQ(box_.run(trial_arguments("two")).exit_code, 0);
  EXPECT_EQ(text_of(box_ / "one" / "score.json"), text_of(box_ / "two" / "score.json"));
  EXPECT_TRUE(text_of(box_ / "one" / "trial.vtrial") == text_of(box_ / "two" / "trial.vtrial"));
}

TEST_F(TrialCommands, OneChangedQuantityFailsVerification) {
  ASSERT_EQ(box_.run(trial_arguments("out")).exit_code, 0);
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  const auto rewritten = [&](const std::string& folder, auto change) {
    fs::create_directory(box_ / folder);
    curricula::TrialLogWriter writer(box_ / folder / "trial.vtrial", log.header);
    for (std::size_t i = 0; i < log.ticks.size(); ++i) {
      curricula::LogTick tick = log.ticks[i];
      if (i == 700) change(tick);
      writer.append(tick);
    }
    writer.close(log.footer);
    return box_.run({"replay", (box_ / folder).string(), "--verify"});
  };
  const auto next = [](double& value) { value = std::nextafter(value, 1e9); };

  EXPECT_EQ(rewritten("same", [](curricula::LogTick&) {}).exit_code, 0);
  struct Case {
    std::string field;
    std::function<void(curricula::LogTick&)> change;
  };
  const std::vector<Case> cases = {
      {"proxy_pose.position_m[1]", [&](curricula::LogTick& t) { next(t.proxy_pose.position_m[1]); }},
      {"displayed_force_n[2]", [&](curricula::LogTick& t) { next(t.displayed_force_n[2]); }},
      {"loads.tongue.force_n[0]", [&](curricula::LogTick& t) { next(t.loads[curricula::kTongue].force_n[0]); }},
      {"loads.tongue.contacts", [&](curricula::LogTick& t) { ++t.loads[curricula::kTongue].contacts; }},
      {"state", [&](curricula::LogTick& t) { t.state = curricula::LoggedState::lost; }},
  };
  for (const Case& one : cases) {
    const Outcome outcome = rewritten("changed-" + one.field, one.change);
    EXPECT_EQ(outcome.exit_code, 1) << one.field;
    ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("tick 700 (0.700 s) in " + one.field + ":"), std::string::npos) << outcome.err;
  }
  // An input that was changed shows in what follows from it.
  const Outcome moved = rewritten("moved", [](curricula::LogTick& t) { t.device_pose.position_m[2] -= 1e-4; });
  EXPECT_EQ(moved.exit_code, 1);
  EXPECT_NE(moved.err.find("differs first at tick 70"), std::string::npos) << moved.err;
}

TEST_F(TrialCommands, AChangedByteOrACutOffLogIsNotTakenForTheTrial) {
  ASSERT_EQ(box_.run(trial_arguments("out")).exit_code, 0);
  const std::string whole = text_of(box_ / "out" / "trial.vtrial");
  const auto expect_refused = [&](const std::string& name, const std::string& bytes) {
    fs::create_directory(box_ / name);
    write_text(box_ / name / "trial.vtrial", bytes);
    for (const auto& arguments : {std::vector<std::string>{"replay", (box_ / name).string(), "--verify"},
                                  std::vector<std::string>{"score", (box_ / name).string()}}) {
      const Outcome outcome = box_.run(arguments);
      EXPECT_EQ(outcome.exit_code, 1) << name << ": " << arguments[0] << "\n" << outcome.out << outcome.err;
      EXPECT_EQ(outcome.messages().size(), 1u) << outcome.err;
      EXPECT_NE(outcome.err.find(name), std::string::npos) << "the message names the file: " << outcome.err;
    }
    EXPECT_EQ(box_.names(name), std::vector<std::string>{"trial.vtrial"});
  };
  for (const double at : {0.001, 0.3, 0.6, 0.999}) {
    std::string changed = whole;
    changed[static_cast<std::size_t>(at * static_cast<double>(whole.size()))] ^= 0x10;
    expect_refused("changed-" + std::to_string(at), changed);
  }
  expect_refused("half", whole.substr(0, whole.size() / 2));
  expect_refused("empty", "");
  expect_refused("foreign", "this is no trial log");
}

TEST_F(TrialCommands, ReplayAndTrialRefuseAPackageWithAChangedByte) {
  ASSERT_EQ(box_.run(trial_arguments("out")).exit_code, 0);
  for (const std::string file : {"tongue.vtu", "face.vtp", "labels.nrrd", "patient.yaml"}) {
    const fs::path path = patient_ / file;
    const std::string whole = text_of(path);
    std::string changed = whole;
    changed[changed.size() / 2] ^= 0x01;
    write_text(path, changed);
    for (const auto& arguments :
         {trial_arguments("never"), std::vector<std::string>{"replay", (box_ / "out").string(), "--verify"}}) {
      const Outcome outcome = box_.run(arguments);
      EXPECT_EQ(outcome.exit_code, 1) << file;
      ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
      EXPECT_NE(outcome.err.find(file), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(fs::exists(box_ / "never"));
    write_text(path, whole);
  }
  EXPECT_EQ(box_.run({"replay", (box_ / "out").string(), "--verify"}).exit_code, 0) << "whole again";
}

TEST_F(TrialCommands, AMovedPackageIsFoundByTheOption) {
  ASSERT_EQ(box_.run(trial_arguments("out")).exit_code, 0);
  fs::rename(patient_, box_ / "elsewhere.patient");
  const Outcome lost = box_.run({"replay", (box_ / "out").string(), "--verify"});
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_NE(lost.err.find("--patient"), std::string::npos) << lost.err;
  const Outcome found =
      box_.run({"replay", (box_ / "out").string(), "--verify", "--patient", (box_ / "elsewhere.patient").string()});
  EXPECT_EQ(found.exit_code, 0) << found.err;
}

TEST_F(TrialCommands, ASecondTrialReplacesTheFirstAndNothingElse) {
  ASSERT_EQ(box_.run(trial_arguments("out")).exit_code, 0);
  write_text(box_ / "out" / "operator-1.png", "an older picture");
  write_text(box_ / "out" / "notes.txt", "mine");
  ASSERT_EQ(box_.run(trial_arguments("out")).exit_code, 0);
  EXPECT_EQ(box_.names("out"),
            (std::vector<std::string>{"force.png", "notes.txt", "report.html", "score.json", "trial.vtrial"}));
}

TEST_F(TrialCommands, AForeignFileIsNotOverwritten) {
  fs::create_directory(box_ / "theirs");
  write_text(box_ / "theirs" / "score.json", "somebody else's");
  const Outcome outcome = box_.run(trial_arguments("theirs"));
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("score.json"), std::string::npos);
  EXPECT_EQ(text_of(box_ / "theirs" / "score.json"), "somebody else's");
  EXPECT_EQ(box_.names("theirs"), std::vector<std::string>{"score.json"});
}

TEST_F(TrialCommands, WhereNothingCanBeWrittenTheTrialSaysSoAndLeavesNothing) {
  write_text(box_ / "file", "in the way");
  const Outcome out_below_a_file = box_.run(trial_arguments("file/out"));
  EXPECT_EQ(out_below_a_file.exit_code, 1);
  ASSERT_EQ(out_below_a_file.messages().size(), 1u) << out_below_a_file.err;
  EXPECT_NE(out_below_a_file.err.find("file/out"), std::string::npos) << out_below_a_file.err;

  const Outcome no_home = box_.run(trial_arguments("out"), {"VALLECULA_HOME=" + (box_ / "file").string() + "/home"});
  EXPECT_EQ(no_home.exit_code, 1);
  ASSERT_EQ(no_home.messages().size(), 1u) << no_home.err;
  EXPECT_NE(no_home.err.find("VALLECULA_HOME"), std::string::npos) << no_home.err;
  EXPECT_FALSE(fs::exists(box_ / "out"));
  EXPECT_EQ(text_of(box_ / "file"), "in the way");
}

TEST_F(TrialCommands, OnAFullDiskTheTrialSaysSoAndKeepsWhatWasWrittenWhole) {
  // The database of records (some 30 kB) still fits; the log (a megabyte) does not.
  const Outcome outcome = box_.run_on_full_disk(trial_arguments("out"), 200000);
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("trial.vtrial"), std::string::npos) << outcome.err;
  EXPECT_EQ(box_.names("out"), std::vector<std::string>{"trial.vtrial.part"});
  const std::string part = text_of(box_ / "out" / "trial.vtrial.part");
  EXPECT_GT(part.size(), 100000u);

  const Outcome next = box_.run(trial_arguments("next"));
  EXPECT_EQ(next.exit_code, 0) << next.err;
  EXPECT_NE(next.err.find("kept as interrupted"), std::string::npos) << next.err;
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  EXPECT_FALSE(log.footer.complete);
  EXPECT_GT(log.ticks.size(), 100u);
  const std::string kept = text_of(box_ / "out" / "trial.vtrial");
  std::size_t same = 0;
  while (same < std::min(kept.size(), part.size()) && kept[same] == part[same]) ++same;
  EXPECT_EQ(log.ticks.size() % 256, 0u) << "whole blocks";
  EXPECT_LT(part.size() - same, 256 * same / log.ticks.size()) << "less than a block is lost";
  const auto rows = curricula::Records(box_.home() / "records.sqlite").newest(5);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.score.complete; }), 1);
}

TEST_F(TrialCommands, ABadTrajectoryCurriculumOrScenarioIsNamed) {
  struct Case {
    std::string file, text, expected;
  };
  const std::string good_curriculum = text_of(curriculum_), good_press = text_of(press_);
  for (const Case& one : {Case{"press.csv", "t,x,y,z\n0,0,0,0\n1,0,zero,0\n", "press.csv"},
                          Case{"plain.yaml", "schema: 1\nid: [broken\n", "plain.yaml"},
                          Case{"plain.yaml", good_curriculum + "      surprise: 1\n", "surprise"},
                          Case{"plain.yaml", "schema: 1\nid: a\ntitle: b\nscenarios: []\n", "scenarios"}}) {
    write_text(box_ / one.file, one.text);
    const Outcome outcome = box_.run(trial_arguments("out"));
    EXPECT_EQ(outcome.exit_code, 1) << one.text;
    EXPECT_EQ(outcome.messages().size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(one.expected), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(box_ / "out"));
    write_text(curriculum_, good_curriculum);
    write_text(press_, good_press);
  }
  auto arguments = trial_arguments("out");
  arguments[4] = curriculum_.string() + ":unheard-of";
  const Outcome outcome = box_.run(arguments);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("it has plain"), std::string::npos) << outcome.err;
}

TEST_F(TrialCommandsRealTime, AnInterruptedTrialKeepsWhatWasRecordedAndSaysSo) {
  const pid_t process = box_.start(trial_arguments("out", true));
  const fs::path part = box_ / "out" / "trial.vtrial.part";
  for (int i = 0; i < 3000 && !fs::exists(part); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(fs::exists(part));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  ::kill(process, SIGINT);
  const Outcome outcome = box_.wait(process);
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos);
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  EXPECT_FALSE(log.footer.complete);
  EXPECT_GT(log.ticks.size(), 100u);
  EXPECT_LT(log.ticks.size(), 1200u);
  const Outcome score = box_.run({"score", (box_ / "out").string()});
  EXPECT_EQ(score.exit_code, 1);
  EXPECT_NE(score.err.find("--partial"), std::string::npos) << score.err;
  EXPECT_EQ(box_.run({"score", (box_ / "out").string(), "--partial"}).exit_code, 0);
}

}  // namespace
}  // namespace vallecula::gui::test
