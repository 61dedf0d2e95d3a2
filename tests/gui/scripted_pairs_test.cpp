// Every outcome of an intubation, by a scripted pair of hands on the built-in infant.
#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <map>

#include "curricula/trial_log.h"
#include "gui/session/builtin_patient.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

class ScriptedPairs : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    box_ = new Sandbox;
    patient_ = new fs::path(builtin_patient({3.2, 1}));
    write_text(*box_ / "tubes.yaml", curriculum());
  }
  static void TearDownTestSuite() {
    delete patient_;
    delete box_;
  }
  /// One scenario for each way it can end that is not the hands' alone.
  static std::string curriculum() {
    std::string text = "schema: 1\nid: tubes\ntitle: Tubes\nscenarios:\n";
    for (const auto& [id, more] : std::map<std::string, std::string>{
             {"usual", "tube: \"3.5\"\n      stylet: true"},
             {"large", "tube: \"4.0\"\n      stylet: true"},
             {"spasm",
              "tube: \"3.5\"\n      stylet: true\n      laryngospasm_s: 60\n      laryngospasm_from_start: true"}})
      text += "  - id: " + id + R"(
    title: Tube
    briefing: In.
    debriefing: Out.
)" + usual_demands() +
              R"(    intubation:
      course: term
      gestation_weeks: 40
      )" + more +
              "\n      pass:\n        outcomes: [good-depth]\n";
    return text;
  }
  /// What became of the tube by score.json.
  static std::string outcome(const std::string& scenario, const std::string& pair) {
    const std::string out = (*box_ / (scenario + "-" + pair)).string();
    const Outcome trial = box_->run({"trial", "--patient", patient_->string(), "--scenario",
                                     (*box_ / "tubes.yaml").string() + ":" + scenario, "--device", "scripted:" + pair,
                                     "--headless", "--asap", "--out", out});
    EXPECT_EQ(trial.exit_code, 0) << trial.err;
    const auto score =
        QJsonDocument::fromJson(QByteArray::fromStdString(text_of(fs::path(out) / "score.json"))).object();
    return score["intubation"].toObject()["outcome"].toString().toStdString();
  }
  static Sandbox* box_;
  static fs::path* patient_;
};
Sandbox* ScriptedPairs::box_ = nullptr;
fs::path* ScriptedPairs::patient_ = nullptr;

TEST_F(ScriptedPairs, TheExpertsTubeLiesWellIsConfirmedAndReplaysToTheBit) {
  EXPECT_EQ(outcome("usual", "expert"), "good-depth");
  const curricula::TrialLog log = curricula::read_trial_log(*box_ / "usual-expert");
  EXPECT_TRUE(log.ticks.back().intubation.detector_yellow);
  EXPECT_EQ(log.ticks.back().intubation.in_hand, curricula::LoggedInHand::tube) << "the stylet is out";
  // An expert keeps the cords in sight until the tube itself, which fills them, stands before them.
  const auto score =
      QJsonDocument::fromJson(QByteArray::fromStdString(text_of(*box_ / "usual-expert" / "score.json"))).object();
  int said = 0;
  for (const QJsonValue& one : score["checklist"].toArray()) {
    const QJsonObject item = one.toObject();
    if (item["id"] == "view_before_tube" || item["id"] == "tube_passed_in_sight") {
      ++said;
      EXPECT_EQ(item["done"].toString().toStdString(), "yes") << item["sentence"].toString().toStdString();
    }
  }
  EXPECT_EQ(said, 2);
  const Outcome verified =
      box_->run({"replay", (*box_ / "usual-expert").string(), "--verify", "--patient", patient_->string()});
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
}

TEST_F(ScriptedPairs, TooShallow) { EXPECT_EQ(outcome("usual", "shallow"), "too-shallow"); }
TEST_F(ScriptedPairs, TooDeep) { EXPECT_EQ(outcome("usual", "deep"), "too-deep"); }
TEST_F(ScriptedPairs, Mainstem) { EXPECT_EQ(outcome("usual", "mainstem"), "mainstem"); }
TEST_F(ScriptedPairs, Oesophagus) { EXPECT_EQ(outcome("usual", "oesophagus"), "oesophagus"); }
TEST_F(ScriptedPairs, Abandoned) { EXPECT_EQ(outcome("usual", "abandon"), "abandoned"); }
TEST_F(ScriptedPairs, OutOfTime) { EXPECT_EQ(outcome("usual", "late"), "out-of-time"); }
TEST_F(ScriptedPairs, ATubeTooLargeIsStoppedByTheCricoid) {
  EXPECT_EQ(outcome("large", "expert"), "cricoid-too-narrow");
}
TEST_F(ScriptedPairs, ClosedCordsStopTheTube) { EXPECT_EQ(outcome("spasm", "expert"), "cords-closed"); }

}  // namespace
}  // namespace vallecula::gui::test
