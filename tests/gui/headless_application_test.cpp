// Where people write decimal commas, a command's figures and reports have points all the same: other programs read
// them.
#include "gui/commands/headless_application.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QProcess>
#include <clocale>
#include <cstdio>
#include <iostream>
#include <regex>

#include "gui/session/words_from_below.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

struct AsBefore {
  ~AsBefore() { QLocale::setDefault(before); }
  QLocale before;
};

TEST(HeadlessApplicationTest, WritesPointsWhateverTheLocaleIs) {
  const AsBefore as_before;
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  ASSERT_EQ(decimal(1.5, 1), "1,5");
  const HeadlessApplication application;
  EXPECT_EQ(decimal(1.5, 1), "1.5");
  EXPECT_EQ(in_words("4.20 N"), "4.20 N");
  EXPECT_STREQ(std::localeconv()->decimal_point, ".");
}

TEST(HeadlessApplicationTest, AGermanSystemsTrialHasTheSameFiguresAndReport) {
  const Sandbox box;
  // The C library's own German, where it can be made here; Qt's goes by the variable alone.
  const std::string locales = (box / "locales").string();
  std::filesystem::create_directories(locales);
  const bool made = QProcess::execute("localedef", {"-i", "de_DE", "-f", "UTF-8",
                                                    QString::fromStdString(locales) + "/de_DE.UTF-8"}) == 0;
  if (!made) std::cout << "Notice: localedef makes no German here; only Qt's own is tried\n";
  const std::vector<std::string> german{"LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8", "LOCPATH=" + locales};
  const std::vector<std::string> plain{"LC_ALL=C", "LANG=C"};
  const std::string patient = write_block_patient(box.folder()).string();
  const std::string scenario = write_curriculum(box.folder()).string() + ":plain";
  const std::string press = write_press(box.folder()).string();
  const auto trial = [&](const std::string& out, const std::vector<std::string>& environment) {
    return box.run({"trial", "--patient", patient, "--scenario", scenario, "--device", "scripted:" + press,
                    "--headless", "--asap", "--out", (box / out).string()},
                   environment);
  };
  const Outcome there = trial("german", german), here = trial("plain", plain);
  ASSERT_EQ(there.exit_code, 0) << there.err;
  ASSERT_EQ(here.exit_code, 0) << here.err;
  const auto file = [&](const char* out, const char* name) { return text_of(box / out / name); };
  EXPECT_EQ(file("german", "score.json"), file("plain", "score.json"));
  const std::regex comma("[0-9],[0-9]"), point("[0-9]\\.[0-9]");
  const std::string report = file("german", "report.html");
  EXPECT_TRUE(std::regex_search(report, point));
  std::smatch found;
  EXPECT_FALSE(std::regex_search(report, found, comma)) << found.str() << " in " << found.suffix().str().substr(0, 80);
  const std::string log = (box / "german").string();
  const Outcome table = box.run({"score", log}, german);
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_EQ(table.out, box.run({"score", log}, plain).out);
  EXPECT_TRUE(std::regex_search(table.out, point));
  EXPECT_EQ(box.run({"replay", log, "--verify"}, german).exit_code, 0);
}

}  // namespace
}  // namespace vallecula::gui::test
