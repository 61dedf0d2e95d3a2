// What can go wrong with a database: one clear error, nothing lost.
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QVariant>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>

#include "curricula/records/location.h"
#include "curricula/records/migrations.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

namespace fs = std::filesystem;

class RecordsTrouble : public TemporaryFolder {
 protected:
  RecordsLocation location() const {
    RecordsLocation there(folder_ / "records.sqlite");
    there.patience_s = 0.3;
    return there;
  }
};

/// In a process of its own, whose limits and mounts are not this one's; what it says.
std::string in_a_process(const std::function<std::string()>& work) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    std::string said;
    try {
      said = work();
    } catch (const std::exception& error) {
      said = std::string("unexpected: ") + error.what();
    }
    ::_exit(::write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size()) ? 0 : 1);
  }
  ::close(ends[1]);
  std::string said;
  char buffer[1024];
  for (ssize_t got = 0; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;)
    said.append(buffer, static_cast<std::size_t>(got));
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return said;
}

/// Adds until it fails: "COUNT MESSAGE".
std::string add_until_it_fails(Records& records) {
  RecordRow row = sample("2024-05-03T10:00:00Z");
  row.score.reasons = {std::string(20'000, 'x')};
  for (int n = 0; n < 10'000; ++n) {
    const std::string error = error_of<RecordsError>([&] { records.add(row); });
    if (!error.empty()) return std::to_string(n) + " " + error;
  }
  return "never";
}

TEST_F(RecordsTrouble, AnotherProgramThatDoesNotLetGoIsNamedAfterAWait) {
  Records records(location());
  records.add(sample("2024-05-03T10:00:00Z"));
  {
    QSqlDatabase other = QSqlDatabase::addDatabase("QSQLITE", "other");
    other.setDatabaseName(QString::fromStdString(location().file.string()));
    ASSERT_TRUE(other.open());
    ASSERT_TRUE(QSqlQuery(other).exec("BEGIN IMMEDIATE"));
    const auto began = std::chrono::steady_clock::now();
    const std::string error = error_of<RecordsError>([&] { records.add(sample("2024-05-04T10:00:00Z")); });
    EXPECT_GE(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(300));
    EXPECT_NE(error.find("another program is writing"), std::string::npos) << error;
    EXPECT_EQ(records.newest(5).size(), 1u) << "reading goes on meanwhile";
    EXPECT_NE(error_of<RecordsError>([&] { Records second(location()); }).find("another program"), std::string::npos);
    QSqlQuery(other).exec("ROLLBACK");
    other.close();
  }
  QSqlDatabase::removeDatabase("other");
  records.add(sample("2024-05-04T10:00:00Z"));
  EXPECT_EQ(records.newest(5).size(), 2u);
}

TEST_F(RecordsTrouble, AFileThatMayNotGrowIsNamedAndKeepsWhatItHas) {
  const std::string said = in_a_process([this] {
    ::signal(SIGXFSZ, SIG_IGN);
    Records records(location());
    const rlimit limit{400'000, 400'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    return add_until_it_fails(records);
  });
  const int added = std::atoi(said.c_str());
  EXPECT_GT(added, 0) << said;
  EXPECT_TRUE(said.find("what was recorded before is kept") != std::string::npos) << said;
  EXPECT_NE(said.find("records.sqlite"), std::string::npos) << said;
  Records records(location());
  EXPECT_EQ(records.newest(10'000).size(), static_cast<std::size_t>(added));
  records.add(sample("2024-05-04T10:00:00Z"));
}

/// A disk of 1 MB that is really full.
TEST_F(RecordsTrouble, AFullDiskIsNamedAndKeepsWhatItHas) {
  const std::string said = in_a_process([this]() -> std::string {
    const uid_t user = ::getuid();
    if (::unshare(user == 0 ? CLONE_NEWNS : CLONE_NEWNS | CLONE_NEWUSER) != 0) return "not permitted";
    if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return "not permitted";
    if (::mount("small", folder_.c_str(), "tmpfs", 0, "size=1m") != 0) return "not permitted";
    std::string failed;
    {
      Records records(location());
      failed = add_until_it_fails(records);
    }
    const auto added = static_cast<std::size_t>(std::atoi(failed.c_str()));
    if (failed.find("disk is full") == std::string::npos) return failed;
    // Nothing was lost, and once there is space all goes on.
    if (::mount("small", folder_.c_str(), "tmpfs", MS_REMOUNT, "size=8m") != 0) return "cannot be made larger";
    Records records(location());
    if (added == 0 || records.newest(10'000).size() != added) return "lost: " + failed;
    records.add(sample("2024-05-04T10:00:00Z"));
    return "good";
  });
  if (said == "not permitted") GTEST_SKIP() << "this user may not mount a small disk";
  EXPECT_EQ(said, "good");
}

TEST_F(RecordsTrouble, ADamagedFileIsNamedAndLeftAlone) {
  {
    Records records(location());
    for (int i = 0; i < 50; ++i) records.add(sample("2024-05-03T10:00:00Z"));
  }
  std::string bytes = read(location().file);
  ASSERT_GT(bytes.size(), 8192u);
  for (std::size_t i = 0; i < bytes.size(); i += 2) bytes[i] = static_cast<char>(bytes[i] ^ 0x5a);
  write("records.sqlite", bytes);
  std::string error = error_of<RecordsError>([&] { Records records(location()); });
  EXPECT_NE(error.find("damaged or not Vallecula's"), std::string::npos) << error;
  EXPECT_EQ(read(location().file), bytes);

  {  // its head is well, its pages are not
    fs::remove(location().file);
    Records records(location());
    for (int i = 0; i < 50; ++i) records.add(sample("2024-05-03T10:00:00Z"));
  }
  bytes = read(location().file);
  for (std::size_t i = 4096; i < bytes.size(); ++i) bytes[i] = 'x';
  write("records.sqlite", bytes);
  error = error_of<RecordsError>([&] {
    Records records(location());
    records.add(sample("2024-05-04T10:00:00Z"));
  });
  EXPECT_NE(error.find("damaged or not Vallecula's"), std::string::npos) << error;
}

TEST_F(RecordsTrouble, AFileThatMayNotBeWrittenIsNamed) {
  { Records records(location()); }
  const std::string said = in_a_process([this]() -> std::string {
    fs::permissions(location().file, fs::perms::owner_read | fs::perms::others_read);
    fs::permissions(folder_,
                    fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
    if (::getuid() == 0 && ::setuid(65534) != 0) return "not permitted";
    return error_of<RecordsError>([&] { Records records(location()); });
  });
  fs::permissions(folder_, fs::perms::owner_all);
  if (said == "not permitted") GTEST_SKIP() << said;
  EXPECT_NE(said.find("may be written to"), std::string::npos) << said;
}

TEST_F(RecordsTrouble, TheSettingIsReadOrRefusedAndNoMessageHasThePassword) {
  const RecordsLocation server =
      RecordsLocation::parse("postgresql://anna:s%2Fecret@db.example:5433/simulation%20lab?sslmode=verify-full");
  EXPECT_TRUE(server.server());
  EXPECT_EQ(server.host, "db.example");
  EXPECT_EQ(server.port, 5433);
  EXPECT_EQ(server.user, "anna");
  EXPECT_EQ(server.password, "s/ecret");
  EXPECT_EQ(server.database, "simulation lab");
  EXPECT_EQ(server.options.at("sslmode"), "verify-full");
  EXPECT_EQ(server.shown(), "postgresql://db.example:5433/simulation lab");
  EXPECT_EQ(RecordsLocation::parse("postgres:///lab?host=/run/postgresql").host, "/run/postgresql");
  EXPECT_FALSE(RecordsLocation::parse("/data/records.sqlite").server());
  EXPECT_EQ(RecordsLocation::parse("/data/records.sqlite").shown(), "/data/records.sqlite");
  for (const char* bad :
       {"", "postgresql://anna:secret@host", "postgresql://anna:secret@host/", "mysql://anna:secret@host/db",
        "postgresql://anna:secret@host:99999/db", "postgresql://anna:secret@ho st/db",
        "postgresql://anna:secret@host/db?passfile=/x", "postgresql://anna:secret@host/db?sslmode=a;b"}) {
    const std::string error = error_of<RecordsError>([&] { RecordsLocation::parse(bad); });
    EXPECT_NE(error, "") << bad;
    EXPECT_EQ(error.find("secret"), std::string::npos) << error;
    EXPECT_EQ(error.find("anna"), std::string::npos) << error;
  }
}

TEST_F(RecordsTrouble, AStationHasOneIdAndKeepsIt) {
  const std::string id = station_id(folder_ / "new");
  EXPECT_EQ(id.size(), 32u);
  EXPECT_EQ(station_id(folder_ / "new"), id);
  EXPECT_NE(station_id(folder_ / "other"), id);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "new"), {}), 1);
  write("station-id", "nonsense\n");
  EXPECT_NE(error_of<RecordsError>([&] { station_id(folder_); }).find("station-id"), std::string::npos);
  write("file", "x");
  EXPECT_NE(error_of<RecordsError>([&] { station_id(folder_ / "file"); }).find("permission"), std::string::npos);
}

class PostgresServerTrouble : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string reason = PostgresServer::why_not();
    if (!reason.empty()) GTEST_SKIP() << reason;
    setting_ = server().new_database();
  }
  static PostgresServer& server() { return PostgresServer::instance(); }
  RecordsLocation location() const { return RecordsLocation::parse(setting_); }
  std::string error_with(const std::string& what, const std::string& instead) const {
    std::string setting = setting_;
    setting.replace(setting.find(what), what.size(), instead);
    return error_of<RecordsError>([&] { Records records(RecordsLocation::parse(setting)); });
  }
  std::string setting_;
};

TEST_F(PostgresServerTrouble, ASocketServesAsWell) {
  Records records(RecordsLocation::parse(server().new_database(true)));
  EXPECT_GT(records.add(sample("2024-05-03T10:00:00Z")), 0);
}

TEST_F(PostgresServerTrouble, WhatCannotBeReachedOrEnteredIsNamedAtOnceAndWithoutThePassword) {
  const auto began = std::chrono::steady_clock::now();
  const std::string wrong = error_with(PostgresServer::kPassword, "not-the-password");
  EXPECT_NE(wrong.find("check user, password"), std::string::npos) << wrong;
  EXPECT_EQ(wrong.find("not-the-password"), std::string::npos) << wrong;
  const std::string nowhere = error_with("/test", "/nowhere");
  EXPECT_NE(nowhere.find("the database's name"), std::string::npos) << nowhere;
  const std::string port = setting_.substr(setting_.rfind(':'), setting_.rfind('/') - setting_.rfind(':'));
  const std::string down = error_with(port, ":1");
  EXPECT_NE(down.find("check that the server runs"), std::string::npos) << down;
  EXPECT_NE(down.find("127.0.0.1:1/"), std::string::npos) << down;
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(8));
  for (const std::string& error : {nowhere, down}) {
    EXPECT_EQ(error.find(PostgresServer::kPlainPassword), std::string::npos) << error;
    EXPECT_EQ(error.find(PostgresServer::kPassword), std::string::npos) << error;
  }
}

/// The same steps from each schema on, with a row that was there before.
TEST_F(PostgresServerTrouble, EachOlderSchemaIsBroughtForwardWithItsRows) {
  const auto& steps = record_migrations();
  for (std::size_t schema = 1; schema <= steps.size(); ++schema) {
    SCOPED_TRACE("schema " + std::to_string(schema));
    const std::string setting = server().new_database();
    std::string sql = "CREATE TABLE schema_version (version BIGINT NOT NULL); INSERT INTO schema_version VALUES (" +
                      std::to_string(schema) + ");";
    for (std::size_t step = 0; step < schema; ++step)
      for (const Statement& statement : steps[step])
        sql += in_dialect(statement, Dialect::postgres).toStdString() + ";";
    sql +=
        "INSERT INTO trials (finished_utc, curriculum_id, scenario_id, device_kind, trial_path, complete, passed, "
        "reasons, "
        "peak_tongue_force_n, time_of_peak_tongue_force_s, glottis_visible_max_percent, peak_gum_force_n, "
        "time_of_peak_gum_force_s, attempt_time_s, attempt_start_s, time_over_force_limit_s, time_over_target_s, "
        "loop_rate_hz, deadline_misses, ticks) VALUES ('2023-01-01T00:00:00Z', 'c', 's', 'mouse', 'p', 1, 0, "
        "'[\"why\"]', 1.5, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 5000000000);";
    EXPECT_EQ(server().ask(setting, sql), "");
    Records records(RecordsLocation::parse(setting));
    const auto rows = records.newest(5);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].score.ticks, 5000000000LL);
    EXPECT_EQ(rows[0].score.reasons, std::vector<std::string>{"why"});
    EXPECT_EQ(rows[0].score.time_to_trachea_visible_s, -1.0);
    EXPECT_EQ(records.add(sample("2024-01-01T00:00:00Z")), rows[0].id + 1);
    EXPECT_EQ(server().ask(setting, "SELECT version FROM schema_version"), std::to_string(steps.size()) + "\n");
  }
}

