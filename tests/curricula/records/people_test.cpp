#include "curricula/records/people.h"

#include <sodium.h>

#include <atomic>
#include <thread>

#include "curricula/records/pin.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

const Person* find(const std::vector<Person>& people, long long id) {
  for (const Person& person : people)
    if (person.id == id) return &person;
  return nullptr;
}

TEST_P(AnyRecords, TheFirstInstructorIsMadeOnceAndMakesTheOthers) {
  Records records(location());
  People people(records);
  EXPECT_FALSE(people.has_instructor());
  const long long trainee = people.register_trainee("  Kiwi ", "1234");
  EXPECT_FALSE(people.has_instructor());
  const SignedIn first = people.create_first_instructor("Dr. Grün", "secret 1");
  EXPECT_TRUE(people.has_instructor());
  EXPECT_NE(error_of<NotAllowed>([&] { people.create_first_instructor("Other", "4321"); }), "");

  const SignedIn kiwi = people.sign_in(trainee, "1234");
  EXPECT_NE(error_of<NotAllowed>([&] { people.create_instructor(kiwi, "Kiwi's friend", "4321"); }), "");
  const long long second = people.create_instructor(first, "Dr. Two", "4321");
  const auto list = people.list();
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(find(list, trainee)->name, "Kiwi");
  EXPECT_EQ(find(list, trainee)->role, Role::trainee);
  EXPECT_EQ(find(list, second)->role, Role::instructor);
  EXPECT_EQ(find(list, first.id())->name, "Dr. Grün");
}

TEST_P(AnyRecords, TwoStationsAtFirstUseMakeOneInstructor) {
  { Records records(location()); }
  std::atomic<int> made{0}, refused{0};
  std::vector<std::thread> stations;
  for (int i = 0; i < 4; ++i) {
    stations.emplace_back([&, i] {
      Records records(location());
      try {
        People(records).create_first_instructor("Station " + std::to_string(i), "4321");
        ++made;
      } catch (const NotAllowed&) {
        ++refused;
      }
    });
  }
  for (std::thread& station : stations) station.join();
  EXPECT_EQ(made, 1);
  EXPECT_EQ(refused, 3);
}

TEST_P(AnyRecords, APinIsKeptAsArgon2idAlone) {
  Records records(location());
  People people(records);
  const long long id = people.register_trainee("Kiwi", "correct horse");
  const std::string hash = ask("SELECT pin_hash FROM people");
  EXPECT_EQ(hash.rfind("$argon2id$", 0), 0u) << hash;
  // Asked of libsodium itself.
  char padded[crypto_pwhash_STRBYTES] = {};
  hash.copy(padded, sizeof padded - 1);
  EXPECT_EQ(crypto_pwhash_str_verify(padded, "correct horse", 13), 0);
  EXPECT_NE(crypto_pwhash_str_verify(padded, "correct hors", 12), 0);
  EXPECT_NE(hash_pin("correct horse"), hash) << "each has a salt of its own";
  people.change_pin(people.sign_in(id, "correct horse"), "correct horse", "another");
  EXPECT_NE(error_of<PinRefused>([&] { people.sign_in(id, "correct horse"); }), "");
  EXPECT_EQ(people.sign_in(id, "another").id(), id);
  const SignedIn who = people.sign_in(id, "another");
  EXPECT_NE(error_of<PinRefused>([&] { people.change_pin(who, "wrong", "third"); }), "");
}

