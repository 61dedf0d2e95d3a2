// `vallecula records`: tables, statements and pages of real trials, and their delivery, killed senders included.
#include <gtest/gtest.h>
#include <signal.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <sstream>
#include <thread>

#include "curricula/records/people.h"
#include "curricula/trial_log.h"
#include "gui/commands/headless_application.h"
#include "gui/session/statement_delivery.h"
#include "tests/curricula/export/small_lrs.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;
using curricula::testing::SmallLrs;
using Does = SmallLrs::Does;
using std::chrono::milliseconds;

constexpr std::size_t kStatementsOfATrial = 4;

class RecordsCommand : public ::testing::Test {
 protected:
  void do_trial(const std::string& out) {
    const Outcome done = box_.run({"trial", "--patient", patient_.string(), "--scenario", curriculum_.string() + ":plain",
                                   "--device", "scripted:" + press_.string(), "--headless", "--asap", "--out",
                                   (box_ / out).string()});
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }
  Outcome records(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "records");
    return box_.run(arguments);
  }
  Outcome exported(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "export");
    return records(arguments);
  }
  /// Exit code 2 for a wrong call, 1 for work that failed; one message, and it says this.
  void expect_refused(const Outcome& outcome, int exit_code, const std::string& message) {
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
    EXPECT_NE(outcome.messages()[0].find(message), std::string::npos) << outcome.err;
  }
  void set_lrs(const std::string& address) {
    write_text(box_.home() / "settings.ini", "[lrs]\naddress=" + address + "\nkey=key\nsecret=s3cret\n");
  }
  void wait_for(const std::function<bool()>& reached) {
    for (int i = 0; i < 2000 && !reached(); ++i) std::this_thread::sleep_for(milliseconds(5));
    ASSERT_TRUE(reached());
  }

  Sandbox box_;
  fs::path patient_ = write_block_patient(box_.folder());
  fs::path press_ = write_press(box_.folder());
  fs::path curriculum_ = write_curriculum(box_.folder());
};

TEST_F(RecordsCommand, HandsOutTablesAndStatementsOfATrial) {
  do_trial("one");
  const Outcome csv = exported({"--format", "csv"});
  ASSERT_EQ(csv.exit_code, 0) << csv.err;
  std::istringstream lines(csv.out);
  std::string head, row, none;
  std::getline(lines, head);
  std::getline(lines, row);
  EXPECT_FALSE(std::getline(lines, none));
  EXPECT_EQ(head.rfind("trial,trainee,station,", 0), 0u) << head;
  EXPECT_NE(row.find(",plain,scripted,practice,0,"), std::string::npos) << row;
  EXPECT_EQ(row.find(box_.folder().string()), std::string::npos) << "nobody's folders";

  ASSERT_EQ(exported({"--format", "csv", "--out", (box_ / "all.csv").string()}).exit_code, 0);
  EXPECT_EQ(text_of(box_ / "all.csv"), csv.out);

  const Outcome ticks = exported({"--format", "csv", "--trial", (box_ / "one").string()});
  ASSERT_EQ(ticks.exit_code, 0) << ticks.err;
  const auto log = curricula::read_trial_log(box_ / "one");
  EXPECT_EQ(std::count(ticks.out.begin(), ticks.out.end(), '\n'), static_cast<long>(log.ticks.size() + 1));

  const Outcome xapi = exported({"--format", "xapi", "--trial", (box_ / "one").string()});
  ASSERT_EQ(xapi.exit_code, 0) << xapi.err;
  const QJsonArray statements = QJsonDocument::fromJson(QByteArray::fromStdString(xapi.out)).array();
  ASSERT_EQ(statements.size(), static_cast<int>(kStatementsOfATrial));
  EXPECT_EQ(xapi.out, exported({"--format", "xapi"}).out);
  fs::rename(box_ / "one", box_ / "moved");
  EXPECT_EQ(exported({"--format", "xapi", "--trial", (box_ / "moved").string()}).out, xapi.out) << "it is the same trial";
  do_trial("two");  // the same to the byte, but another trial of the records
  write_text(box_ / "moved" / "trial.vtrial", "another");
  expect_refused(exported({"--format", "xapi", "--trial", (box_ / "moved").string()}), 1, "have no trial of yours there");
  const QJsonObject result = statements[2].toObject()["result"].toObject();
  EXPECT_TRUE(result["score"].toObject()["raw"].isDouble()) << xapi.out;
  EXPECT_EQ(records({"columns"}).out.rfind("| column |", 0), 0u);
}