TEST_F(PostgresServerTrouble, AConnectionThatIsCutIsMadeAnewAndNothingIsThereTwice) {
  Records records(location());
  for (int i = 0; i < 5; ++i) {
    server().ask(setting_,
                 "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE application_name = 'vallecula'");
    records.add(sample("2024-05-03T10:00:00Z"));
  }
  EXPECT_EQ(records.newest(100).size(), 5u);
  server().ask(setting_, "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE application_name = 'vallecula'");
  EXPECT_EQ(records.newest(100).size(), 5u);
}

TEST_F(PostgresServerTrouble, AServerThatLosesItsPowerHasWhatItSaidItHas) {
  Records records(location());
  for (int i = 0; i < 3; ++i) {
    records.add(sample("2024-05-03T10:00:00Z"));
    server().crash_and_restart();
  }
  records.add(sample("2024-05-03T10:00:00Z"));
  EXPECT_EQ(records.newest(100).size(), 4u);
}

TEST_F(PostgresServerTrouble, AServerThatStaysAwayIsAnErrorAfterAWait) {
  RecordsLocation there = location();
  there.patience_s = 0.3;
  Records records(there);
  records.add(sample("2024-05-03T10:00:00Z"));
  server().stop();
  const std::string error = error_of<RecordsError>([&] { records.add(sample("2024-05-04T10:00:00Z")); });
  EXPECT_NE(error.find("check that the server runs"), std::string::npos) << error;
  server().start();
  records.add(sample("2024-05-05T10:00:00Z"));
  EXPECT_EQ(records.newest(100).size(), 2u);
}

}  // namespace
}  // namespace vallecula::curricula::testing
