// Statements reach the store once each, whatever the store, the network and the sender do.
#include "curricula/export/delivery.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <thread>

#include "curricula/records/people.h"
#include "curricula/records/personal_data.h"
#include "tests/curricula/export/small_lrs.h"
#include "tests/curricula/temporary_folder.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

using Does = SmallLrs::Does;
constexpr std::size_t kStatementsOfATrial = 4;

class Deliveries : public TemporaryFolder {
 protected:
  void add_trials(int count) {
    for (int i = 0; i < count; ++i) {
      RecordRow row = sample("2026-05-03T10:20:30Z");
      row.scenario_id = "case-" + std::to_string(++added_);
      records().add(row);
    }
  }
  Records& records() {
    if (!records_) records_ = std::make_unique<Records>(folder_ / "records.sqlite");
    return *records_;
  }
  LrsSettings settings(double timeout_s = 5.0) const { return {lrs_.address(), "key", "s3cret", timeout_s}; }
  Delivery send(double timeout_s = 5.0) { return send_waiting(records(), settings(timeout_s), xapi_source(records())); }
  void expect_all_there(int trials) {
    EXPECT_EQ(lrs_.kept().size(), static_cast<std::size_t>(trials) * kStatementsOfATrial);
    EXPECT_EQ(waiting_statements(records()).waiting, 0);
    for (const std::string& offence : lrs_.offences()) ADD_FAILURE() << offence;
  }

  int argc_ = 1;
  char name_[5] = "test";
  char* argv_[2] = {name_, nullptr};
  QCoreApplication application_{argc_, argv_};
  SmallLrs lrs_;
  std::unique_ptr<Records> records_;
  int added_ = 0;
};

TEST_F(Deliveries, WhatAnAuthorTriedStaysHere) {
  RecordRow tried = sample("2026-05-03T10:20:30Z");
  tried.curriculum_id = "draft";
  records().add(tried);
  EXPECT_EQ(waiting_statements(records()).waiting, 0);
  EXPECT_EQ(send().sent, 0);
  EXPECT_EQ(lrs_.posts(), 0);
}

TEST_F(Deliveries, WhatWaitsIsSentOnceInBatches) {
  add_trials(45);
  EXPECT_EQ(waiting_statements(records()).waiting, 45);
  const Delivery first = send();
  EXPECT_EQ(first.sent, 45);
  EXPECT_EQ(first.left, 0);
  EXPECT_EQ(first.problem, "");
  EXPECT_EQ(lrs_.posts(), 3);
  expect_all_there(45);
  EXPECT_EQ(send().sent, 0);
  EXPECT_EQ(lrs_.posts(), 3) << "nothing is sent twice without need";
  send_all_again(records());
  EXPECT_EQ(send().sent, 45);
  expect_all_there(45);
}

TEST_F(Deliveries, NothingIsLostWhateverTheStoreDoes) {
  add_trials(3);
  for (const auto& [does, later] :
       {std::pair{Does::server_error, true}, std::pair{Does::too_many, true}, std::pair{Does::hangs, true},
        std::pair{Does::closes_half_way, true}, std::pair{Does::keeps_and_hangs, true},
        std::pair{Does::not_let_in, false}, std::pair{Does::elsewhere, false}, std::pair{Does::garbage, false}}) {
    SCOPED_TRACE(static_cast<int>(does));
    lrs_.does(does);
    const Delivery delivery = send(0.3);
    EXPECT_EQ(delivery.sent, 0);
    EXPECT_EQ(delivery.refused, 0);
    EXPECT_EQ(delivery.left, 3);
    EXPECT_EQ(delivery.again_later, later) << delivery.problem;
    EXPECT_NE(delivery.problem, "");
    EXPECT_EQ(delivery.problem.find("s3cret"), std::string::npos) << delivery.problem;
  }
  lrs_.does(Does::answers);
  EXPECT_EQ(send().sent, 3);
  expect_all_there(3);
}

TEST_F(Deliveries, AStoreThatIsNotThereIsTriedLater) {
  add_trials(1);
  LrsSettings nobody = settings();
  nobody.address = "http://127.0.0.1:1/xapi";
  const Delivery delivery = send_waiting(records(), nobody, xapi_source(records()));
  EXPECT_TRUE(delivery.again_later);
  EXPECT_EQ(delivery.left, 1);
}

TEST_F(Deliveries, WhatIsRefusedIsKeptAsideWithTheReasonAndTheOthersGo) {
  add_trials(9);
  lrs_.refuse("case-4");
  Delivery delivery = send();
  EXPECT_EQ(delivery.sent, 8);
  EXPECT_EQ(delivery.refused, 1);
  EXPECT_EQ(delivery.left, 0);
  const Waiting waiting = waiting_statements(records());
  EXPECT_EQ(waiting.refused, 1);
  EXPECT_NE(waiting.last_refusal.find("we do not like 'case-4' here"), std::string::npos) << waiting.last_refusal;
  EXPECT_EQ(send().refused, 0) << "not tried by itself";
  lrs_.refuse("");
  send_refused_again(records());
  EXPECT_EQ(send().sent, 1);
  expect_all_there(9);
}