TEST_P(AnyRecords, NamesAndPinsOutOfRangeAreRefusedAndNotRepeated) {
  Records records(location());
  People people(records);
  people.register_trainee("Kiwi", "1234");
  for (const std::string& name :
       {std::string(), std::string("   "), std::string("two\nlines"), std::string(101, 'x'),
        std::string("broken \xff\xfe"), std::string("nul\0l", 5), std::string("Kiwi"), std::string(" Kiwi ")}) {
    const std::string error = error_of<RecordsError>([&] { people.register_trainee(name, "1234"); });
    EXPECT_NE(error, "") << name;
    EXPECT_EQ(error.find("Kiwi"), std::string::npos) << error;
  }
  for (const std::string& pin : {std::string(), std::string("123"), std::string(65, '1')})
    EXPECT_NE(error_of<RecordsError>([&] { people.register_trainee("Emu", pin); }).find("4 to 64"), std::string::npos);
  people.register_trainee(std::string(100, 'x'), std::string(64, '1'));
  EXPECT_EQ(people.list().size(), 2u);
  EXPECT_NE(error_of<RecordsError>([&] { people.sign_in(77, "1234"); }), "");
}

TEST_P(AnyRecords, WrongPinsMakeOneWaitLongerEachTime) {
  long long now = 1'700'000'000'000;
  RecordsLocation there = location();
  there.clock_ms = [&now] { return now; };
  Records records(there);
  People people(records);
  const long long id = people.register_trainee("Kiwi", "1234");
  const auto wait = [&](const char* pin) {
    try {
      people.sign_in(id, pin);
      return -1.0;
    } catch (const PinRefused& refused) {
      return refused.wait_s;
    }
  };
  EXPECT_EQ(wait("0000"), 0.0);
  EXPECT_EQ(wait("0001"), 0.0);
  EXPECT_EQ(wait("0002"), 5.0);
  now += 4'000;
  EXPECT_EQ(wait("1234"), 1.0) << "the right one is not looked at either";
  EXPECT_EQ(wait("1234"), 1.0) << "and trying does not lengthen it";
  now += 1'000;
  EXPECT_EQ(wait("0003"), 10.0);
  now += 10'000;
  EXPECT_EQ(wait("0004"), 20.0);
  // Another program, another station: the same row.
  Records elsewhere(there);
  EXPECT_NE(error_of<PinRefused>([&] { People(elsewhere).sign_in(id, "1234"); }).find("wait 20 s"), std::string::npos);
  now += 20'000;
  EXPECT_EQ(wait("1234"), -1.0);
  EXPECT_EQ(wait("0000"), 0.0) << "a right one forgets the wrong ones";

  // At most a quarter of an hour.
  double longest = 0.0;
  for (int i = 0; i < 14; ++i) {
    longest = wait("9999");
    now += 15 * 60'000;
  }
  EXPECT_EQ(longest, 900.0);
  const SignedIn boss = people.create_first_instructor("Boss", "4321");
  now -= 15 * 60'000;
  EXPECT_GT(wait("1234"), 0.0);
  people.reset_pin(boss, id, "5678");
  EXPECT_EQ(wait("5678"), -1.0) << "a new PIN by an instructor ends the wait";
}

TEST_P(AnyRecords, AClockThatGoesBackShortensNoWait) {
  long long now = 1'700'000'000'000;
  RecordsLocation there = location();
  there.clock_ms = [&now] { return now; };
  Records records(there);
  People people(records);
  const long long id = people.register_trainee("Kiwi", "1234");
  const auto remaining = [&] {
    try {
      people.sign_in(id, "1234");
      return 0.0;
    } catch (const PinRefused& refused) {
      return refused.wait_s;
    }
  };
  for (int i = 0; i < 6; ++i) {
    EXPECT_NE(error_of<PinRefused>([&] { people.sign_in(id, "0000"); }), "");
    if (i < 5) now += 60'000;
  }
  EXPECT_EQ(remaining(), 40.0);
  now += 15'000;
  EXPECT_EQ(remaining(), 25.0);
  now -= 10'000;
  EXPECT_GE(remaining(), 25.0) << "back within the wait";
  now -= 365LL * 24 * 3600 * 1000;
  EXPECT_EQ(remaining(), 40.0) << "back by a year: anew, and no longer than the wait";
  now += 39'000;
  EXPECT_EQ(remaining(), 1.0);
  now += 1'000;
  EXPECT_EQ(remaining(), 0.0);
}

