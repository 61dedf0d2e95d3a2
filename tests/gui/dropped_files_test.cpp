// What is dropped on the window or opened from its menu is told by what lies there.
#include "gui/session/dropped_files.h"

#include <gtest/gtest.h>

#include <QStandardPaths>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "gui/session/recent_files.h"
#include "gui/session/user_settings.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

class DroppedFiles : public ::testing::Test {
 protected:
  DroppedFiles() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~DroppedFiles() override { unsetenv("VALLECULA_HOME"); }
  fs::path file(const std::string& name) const {
    fs::create_directories((box_ / name).parent_path());
    write_text(box_ / name, "x");
    return box_ / name;
  }
  static DroppedKind kind(const std::vector<fs::path>& paths) { return what_was_dropped(paths).kind; }

  Sandbox box_;
};

TEST_F(DroppedFiles, AreToldByWhatLiesThere) {
  const fs::path patient = write_block_patient(box_.folder());
  EXPECT_EQ(kind({patient}), DroppedKind::patient);
  EXPECT_EQ(kind({fs::path(patient.string() + "/")}), DroppedKind::patient) << "with a slash at its end";
  EXPECT_EQ(what_was_dropped({patient / "patient.yaml"}).path, patient) << "its own list stands for it";
  EXPECT_EQ(kind({file("renamed patient/patient.yaml").parent_path()}), DroppedKind::patient) << "whatever it is called";
  const fs::path log = file("trials/one/trial.vtrial");
  EXPECT_EQ(kind({log}), DroppedKind::trial);
  EXPECT_EQ(kind({log.parent_path()}), DroppedKind::trial);
  EXPECT_EQ(kind({file("course.yaml")}), DroppedKind::course);
  EXPECT_EQ(kind({file("course.yml")}), DroppedKind::course);
  for (const char* name : {"IM0001", "slice.dcm", "SLICE.DCM", "head.nii.gz", "head.nrrd", "head.mha", "1.2.840.113"})
    EXPECT_EQ(kind({file(name)}), DroppedKind::ct) << name;
}

TEST_F(DroppedFiles, AFolderOfAScanIsACtHoweverDeepAndSeveralSlicesAreOne) {
  const fs::path first = file("disc/DICOM/S1/I1");
  const fs::path second = file("disc/DICOM/S1/I2");
  const Dropped disc = what_was_dropped({box_ / "disc"});
  EXPECT_EQ(disc.kind, DroppedKind::ct);
  EXPECT_EQ(disc.path, box_ / "disc") << "the wizard looks for the series in it";
  const Dropped slices = what_was_dropped({first, second});
  EXPECT_EQ(slices.kind, DroppedKind::ct);
  EXPECT_EQ(slices.path, box_ / "disc/DICOM/S1");
}

TEST_F(DroppedFiles, WhatCannotBeUsedIsToldByNameWithWhatCan) {
  const auto told = [](const std::vector<fs::path>& paths) {
    const Dropped found = what_was_dropped(paths);
    EXPECT_EQ(found.kind, DroppedKind::nothing);
    return found.message.toStdString();
  };
  const auto holds = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
  const std::string picture = told({file("photo.jpeg")});
  EXPECT_TRUE(holds(picture, "photo.jpeg") && holds(picture, "NAME.patient")) << picture;
  EXPECT_FALSE(holds(picture, box_.folder().string())) << "no folder of anybody's";
  fs::create_directories(box_ / "empty");
  EXPECT_TRUE(holds(told({box_ / "empty"}), "empty"));
  fs::create_directories(box_ / "half.patient");
  EXPECT_TRUE(holds(told({box_ / "half.patient"}), "patient.yaml"));
  EXPECT_TRUE(holds(told({box_ / "gone"}), "gone is not there"));
  EXPECT_TRUE(holds(told({file("a/course.yaml"), file("b/I1")}), "one of them"));
  told({});
}

TEST_F(DroppedFiles, TheLastEightAreRememberedAndThoseThatAreGoneAreNotShown) {
  for (int i = 0; i < 11; ++i) remember_recent(file("course-" + std::to_string(i) + ".yaml"));
  remember_recent(box_ / "course-5.yaml");
  auto kept = kept_recent();
  ASSERT_EQ(kept.size(), 8u);
  EXPECT_EQ(kept.front(), box_ / "course-5.yaml") << "opened again, it is the newest";
  EXPECT_EQ(kept[1], box_ / "course-10.yaml");
  EXPECT_EQ(std::count(kept.begin(), kept.end(), box_ / "course-5.yaml"), 1);
  fs::remove(box_ / "course-10.yaml");
  const auto there = still_there(kept);
  ASSERT_EQ(there.size(), 7u);
  EXPECT_EQ(there[1].path, box_ / "course-9.yaml");
  EXPECT_EQ(described(there[1]), "Course: course-9");
  const fs::path log = file("trials/20260503-140210-first-look/trial.vtrial");
  const QString trial = described({DroppedKind::trial, log.parent_path(), QDateTime({2026, 5, 3}, {14, 2})});
  EXPECT_TRUE(trial.startsWith("Trial: first-look, ")) << trial.toStdString();
  EXPECT_EQ(kept_recent().size(), 8u) << "a disc that is not in the drive may come back";
}

TEST_F(DroppedFiles, ATrialIsOfTheDayItWasDoneWhateverIsWrittenBesideItsLog) {
  const fs::path log = file("20260503-140210-first-look/trial.vtrial");
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(24 * 40);
  fs::last_write_time(log, long_ago);
  file("20260503-140210-first-look/first-look.pdf");  // an export: the folder is of today
  const auto there = still_there({log.parent_path()});
  ASSERT_EQ(there.size(), 1u);
  EXPECT_EQ(there[0].kind, DroppedKind::trial);
  EXPECT_NEAR(static_cast<double>(there[0].changed.daysTo(QDateTime::currentDateTime())), 40.0, 1.0);
}

/// An environment variable for the time being.
class Elsewhere {
 public:
  Elsewhere(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Elsewhere() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
  Elsewhere(const Elsewhere&) = delete;
  Elsewhere& operator=(const Elsewhere&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST_F(DroppedFiles, AnOpeningDialogBeginsWhereTheLastOneEndedElseInTheDocumentsElseAtHome) {
  const Elsewhere home("HOME", box_.folder().string());
  const Elsewhere settings("XDG_CONFIG_HOME", (box_ / "config").string());  // where another folder may be named
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  ASSERT_TRUE(documents.startsWith(QString::fromStdString(box_.folder().string()))) << documents.toStdString();
  if (documents != QString::fromStdString(box_.folder().string())) {
    EXPECT_EQ(folder_to_open().toStdString(), box_.folder().string()) << "not everybody has one for documents";
    fs::create_directories(documents.toStdString());
  }
  EXPECT_EQ(folder_to_open(), documents);
  const std::filesystem::path folder = box_ / "courses";
  std::filesystem::create_directories(folder);
  keep_opened(QString::fromStdString((folder / "one.yaml").string()));
  EXPECT_EQ(folder_to_open().toStdString(), folder.string());
  std::filesystem::remove_all(folder);
  EXPECT_EQ(folder_to_open(), documents) << "it is gone";
}

}  // namespace
}  // namespace vallecula::gui::test