TEST_F(Deliveries, AStoreThatRefusesEverythingIsNotUsed) {
  add_trials(2);
  lrs_.refuse("verbs/");
  const Delivery delivery = send();
  EXPECT_EQ(delivery.refused, 0);
  EXPECT_EQ(delivery.left, 2);
  EXPECT_FALSE(delivery.again_later);
  EXPECT_NE(delivery.problem.find("refuses every statement"), std::string::npos) << delivery.problem;
  EXPECT_EQ(waiting_statements(records()).refused, 0);
  lrs_.refuse("");
  EXPECT_EQ(send().sent, 2);
}

TEST_F(Deliveries, OneStatementOfATrialThatIsRefusedDoesNotKeepItsOthers) {
  add_trials(1);
  lrs_.refuse("verbs/completed");
  EXPECT_EQ(send().refused, 1);
  EXPECT_EQ(lrs_.kept().size(), 3u);
}

TEST_F(Deliveries, WhatAnotherVersionSentInOtherWordsIsThere) {
  add_trials(3);
  send();
  send_all_again(records());
  const XapiSource elsewhere{"https://another.example.org"};
  const Delivery delivery = send_waiting(records(), settings(), elsewhere);
  EXPECT_EQ(delivery.sent, 3) << "409 to each";
  EXPECT_EQ(delivery.refused, 0);
  expect_all_there(3);
}

TEST_F(Deliveries, SendingEndsWhenItIsAskedTo) {
  add_trials(1);
  lrs_.does(Does::hangs);
  std::atomic<bool> stop{false};
  std::thread asks([&] {
    while (lrs_.posts() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    stop = true;
  });
  const auto begun = std::chrono::steady_clock::now();
  const Delivery delivery = send_waiting(records(), settings(60.0), xapi_source(records()), &stop);
  asks.join();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(10));
  EXPECT_EQ(delivery.left, 1);
}

TEST_F(Deliveries, OfADeletedTraineeNothingWaitsAnyMore) {
  People people(records());
  const SignedIn doctor = people.create_first_instructor("doctor", "1234");
  const long long anna = people.register_trainee("anna", "2345");
  RecordRow row = sample("2026-05-03T10:20:30Z");
  row.trainee_id = anna;
  records().add(row);
  records().add(row);
  lrs_.refuse("case-1");
  send();
  records().add(row);
  EXPECT_EQ(waiting_statements(records()).waiting, 1);
  delete_person(records(), doctor, anna);
  EXPECT_EQ(waiting_statements(records()).waiting, 0);
}

TEST(LrsSettings, OnlyASafeAddressWithASecretIsTaken) {
  const auto refused = [](const std::string& address, const std::string& key = "k", const std::string& secret = "s3cret") {
    return error_of<RecordsError>([&] { checked({address, key, secret, 5.0}); });
  };
  for (const char* good : {"https://lrs.example.org/xapi", "http://127.0.0.1:8080/xapi/", "http://localhost/x",
                           "http://[::1]:80/x"})
    EXPECT_EQ(refused(good), "") << good;
  for (const char* bad : {"", "lrs.example.org", "ftp://lrs.example.org", "https://anna:x@lrs.example.org/xapi",
                          "https://lrs.example.org/xapi?a=b", "https://"})
    EXPECT_NE(refused(bad).find("[lrs] address"), std::string::npos) << bad;
  for (const char* open : {"http://lrs.example.org/xapi", "http://10.0.0.1/x", "http://127.0.0.1.example.org/x"})
    EXPECT_NE(refused(open).find("use https"), std::string::npos) << open;
  EXPECT_NE(refused("https://lrs.example.org", "", "s3cret").find("key or secret"), std::string::npos);
  EXPECT_EQ(refused("https://lrs.example.org", "", "s3cret").find("s3cret"), std::string::npos);
  EXPECT_EQ(checked({"https://lrs.example.org/xapi//", "k", "s", 5.0}).address, "https://lrs.example.org/xapi");
}

TEST(Pauses, GrowAndEnd) {
  EXPECT_EQ(pause_after_s(0), 0.0);
  EXPECT_EQ(pause_after_s(1), 2.0);
  EXPECT_EQ(pause_after_s(4), 16.0);
  EXPECT_EQ(pause_after_s(1000), 600.0);
}

}  // namespace
}  // namespace vallecula::curricula::testing