TEST_F(RecordsCommand, NamesAndOthersTrialsAreForInstructors) {
  {
    curricula::Records kept(box_.home() / "records.sqlite");
    curricula::People people(kept);
    people.create_first_instructor("Doctor", "1234");
    const long long anna = people.register_trainee("Anna", "2345");
    curricula::RecordRow row;
    row.trainee_id = anna;
    row.finished_utc = "2026-05-03T10:20:30Z";
    row.curriculum_id = "c";
    row.scenario_id = "s";
    row.device_kind = "mouse";
    kept.add(row);
  }
  const auto with_pin = [&](const std::string& pin, const std::vector<std::string>& arguments) {
    write_text(box_ / "pin", pin + "\n");
    std::string command = "VALLECULA_HOME='" + box_.home().string() + "' '" + VALLECULA_BINARY_DIR + "/vallecula' records export";
    for (const std::string& argument : arguments) command += " '" + argument + "'";
    command += " < '" + (box_ / "pin").string() + "' > '" + (box_ / "said").string() + "' 2>&1";
    const int code = std::system(command.c_str());
    return std::pair{WEXITSTATUS(code), text_of(box_ / "said")};
  };
  EXPECT_EQ(exported({"--format", "csv"}).out.find("mouse"), std::string::npos) << "nobody's trials only";
  expect_refused(exported({"--format", "csv", "--trainee", "2"}), 1, "must sign in");
  const auto numbers = with_pin("1234", {"--format", "csv", "--sign-in", "Doctor"});
  EXPECT_EQ(numbers.first, 0) << numbers.second;
  EXPECT_NE(numbers.second.find("mouse"), std::string::npos);
  EXPECT_EQ(numbers.second.find("Anna"), std::string::npos);
  EXPECT_NE(with_pin("1234", {"--format", "csv", "--sign-in", "Doctor", "--names"}).second.find(",Anna,"),
            std::string::npos);
  EXPECT_EQ(with_pin("2345", {"--format", "csv", "--sign-in", "Anna", "--names"}).first, 1);
  const auto wrong = with_pin("9999", {"--format", "csv", "--sign-in", "Anna"});
  EXPECT_EQ(wrong.first, 1);
  EXPECT_EQ(wrong.second.find("9999"), std::string::npos);
}

