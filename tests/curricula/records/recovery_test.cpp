#include "curricula/records/recovery.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "curricula/records/progress.h"
#include "curricula/records/trial_files.h"
#include "curricula/trial_log.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

namespace fs = std::filesystem;

/// A header with which any log can be scored: the shipped course's first scenario.
LogHeader header() {
  const Curriculum course =
      load_curriculum(fs::path(VALLECULA_SOURCE_DIR) / "curricula" / "courses" / "first-steps.yaml");
  LogHeader header;
  header.scenario_id = course.scenarios[0].id;
  header.scenario_yaml = attempt_of(course.scenarios[0], Mode::assessment, 0).yaml;
  header.device_kind = "mouse";
  for (const char* gum : {"gum_upper_midline", "gum_lower_midline"}) header.landmarks_m[gum] = {0.0, -0.02, 0.0};
  return header;
}

LogTick tick(std::int64_t n) {
  LogTick t;
  t.tick = n;
  t.time_s = 1e-3 * static_cast<double>(n);
  return t;
}

OpenTrial open_trial(const fs::path& log) {
  return {"", "2024-05-03T10:00:00Z", "first-steps", "term", "mouse", log, 0, "the-view"};
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A real process that records a trial until it is killed; returns when it has written at least `ticks`.
pid_t record_in_process(const RecordsLocation& location, const fs::path& log, int ticks) {
  int pipe_ends[2];
  EXPECT_EQ(::pipe(pipe_ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      TrialLogWriter writer(log, header());
      Records records(location);
      records.begin(open_trial(log));
      for (int n = 0;; ++n) {
        writer.append(tick(n));
        if (n == ticks && ::write(pipe_ends[1], "x", 1) != 1) ::_exit(1);
        if (n > ticks) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    ::_exit(1);
  }
  char ready = 0;
  ::close(pipe_ends[1]);
  EXPECT_EQ(::read(pipe_ends[0], &ready, 1), 1);
  ::close(pipe_ends[0]);
  return child;
}

TEST_P(AnyRecords, AKilledTrialIsFoundAndKeptUpToItsLastWholeBlock) {
  const fs::path log = folder_ / "trial.vtrial", part = folder_ / "trial.vtrial.part";
  const pid_t child = record_in_process(location(), log, 1000);
  {
    Records records(location());
    EXPECT_TRUE(recover_trials(records).empty()) << "it lives: not touched";
    EXPECT_EQ(records.open_trials().size(), 1u);
    EXPECT_TRUE(fs::exists(part));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  std::ofstream(part, std::ios::binary | std::ios::app) << "TICK and half a block that the power cut left";
  const std::string before = content_of(part);

  Records records(location());
  const auto found = recover_trials(records);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].problem, "");
  EXPECT_FALSE(found[0].complete);
  EXPECT_FALSE(fs::exists(part));
  const TrialLog kept = read_trial_log(log);
  EXPECT_EQ(kept.ticks.size() % 256, 0u) << "whole blocks";
  EXPECT_GE(kept.ticks.size(), 768u);
  EXPECT_EQ(kept.footer.ended, "interrupted");
  EXPECT_FALSE(kept.footer.complete);
  const std::string after = content_of(log);
  const std::size_t same = before.find("TICK and half");
  ASSERT_NE(same, std::string::npos);
  EXPECT_EQ(after.substr(0, same), before.substr(0, same)) << "what was recorded is as it was";

  const auto rows = records.newest(5);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].id, found[0].record_id);
  EXPECT_FALSE(rows[0].score.complete);
  EXPECT_FALSE(rows[0].score.passed);
  EXPECT_EQ(rows[0].score.ticks, static_cast<long long>(kept.ticks.size()));
  EXPECT_EQ(rows[0].trial_path, log.string());
  EXPECT_EQ(rows[0].module_id, "the-view");
  EXPECT_EQ(rows[0].mode, Mode::assessment) << "as its log says";
  EXPECT_EQ(rows[0].duration_s, 0.001 * static_cast<double>(kept.ticks.size()));
  EXPECT_EQ(rows[0].figures.at("passed"), 0.0);
  EXPECT_EQ(rows[0].log_sha256, log_sha256(log));
  EXPECT_TRUE(recover_trials(records).empty()) << "once";
  EXPECT_EQ(records.newest(5).size(), 1u);
}

/// Killed between the log's end and its record.
TEST_P(AnyRecords, AWholeLogWithoutItsRecordGetsItOnce) {
  const fs::path log = folder_ / "trial.vtrial";
  Records records(location());
  TrialLogWriter writer(log, header());
  const std::string uid = records.begin(open_trial(log));
  for (int n = 0; n < 600; ++n) writer.append(tick(n));
  LogFooter footer;
  footer.complete = true;
  footer.ended = "finished";
  writer.close(footer);
  const std::string before = content_of(log);
  Records elsewhere(location());
  ASSERT_EQ(recover_trials(elsewhere).size(), 1u);
  EXPECT_EQ(content_of(log), before);
  const auto rows = records.newest(5);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(rows[0].score.complete);
  EXPECT_EQ(rows[0].finished_utc, "2024-05-03T10:00:00Z") << "after 0.6 s";
  RecordRow own = sample("2024-05-03T10:00:01Z");  // the program lived after all
  own.uid = uid;
  EXPECT_EQ(records.add(own), rows[0].id);
  EXPECT_EQ(records.newest(5).size(), 1u);
}

