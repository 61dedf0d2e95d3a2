#include "curricula/records/ratings.h"

#include <cmath>

#include "curricula/records/personal_data.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

struct Raters {
  explicit Raters(const RecordsLocation& location) : records(location), people(records), ratings(records) {
    boss = people.create_first_instructor("Boss", "4321");
    kiwi = people.sign_in(people.register_trainee("Kiwi", "1234"), "1234");
    emu = people.sign_in(people.register_trainee("Emu", "1234"), "1234");
    RecordRow row = sample("2024-05-01T10:00:00Z");
    row.trainee_id = kiwi->id();
    row.uid = "";
    trial = records.add(row);
    row.trainee_id = 0;
    nobodys = records.add(row);
  }
  Records records;
  People people;
  Ratings ratings;
  Who boss, kiwi, emu;
  long long trial = 0, nobodys = 0;
};

TEST_P(AnyRecords, TheOwnRatingIsGivenOnceAndByTheTraineeAlone) {
  Raters all(location());
  all.ratings.add(all.kiwi, all.trial, {"self", kGlobalRating, 4.0});
  all.ratings.add(all.kiwi, all.trial, {"self", kGlobalRating, 4.0});  // the answer to the first try was lost
  EXPECT_NE(error_of<RecordsError>([&] {
              all.ratings.add(all.kiwi, all.trial, {"self", kGlobalRating, 5.0});
            }).find("it stays"),
            std::string::npos);
  for (const Who& who : {all.boss, all.emu, Who()})
    EXPECT_NE(error_of<NotAllowed>([&] { all.ratings.add(who, all.trial, {"self", "tube_held", 1.0}); }), "");
  all.ratings.add({}, all.nobodys, {"self", kGlobalRating, 2.0});
  const auto given = all.ratings.of_trial(all.kiwi, all.trial);
  ASSERT_EQ(given.size(), 1u);
  EXPECT_EQ(given[0].by, "self");
  EXPECT_EQ(given[0].item, "global");
  EXPECT_EQ(given[0].value, 4.0);
  EXPECT_EQ(given[0].author_id, all.kiwi->id());
  EXPECT_EQ(given[0].at_utc.size(), 20u);
  EXPECT_EQ(all.ratings.of_trial({}, all.nobodys)[0].author_id, 0);
  EXPECT_NE(error_of<NotAllowed>([&] { all.ratings.of_trial(all.emu, all.trial); }), "");
}

TEST_P(AnyRecords, EachInstructorHasOneRatingOfAnItemTheirNewest) {
  Raters all(location());
  const Who second = all.people.sign_in(all.people.create_instructor(*all.boss, "Second", "4321"), "4321");
  all.ratings.add(all.boss, all.trial, {"instructor", "tube_held", 1.0});
  all.ratings.add(second, all.trial, {"instructor", "tube_held", 0.0});
  all.ratings.add(all.boss, all.trial, {"instructor", "tube_held", 0.0});
  all.ratings.add(all.boss, all.trial, {"instructor", kGlobalRating, 3.5});
  EXPECT_EQ(all.ratings.of_trial(all.boss, all.trial).size(), 3u);
  for (const Who& who : {all.kiwi, Who()})
    EXPECT_NE(error_of<NotAllowed>([&] { all.ratings.add(who, all.trial, {"instructor", "tube_held", 1.0}); }), "");
  EXPECT_EQ(all.people.audit(*all.boss, 1)[0].action, "trial rated");
  EXPECT_EQ(all.people.audit(*all.boss, 1)[0].subject_id, all.kiwi->id());

  delete_person(all.records, *all.boss, all.boss->id());
  const auto kept = all.ratings.of_trial(second, all.trial);
  ASSERT_EQ(kept.size(), 3u) << "an instructor's judgement is the trainee's to keep";
  EXPECT_EQ(kept[1].author_id, 0);
  delete_person(all.records, *second, all.kiwi->id());
  EXPECT_EQ(ask("SELECT COUNT(*) FROM ratings"), "0");
  EXPECT_EQ(ask("SELECT COUNT(DISTINCT trial_id) FROM figures"), "1") << "nobody's trial keeps its own";
}

TEST_P(AnyRecords, ATrialIsRatedByItsUidAsWellAndARatingOutOfRangeIsRefused) {
  Raters all(location());
  const std::string uid = all.records.newest(1)[0].uid;
  all.ratings.add({}, uid, {"self", kGlobalRating, 1.0});
  EXPECT_EQ(all.ratings.of_trial({}, all.nobodys).size(), 1u);
  EXPECT_NE(error_of<RecordsError>([&] { all.ratings.add({}, "no such uid", {"self", "x", 1.0}); }), "");
  for (const Rating& bad : {Rating{"self", kGlobalRating, 0.5}, Rating{"self", kGlobalRating, 5.5},
                            Rating{"self", kGlobalRating, std::nan("")}, Rating{"self", "item", 0.5},
                            Rating{"self", "", 1.0}, Rating{"somebody", "item", 1.0}})
    EXPECT_NE(error_of<RecordsError>([&] { all.ratings.add({}, uid, bad); }), "") << bad.item << bad.value;
}

}  // namespace
}  // namespace vallecula::curricula::testing