TEST_F(RecordsCommand, WrongCallsAndFullDisksLeaveOneMessageAndNothingElse) {
  expect_refused(exported({"--format", "odt"}), 2, "--format");
  expect_refused(exported({"--format", "pdf", "--out", (box_ / "x.pdf").string()}), 2, "one --trial or of one --trainee");
  expect_refused(exported({"--format", "pdf", "--trial", "x"}), 2, "--out");
  expect_refused(exported({"--format", "csv", "--trial", "x", "--since", "2026"}), 2, "--trial");
  expect_refused(exported({"--format", "csv", "--names"}), 2, "--names");
  expect_refused(exported({"--format", "csv", "--since", "yesterday"}), 2, "--since");
  expect_refused(exported({"--format", "csv", "--until", "2026-05-03T10:00:00+02:00"}), 2, "--until");
  expect_refused(exported({"--format", "xapi", "--cmi5", "x"}), 2, "--cmi5");
  expect_refused(records({}), 2, "");
  expect_refused(exported({"--format", "csv", "--trial", (box_ / "none").string()}), 1, "none");
  expect_refused(records({"send"}), 1, "[lrs]");
  set_lrs("http://lrs.example.org/xapi");
  const Outcome open = records({"send"});
  expect_refused(open, 1, "use https");
  EXPECT_EQ(open.err.find("s3cret"), std::string::npos);
  do_trial("one");
  const Outcome full = box_.run_on_full_disk({"records", "export", "--format", "csv", "--trial", (box_ / "one").string(),
                                              "--out", (box_ / "ticks.csv").string()},
                                             100'000);
  expect_refused(full, 1, "ticks.csv");
  EXPECT_FALSE(fs::exists(box_ / "ticks.csv"));
  EXPECT_FALSE(fs::exists(box_ / "ticks.csv.part"));
}

TEST_F(RecordsCommand, PdfReportsHoldTheirText) {
  do_trial("one");
  const fs::path report = box_ / "one.pdf", nobody = box_ / "nobody.pdf";
  const Outcome one = exported({"--format", "pdf", "--trial", (box_ / "one").string(), "--out", report.string()});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const Outcome all = exported({"--format", "pdf", "--trainee", "0", "--out", nobody.string()});
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(text_of(report).rfind("%PDF-", 0), 0u);
  if (std::system("command -v pdftotext > /dev/null && command -v pdfinfo > /dev/null") != 0)
    GTEST_SKIP() << "pdftotext and pdfinfo are not there; packaging/setup installs them (poppler-utils)";
  const auto read_back = [&](const std::string& program, const fs::path& pdf) {
    const fs::path into = box_ / "read";
    EXPECT_EQ(std::system((program + " '" + pdf.string() + "' " + (program[3] == 't' ? "" : ">") + "'" + into.string() + "'").c_str()), 0);
    return text_of(into);
  };
  const std::string text = read_back("pdftotext -layout", report), facts = read_back("pdfinfo", report);
  for (const char* held : {"Page 1 of 2", "Page 2 of 2", "Why", "Figures", "Peak force on the tongue", "Over time",
                           "mark is validated", "not validated", "scripted"})
    EXPECT_NE(text.find(held), std::string::npos) << held << " in " << text;
  EXPECT_NE(facts.find("Pages:           2"), std::string::npos) << facts;
  EXPECT_NE(facts.find("(A4)"), std::string::npos) << facts;
  const std::string trainee = read_back("pdftotext -layout", nobody);
  for (const char* held :
       {"Trials of nobody", "By scenario and device", "Not counted", "Learning curves", "All trials", "plain"})
    EXPECT_NE(trainee.find(held), std::string::npos) << held << " in " << trainee;
}

TEST_F(RecordsCommand, ASenderThatIsKilledLosesNothingAndSendsNothingTwice) {
  do_trial("one");
  do_trial("two");
  SmallLrs lrs;
  set_lrs(lrs.address());
  for (const Does does : {Does::hangs, Does::keeps_and_hangs, Does::keeps_and_hangs}) {
    lrs.does(does);
    const int before = lrs.posts();
    const pid_t sender = box_.start({"records", "send"});
    wait_for([&] { return lrs.posts() > before; });
    ::kill(sender, SIGKILL);
    EXPECT_EQ(box_.wait(sender).exit_code, -1);
  }
  EXPECT_EQ(lrs.kept().size(), 2 * kStatementsOfATrial) << "it has them, and nobody knows";
  lrs.does(Does::server_error);
  const Outcome down = records({"send", "--tries", "1"});
  expect_refused(down, 1, "503");
  EXPECT_NE(down.out.find("0 trials sent, 2 left"), std::string::npos) << down.out;
  lrs.does(Does::answers);
  const Outcome up = records({"send"});
  EXPECT_EQ(up.exit_code, 0) << up.err;
  EXPECT_NE(up.out.find("2 trials sent, 0 left, 0 refused"), std::string::npos) << up.out;
  EXPECT_EQ(lrs.kept().size(), 2 * kStatementsOfATrial);
  EXPECT_NE(records({"send"}).out.find("0 trials sent, 0 left"), std::string::npos);
  for (const std::string& offence : lrs.offences()) ADD_FAILURE() << offence;
}

TEST_F(RecordsCommand, TheWindowsSenderSendsWhatATrialLeftAndEndsAtOnce) {
  do_trial("one");
  SmallLrs lrs;
  lrs.does(Does::hangs);
  const char* before = std::getenv("VALLECULA_HOME");
  const std::string home = before != nullptr ? before : "";
  ::setenv("VALLECULA_HOME", box_.home().c_str(), 1);
  {
    const HeadlessApplication application;
    { const StatementDelivery without_address; }
    set_lrs(lrs.address());
    auto delivery = std::make_unique<StatementDelivery>();
    wait_for([&] { return lrs.posts() == 1; });
    const auto begun = std::chrono::steady_clock::now();
    delivery.reset();  // though the store says nothing for half a minute
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
    lrs.does(Does::answers);
    delivery = std::make_unique<StatementDelivery>();
    wait_for([&] { return lrs.kept().size() == kStatementsOfATrial; });
    do_trial("two");
    delivery->wake();
    wait_for([&] { return lrs.kept().size() == 2 * kStatementsOfATrial; });
  }
  ::setenv("VALLECULA_HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace vallecula::gui::test
