// Stations that write at once and are killed at any moment lose nothing that they were told is recorded.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "curricula/records/people.h"
#include "curricula/records/progress.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

constexpr int kWriters = 4;

struct Writer {
  pid_t process = -1;
  int said = -1;  ///< what it has told is recorded: one uid and id a line
};

/// A process of its own that begins and adds trials until it is killed. It opens its own connection: none is open where
/// it is forked.
Writer start_writer(const RecordsLocation& location) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child != 0) {
    ::close(ends[1]);
    return {child, ends[0]};
  }
  ::close(ends[0]);
  try {
    Records records(location);
    for (int n = 0;; ++n) {
      RecordRow row = sample("2024-05-03T10:00:00Z");
      row.uid = records.begin({"", "2024-05-03T09:59:00Z", "c", "s", "mouse", "/trials/a.vtrial", 0});
      row.score.ticks = n;
      const long long id = records.add(row);
      const std::string line = row.uid + " " + std::to_string(id) + "\n";
      if (::write(ends[1], line.data(), line.size()) != static_cast<ssize_t>(line.size())) ::_exit(1);
    }
  } catch (const std::exception& error) {
    const std::string line = std::string("! ") + error.what() + "\n";
    if (::write(ends[1], line.data(), line.size()) < 0) ::_exit(2);
  }
  ::_exit(1);
}

/// What it said to the end, after it was killed: whole lines.
void listen(Writer& writer, std::map<std::string, long long>& recorded, int& errors, bool may_not_open) {
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = ::read(writer.said, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(got));
  ::close(writer.said);
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    const std::string line = text.substr(at, end - at);
    if (line[0] == '!') {
      // A station that starts while the server has no power says so and records nothing.
      if (may_not_open && line.find("cannot be opened") != std::string::npos) continue;
      ++errors;
      ADD_FAILURE() << line;
    } else {
      recorded[line.substr(0, 32)] = std::atoll(line.c_str() + 33);
    }
  }
}

TEST_P(AnyRecords, WritersThatAreKilledAtAnyMomentLoseNothing) {
  const bool slow = std::getenv("VALLECULA_SLOW") != nullptr;
  const bool loses_power = on_server() && slow;
  const double seconds = slow ? 60.0 : 2.0;
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::mt19937 random(20260503);
  std::uniform_int_distribution<int> pause_ms(5, 120), which(0, kWriters - 1);
  std::map<std::string, long long> recorded;
  int errors = 0, kills = 0;
  std::vector<Writer> writers;
  for (int i = 0; i < kWriters; ++i) writers.push_back(start_writer(location()));  // all of them make the schema
  while (std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms(random)));
    Writer& victim = writers[static_cast<std::size_t>(which(random))];
    ASSERT_EQ(::kill(victim.process, SIGKILL), 0);
    ASSERT_EQ(::waitpid(victim.process, nullptr, 0), victim.process);
    listen(victim, recorded, errors, loses_power);
    ++kills;
    // Every ten seconds or so the server loses its power on top of it.
    if (loses_power && kills % 100 == 50) PostgresServer::instance().crash_and_restart();
    victim = start_writer(location());
  }
  for (Writer& writer : writers) {
    ASSERT_EQ(::kill(writer.process, SIGKILL), 0);
    ASSERT_EQ(::waitpid(writer.process, nullptr, 0), writer.process);
    listen(writer, recorded, errors, loses_power);
  }
  EXPECT_EQ(errors, 0);
  EXPECT_GT(kills, 10);
  EXPECT_GT(recorded.size(), 20u);

  Records records(location());
  std::map<std::string, long long> found;
  for (const RecordRow& row : records.newest(1'000'000)) {
    EXPECT_TRUE(found.emplace(row.uid, row.id).second) << "twice: " << row.uid;
    expect_same(row, [&] {
      RecordRow same = sample("2024-05-03T10:00:00Z");
      same.score.ticks = row.score.ticks;
      return same;
    }());
  }
  for (const auto& [uid, id] : recorded) {
    const auto row = found.find(uid);
    ASSERT_NE(row, found.end()) << "told it was recorded, and it is not: " << uid;
    EXPECT_EQ(row->second, id);
  }
  // At most one of each killed writer was recorded and could not say so; and one was begun and not ended.
  EXPECT_LE(found.size(), recorded.size() + static_cast<std::size_t>(kills + kWriters));
  for (const OpenTrial& open : records.open_trials()) EXPECT_EQ(found.count(open.uid), 0u) << "open, and recorded";
  EXPECT_LE(records.open_trials().size(), static_cast<std::size_t>(kills + kWriters));
  if (!on_server()) {
    EXPECT_EQ(ask("PRAGMA integrity_check"), "ok");
    EXPECT_EQ(ask("PRAGMA foreign_key_check"), "");
  }
  std::printf("%zu trials recorded by %d writers, %d of them killed\n", found.size(), kWriters, kills);
}

}  // namespace
}  // namespace vallecula::curricula::testing