TEST_P(AnyRecords, WhatLeftNothingBehindIsForgottenAndWhatIsDamagedIsReportedAndKept) {
  Records records(location());
  const fs::path nothing = folder_ / "a" / "trial.vtrial", empty = folder_ / "b" / "trial.vtrial",
                 damaged = folder_ / "c" / "trial.vtrial";
  for (const fs::path& log : {nothing, empty, damaged}) {
    fs::create_directories(log.parent_path());
    records.begin(open_trial(log));
  }
  { TrialLogWriter writer(empty, header()); }
  std::ofstream(damaged.string() + ".part") << "VALLECUL";
  for (int start = 0; start < 2; ++start) {
    const auto found = recover_trials(records);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].log, damaged);
    EXPECT_NE(found[0].problem, "");
    EXPECT_EQ(found[0].record_id, 0);
  }
  EXPECT_FALSE(fs::exists(empty.string() + ".part"));
  EXPECT_TRUE(fs::exists(damaged.string() + ".part"));
  EXPECT_EQ(records.open_trials().size(), 1u);
  EXPECT_TRUE(records.newest(5).empty());
}

TEST_P(AnyRecords, ATrialOnADiskThatIsNotThereWaits) {
  Records records(location());
  const fs::path log = folder_ / "disk" / "trial.vtrial";
  fs::create_directories(log.parent_path());
  records.begin(open_trial(log));
  {
    TrialLogWriter writer(log, header());
    for (int n = 0; n < 300; ++n) writer.append(tick(n));
  }
  fs::rename(folder_ / "disk", folder_ / "unplugged");
  const auto waiting = recover_trials(records);
  ASSERT_EQ(waiting.size(), 1u);
  EXPECT_NE(waiting[0].problem.find("connect the disk"), std::string::npos) << waiting[0].problem;
  EXPECT_EQ(waiting[0].problem.find(folder_.string()), std::string::npos);
  EXPECT_EQ(records.open_trials().size(), 1u);
  fs::rename(folder_ / "unplugged", folder_ / "disk");
  EXPECT_NE(recover_trials(records).at(0).record_id, 0);
  EXPECT_TRUE(records.open_trials().empty());
}

/// One byte of block `block` is wrong (0: the header), and whole blocks follow.
void damage(const fs::path& part, std::size_t block) {
  std::string bytes = content_of(part);
  std::size_t at = bytes.find("HEAD");
  for (std::size_t i = 0; i < block; ++i) at = bytes.find("TICK", at + 4);
  ASSERT_LT(at, bytes.size());
  bytes[at + 40] = static_cast<char>(bytes[at + 40] ^ 1);
  std::ofstream(part, std::ios::binary) << bytes;
}

TEST_P(AnyRecords, WhatIsBehindDamageIsKept) {
  const fs::path first = folder_ / "first.vtrial", second = folder_ / "second.vtrial";
  for (const fs::path& log : {first, second}) {
    TrialLogWriter writer(log, header());
    for (int n = 0; n < 1000; ++n) writer.append(tick(n));
  }
  damage(first.string() + ".part", 1);
  damage(second.string() + ".part", 2);
  const std::string no_tick = content_of(first.string() + ".part"), some = content_of(second.string() + ".part");
  EXPECT_NE(error_of<TrialLogError>([&] { close_cut_log(first); }).find("damaged"), std::string::npos);
  EXPECT_EQ(content_of(first.string() + ".part"), no_tick);
  EXPECT_EQ(close_cut_log(second), CutLog::kept);
  EXPECT_EQ(read_trial_log(second).ticks.size(), 256u);
  EXPECT_EQ(content_of(second.string() + ".damaged"), some);
  const auto files = files_of_trial(second);
  EXPECT_EQ(files, (std::vector<fs::path>{second.string() + ".damaged", second}));
}

TEST_P(AnyRecords, ALogThatIsBeingWrittenIsNobodyElses) {
  const fs::path log = folder_ / "trial.vtrial";
  TrialLogWriter writer(log, header());
  for (int n = 0; n < 300; ++n) writer.append(tick(n));
  const std::string before = content_of(log.string() + ".part");
  EXPECT_NE(error_of<TrialLogError>([&] { TrialLogWriter second(log, header()); }).find("another trial"),
            std::string::npos);
  EXPECT_EQ(content_of(log.string() + ".part"), before);
  EXPECT_EQ(close_cut_log(log), CutLog::being_written);
  EXPECT_TRUE(is_being_written(log));
  EXPECT_TRUE(files_of_trial(log).empty()) << "an older trial's files go, not those of the one that has begun";
}

TEST(TrialFiles, AreThoseOfTheLogAndNoOthers) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("vallecula-trial-files-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  for (const char* name : {"trial.vtrial", "score.json", "report.html", "force.png", "fault.csv", "tool.ply",
                           "operator-1.png", "sagittal-2.png", "replay-3s.png", "holiday.png", "before-reset-1.vtrial",
                           "before-reset-1.tool.ply", "before-reset-1.fault.csv", "notes.txt"})
    std::ofstream(folder / name) << name;
  EXPECT_EQ(files_of_trial(folder / "trial.vtrial").size(), 9u);
  EXPECT_EQ(files_of_trial(folder / "trial.vtrial").back(), folder / "trial.vtrial");
  EXPECT_EQ(files_of_trial(folder / "before-reset-1.vtrial").size(), 3u);
  EXPECT_TRUE(files_of_trial(folder / "other.vtrial").empty());
  fs::remove_all(folder);
}

}  // namespace
}  // namespace vallecula::curricula::testing