TEST_P(AnyRecords, ManyTriesAtOnceAreCountedEachBeforeItIsLookedAt) {
  RecordsLocation there = location();
  there.clock_ms = [] { return 1'700'000'000'000; };
  long long id = 0;
  {
    Records records(there);
    id = People(records).register_trainee("Kiwi", "1234");
  }
  std::atomic<int> looked_at{0}, turned_away{0};
  std::vector<std::thread> stations;
  for (int i = 0; i < 6; ++i) {
    stations.emplace_back([&] {
      Records records(there);
      try {
        People(records).sign_in(id, "0000");
      } catch (const PinRefused& refused) {
        (std::string(refused.what()).find("too many") == std::string::npos ? looked_at : turned_away)++;
      }
    });
  }
  for (std::thread& station : stations) station.join();
  EXPECT_EQ(looked_at, 3);
  EXPECT_EQ(turned_away, 3);
}

TEST_P(AnyRecords, OnlyAnInstructorDoesWhatIsAnInstructors) {
  Records records(location());
  People people(records);
  const SignedIn boss = people.create_first_instructor("Boss", "4321");
  const long long kiwi_id = people.register_trainee("Kiwi", "1234"), emu_id = people.register_trainee("Emu", "1234");
  const SignedIn kiwi = people.sign_in(kiwi_id, "1234");
  EXPECT_NE(error_of<NotAllowed>([&] { people.reset_pin(kiwi, emu_id, "0000"); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { people.reset_pin(kiwi, kiwi_id, "0000"); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { people.rename(kiwi, emu_id, "Stolen"); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { people.audit(kiwi, 10); }), "");
  EXPECT_EQ(people.sign_in(emu_id, "1234").id(), emu_id) << "nothing was done";
  people.rename(kiwi, kiwi_id, "Kiwi II");
  people.rename(boss, emu_id, "Emu II");
  EXPECT_NE(error_of<RecordsError>([&] { people.rename(boss, emu_id, "Kiwi II"); }).find("taken"), std::string::npos);
  EXPECT_EQ(find(people.list(), emu_id)->name, "Emu II");
}

TEST_P(AnyRecords, TheAuditTrailIsAppendOnlyAndNamesNobody) {
  Records records(location());
  People people(records);
  const SignedIn boss = people.create_first_instructor("Dr. Grün", "4321");
  const long long id = people.register_trainee("Kiwi", "1234");
  error_of<PinRefused>([&] { people.sign_in(id, "0000"); });
  people.sign_in(id, "1234");
  people.reset_pin(boss, id, "5678");
  const auto audit = people.audit(boss, 100);
  ASSERT_EQ(audit.size(), 5u);
  EXPECT_EQ(audit[0].action, "PIN reset");
  EXPECT_EQ(audit[0].actor_id, boss.id());
  EXPECT_EQ(audit[0].subject_id, id);
  EXPECT_EQ(audit[1].action, "signed in");
  EXPECT_EQ(audit[2].action, "wrong PIN");
  EXPECT_EQ(audit[2].actor_id, 0);
  EXPECT_EQ(audit[3].action, "trainee registered");
  EXPECT_EQ(audit[4].action, "first instructor created");
  for (const AuditEntry& entry : audit) EXPECT_EQ(entry.action.find("Kiwi") + 1 + entry.action.find("Grün") + 1, 0u);
  for (const char* sql : {"UPDATE audit SET action = 'nothing'", "DELETE FROM audit", "DELETE FROM audit WHERE id = 1"})
    EXPECT_NE(ask(sql).find("append only"), std::string::npos) << sql;
  EXPECT_EQ(ask("SELECT COUNT(*) FROM audit"), "5");
}

}  // namespace
}  // namespace vallecula::curricula::testing
