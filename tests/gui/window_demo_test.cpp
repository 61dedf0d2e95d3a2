// `vallecula demo` as a person starts it, on a machine without a screen.
#include <iostream>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <fstream>

#include "curricula/trial_log.h"
#include "gui/session/user_paths.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;
const std::vector<std::string> kNoScreen = {"DISPLAY=", "WAYLAND_DISPLAY="};

QJsonObject json_of(const fs::path& file) {
  QFile in(QString::fromStdString(file.string()));
  EXPECT_TRUE(in.open(QIODevice::ReadOnly)) << file;
  return QJsonDocument::fromJson(in.readAll()).object();
}

TEST(Demo, RefusesAFolderThatIsNotItsOwn) {
  const test::Sandbox box;
  fs::create_directory(box / "mine");
  test::write_text(box / "mine" / "thesis.txt", "years of work");
  const test::Outcome outcome = box.run({"demo", "--out", (box / "mine").string()}, kNoScreen);
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("mine"), std::string::npos);
  EXPECT_EQ(box.names("mine"), std::vector<std::string>{"thesis.txt"});
}

TEST(Demo, WithoutXvfbSaysWhatToInstallAndLeavesNothing) {
  const test::Sandbox box;
  std::vector<std::string> environment = kNoScreen;
  environment.push_back("PATH=/nonexistent");
  const test::Outcome outcome = box.run({"demo", "--out", (box / "deep" / "out").string()}, environment);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("install xvfb"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(box / "deep"));
}

TEST(Demo, WrongWeightIsWrongUsage) {
  const test::Sandbox box;
  EXPECT_EQ(box.run({"demo", "--weight", "12"}, kNoScreen).exit_code, 2);
}

TEST(DemoRealTime, FromCtToScoreTheExpertPassesAndTheNoviceDoesNot) {
  const test::Sandbox box;
  const fs::path out = box / "results";
  fs::create_directories(box.home());
  std::ofstream(box.home() / "settings.ini") << "[look]\ntrachea=blue\n";  // told from all else in a picture
  const test::Outcome outcome = box.run({"demo", "--out", out.string()}, kNoScreen);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(out.string()), std::string::npos) << "says where the results are";
  for (const char* name : {"trial.vtrial", "score.json", "report.html", "force.png", "manikin.patient", "ct"})
    EXPECT_TRUE(fs::exists(out / name)) << name;
  for (const char* name : {"trial.vtrial", "score.json", "report.html", "force.png"})
    EXPECT_TRUE(fs::exists(out / "novice" / name)) << name;
  for (const auto& entry : fs::directory_iterator(box.folder()))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();

  int blue_at_best = 0;
  bool between_cords = false;
  int operators = 0, sagittals = 0;
  for (const auto& entry : fs::directory_iterator(out)) {
    const std::string name = entry.path().filename().string();
    const bool by_operator = name.rfind("operator-", 0) == 0, sagittal = name.rfind("sagittal-", 0) == 0;
    if (!by_operator && !sagittal) continue;
    (by_operator ? operators : sagittals) += 1;
    const QImage picture(QString::fromStdString(entry.path().string()));
    EXPECT_GT(colours_in(picture), by_operator ? 40 : 5) << name;
    between_cords |= name == "operator-7-between-cords.png";
    if (name == "operator-5-best-sight.png")
      blue_at_best = find_pixels(picture, [](QRgb c, int, int) { return is_airway_blue(c); }).pixels;
  }
  // In real time a machine that cannot finish its steps plays another trial (the ticks say so): what the expert sees is
  // held against the deterministic run below, and against the live one where the machine kept up.
  const curricula::TrialLog live = curricula::read_trial_log(out);
  const bool kept_up = live.footer.overruns * 50 < static_cast<long long>(live.ticks.size());
  if (!kept_up) std::cout << "the machine was busy: " << live.footer.overruns << " steps late; live sight not judged\n";
  EXPECT_GE(operators, 4);
  EXPECT_EQ(sagittals, operators);
  if (kept_up) {
    EXPECT_EQ(operators, 9);
    EXPECT_TRUE(between_cords) << "the tube between the cords is what the demo is for";
    EXPECT_GT(blue_at_best, 300) << "the airway is to be seen";
  }

  const QJsonObject expert = json_of(out / "score.json"), novice = json_of(out / "novice" / "score.json");
  for (const char* key : {"peak_tongue_force_n", "time_to_trachea_visible_s", "glottis_visible_max_percent",
                          "peak_gum_force_n", "attempt_time_s", "time_over_force_limit_s", "time_over_target_s",
                          "loop_rate_hz", "deadline_misses", "ticks", "passed", "reasons"}) {
    EXPECT_TRUE(expert.contains(key)) << key;
    EXPECT_TRUE(novice.contains(key)) << key;
  }
  if (kept_up) {
    EXPECT_TRUE(expert["passed"].toBool()) << outcome.out;
    EXPECT_GT(expert["loop_rate_hz"].toDouble(), 950.0);
  }
  // At once, since nothing here has the clock: a trial like any other can be replayed from where it lies, and done again
  // in the same place.
  const test::Sandbox other, third;
  const pid_t expert_again = other.start({"replay", out.string(), "--verify"}, kNoScreen);
  const pid_t novice_again = third.start({"replay", (out / "novice").string(), "--verify"}, kNoScreen);
  const test::Outcome again = box.run(
      {"trial", "--patient", (out / "manikin.patient").string(), "--curriculum",
       (curricula_folder() / "first-intubation.yaml").string(), "--scenario", "term-tube", "--device", "scripted:expert",
       "--headless", "--asap", "--out", (box / "asap").string()},
      kNoScreen);
  EXPECT_EQ(other.wait(expert_again).exit_code, 0);
  EXPECT_EQ(third.wait(novice_again).exit_code, 0);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(json_of(box / "asap" / "score.json")["passed"].toBool()) << again.out;
  EXPECT_EQ(json_of(box / "asap" / "score.json")["intubation"].toObject()["outcome"].toString(), "good-depth");
  // What the blade moves in a tick changes the tongue's force by hundredths of a newton: a blow is none of the tissue's.
  double change = 0.0;
  curricula::LogLoad last;
  for (const auto& tick : curricula::read_trial_log(box / "asap").ticks) {
    const curricula::LogLoad& load = tick.loads[curricula::kTongue];
    double squared = 0.0;
    for (int a = 0; a < 3; ++a) squared += (load.force_n[a] - last.force_n[a]) * (load.force_n[a] - last.force_n[a]);
    change = std::max(change, std::sqrt(squared));
    last = load;
  }
  EXPECT_LT(change, 0.2);
  EXPECT_FALSE(novice["passed"].toBool());
  QString reasons;
  for (const auto& reason : novice["reasons"].toArray()) reasons += reason.toString() + "\n";
  EXPECT_TRUE(reasons.contains("gum")) << reasons.toStdString();
  EXPECT_TRUE(reasons.contains("force limit")) << reasons.toStdString();
}

}  // namespace
}  // namespace vallecula::gui::window_test
