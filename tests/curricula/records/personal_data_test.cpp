#include "curricula/records/personal_data.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <fstream>
#include <iterator>

#include "curricula/records/notes.h"
#include "curricula/records/progress.h"
#include "curricula/records/ratings.h"
#include "curricula/records/recovery.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Desk {
  Desk(const RecordsLocation& location, const fs::path& at) : records(location), people(records), folder(at) {
    boss = people.create_first_instructor("Boss", "4321");
    kiwi_id = people.register_trainee("Kiwi Kiwison", "1234");
    emu_id = people.register_trainee("Emu", "1234");
    kiwi = people.sign_in(kiwi_id, "1234");
  }
  long long trial(long long trainee, const std::string& name, const std::string& bytes) {
    const fs::path log = folder / name / "trial.vtrial";
    put(log, bytes);
    put(folder / name / "report.html", "report of " + bytes);
    RecordRow row = sample("2024-05-01T10:00:00Z");
    row.trainee_id = trainee;
    row.trial_path = log.string();
    row.log_sha256 = log_sha256(log);
    return records.add(row);
  }
  Records records;
  People people;
  fs::path folder;
  Who boss, kiwi;
  long long kiwi_id = 0, emu_id = 0;
};

TEST_P(AnyRecords, ATraineeTakesAllOwnDataAlong) {
  Desk desk(at_station("here"), folder_);
  const long long first = desk.trial(desk.kiwi_id, "first", "log one");
  const long long second = desk.trial(desk.kiwi_id, "second", "log two");
  const long long replaced = desk.trial(desk.kiwi_id, "third", "log three");
  desk.trial(desk.emu_id, "third", "somebody else's log");
  put(folder_ / "second" / "operator-1.png", "picture");
  put(folder_ / "second" / "holiday.png", "not ours");
  Notes(desk.records).add(desk.boss, first, 2.5, "lift, do not lever");
  Ratings(desk.records).add(desk.boss, first, {"instructor", kGlobalRating, 3.0});
  fs::remove(folder_ / "first" / "trial.vtrial");

  const fs::path out = folder_ / "mine";
  export_person(desk.records, *desk.kiwi, desk.kiwi_id, out);
  const std::string text = bytes_of(out / "records.json");
  const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
  EXPECT_EQ(all["person"].toObject()["name"].toString(), "Kiwi Kiwison");
  ASSERT_EQ(all["trials"].toArray().size(), 3);
  const QJsonObject gone = all["trials"].toArray()[0].toObject(), there = all["trials"].toArray()[1].toObject(),
                    taken = all["trials"].toArray()[2].toObject();
  EXPECT_EQ(there["id"].toInt(), second);
  EXPECT_EQ(there["peak_tongue_force_n"].toDouble(), 5.1234567890123456);
  EXPECT_EQ(there["reasons"].toArray().size(), 2);
  EXPECT_EQ(there["outcome"], QJsonValue());
  EXPECT_EQ(there["files"].toArray().size(), 3);
  EXPECT_EQ(gone["files"].toArray().size(), 0);
  EXPECT_NE(gone["files_missing"].toString(), "");
  EXPECT_EQ(taken["id"].toInt(), replaced);
  EXPECT_TRUE(taken["files_missing"].toString().contains("replaced"));
  EXPECT_EQ(all["notes"].toArray()[0].toObject()["text"].toString(), "lift, do not lever");
  EXPECT_EQ(all["ratings"].toArray()[0].toObject()["value"].toDouble(), 3.0);
  EXPECT_EQ(all["figures"].toArray()[0].toObject()["trial_id"].toInt(), first);
  EXPECT_EQ(all["figures"].toArray().last().toObject()["trial_id"].toInt(), replaced);
  EXPECT_GE(all["audit"].toArray().size(), 2);
  EXPECT_EQ(text.find("argon2"), std::string::npos);
  EXPECT_EQ(text.find("Emu"), std::string::npos);

  const fs::path files = out / "trials" / std::to_string(second);
  EXPECT_EQ(bytes_of(files / "trial.vtrial"), "log two");
  EXPECT_EQ(bytes_of(files / "report.html"), "report of log two");
  EXPECT_EQ(bytes_of(files / "operator-1.png"), "picture");
  EXPECT_FALSE(fs::exists(files / "holiday.png"));
  EXPECT_FALSE(fs::exists(out / "trials" / std::to_string(replaced)));

  EXPECT_NE(error_of<RecordsError>([&] { export_person(desk.records, *desk.kiwi, desk.kiwi_id, out); }).find("exists"),
            std::string::npos);
  EXPECT_NE(error_of<NotAllowed>([&] { export_person(desk.records, *desk.kiwi, desk.emu_id, folder_ / "x"); }), "");
  EXPECT_FALSE(fs::exists(folder_ / "x"));
  put(folder_ / "emu.part" / "thesis.txt", "nobody's business");
  export_person(desk.records, *desk.boss, desk.emu_id, folder_ / "emu");
  EXPECT_TRUE(fs::exists(folder_ / "emu" / "records.json"));
  EXPECT_EQ(bytes_of(folder_ / "emu.part" / "thesis.txt"), "nobody's business");
}

TEST_P(AnyRecords, ATraineeIsDeletedWholeAndNobodyElseIsTouched) {
  Desk desk(at_station("here"), folder_);
  const long long own = desk.trial(desk.kiwi_id, "first", "log one");
  desk.trial(desk.kiwi_id, "second", "log two");
  desk.trial(desk.kiwi_id, "shared", "log three");
  const long long emus = desk.trial(desk.emu_id, "shared", "emu's log");
  put(folder_ / "second" / "holiday.png", "not ours");
  Notes notes(desk.records);
  notes.add(desk.kiwi, own, 1.0, "by the trainee");
  notes.add(desk.boss, own, 2.0, "by the instructor");
  notes.add(desk.boss, emus, 2.0, "emu's");
  const OpenTrial under_way{"",          "2024-05-03T09:59:00Z", "c", "s", "mouse", folder_ / "fourth" / "trial.vtrial",
                            desk.kiwi_id};
  const std::string uid = desk.records.begin(under_way);
  put(folder_ / "fourth" / "trial.vtrial", "cut off");

  EXPECT_NE(error_of<NotAllowed>([&] { delete_person(desk.records, *desk.kiwi, desk.emu_id); }), "");
  const Deletion deletion = delete_person(desk.records, *desk.kiwi, desk.kiwi_id);
  EXPECT_EQ(deletion.trials, 3);
  EXPECT_EQ(deletion.notes, 2);
  EXPECT_EQ(deletion.files, 5);
  EXPECT_TRUE(deletion.left.empty());
  EXPECT_FALSE(fs::exists(folder_ / "first"));
  EXPECT_FALSE(fs::exists(folder_ / "fourth"));
  EXPECT_EQ(bytes_of(folder_ / "second" / "holiday.png"), "not ours");
  EXPECT_FALSE(fs::exists(folder_ / "second" / "trial.vtrial"));
  EXPECT_EQ(bytes_of(folder_ / "shared" / "trial.vtrial"), "emu's log");

  EXPECT_EQ(ask("SELECT COUNT(*) FROM trials"), "1");
  EXPECT_EQ(ask("SELECT COUNT(*) FROM notes"), "1");
  EXPECT_EQ(ask("SELECT COUNT(*) FROM open_trials"), "0");
  EXPECT_EQ(ask("SELECT COUNT(*) FROM people WHERE name LIKE 'Kiwi%'"), "0");
  EXPECT_EQ(ask("SELECT COUNT(*) FROM files_to_delete"), "0");
  const auto audit = desk.people.audit(*desk.boss, 1);
  EXPECT_EQ(audit[0].action, "person deleted");
  EXPECT_EQ(audit[0].subject_id, desk.kiwi_id);
  EXPECT_NE(error_of<RecordsError>([&] { desk.people.sign_in(desk.kiwi_id, "1234"); }), "");
  EXPECT_NE(error_of<NotAllowed>([&] { Progress(desk.records).curves(desk.kiwi, 0 + desk.emu_id); }).find("deleted"),
            std::string::npos);
  EXPECT_GT(desk.people.register_trainee("Kiwi again", "1234"), desk.emu_id) << "a number is never given twice";
  // Whose trial runs on while it is deleted is told so, and no row comes back.
  RecordRow row = sample("2024-05-03T10:00:00Z");
  row.uid = uid;
  row.trainee_id = desk.kiwi_id;
  EXPECT_NE(error_of<RecordsError>([&] { desk.records.add(row); }).find("deleted meanwhile"), std::string::npos);
  if (!on_server()) {  // not even in what the file has free
    EXPECT_EQ(bytes_of(setting_).find("Kiwi Kiwison"), std::string::npos);
    EXPECT_EQ(bytes_of(setting_ + "-wal").find("Kiwi Kiwison"), std::string::npos);
  }
}

/// Its path once was another trainee's, whose log was removed when it began.
TEST_P(AnyRecords, WhatADeletedTraineesCutOffTrialLeftGoes) {
  Desk desk(at_station("here"), folder_);
  desk.trial(desk.emu_id, "again", "emu's log");
  fs::remove(folder_ / "again" / "trial.vtrial");
  desk.records.begin({"", "2024-05-03T09:59:00Z", "c", "s", "mouse", folder_ / "again" / "trial.vtrial", desk.kiwi_id});
  put(folder_ / "again" / "trial.vtrial.part", "cut off");
  put(folder_ / "again" / "replay-3s.png", "a picture of it");
  desk.trial(desk.emu_id, "beside", "emu's log");
  desk.records.begin({"", "2024-05-03T09:59:00Z", "c", "s", "mouse", folder_ / "beside" / "trial.vtrial", desk.kiwi_id});
  put(folder_ / "beside" / "trial.vtrial.part", "cut off");
  EXPECT_TRUE(delete_person(desk.records, *desk.kiwi, desk.kiwi_id).left.empty());
  EXPECT_FALSE(fs::exists(folder_ / "again"));
  EXPECT_FALSE(fs::exists(folder_ / "beside" / "trial.vtrial.part"));
  EXPECT_EQ(bytes_of(folder_ / "beside" / "trial.vtrial"), "emu's log");
}

TEST_P(AnyRecords, FilesOnADiskThatIsNotThereAreDeletedWhenItIs) {
  Desk desk(at_station("here"), folder_);
  desk.trial(desk.kiwi_id, "first", "log one");
  fs::rename(folder_ / "first", folder_ / "unplugged");
  const Deletion deletion = delete_person(desk.records, *desk.kiwi, desk.kiwi_id);
  ASSERT_EQ(deletion.left.size(), 1u);
  EXPECT_EQ(deletion.left[0].find(folder_.string()), std::string::npos) << deletion.left[0];
  EXPECT_EQ(ask("SELECT COUNT(*) FROM files_to_delete"), "1");
  fs::rename(folder_ / "unplugged", folder_ / "first");
  EXPECT_EQ(delete_pending_files(desk.records).files, 2);
  EXPECT_FALSE(fs::exists(folder_ / "first"));
}

TEST_P(AnyRecords, AWriteAheadLogThatAnotherReadsIsReported) {
  if (on_server()) return;
  RecordsLocation here = at_station("here");
  here.patience_s = 0.2;
  Desk desk(here, folder_);
  {
    QSqlDatabase reader = QSqlDatabase::addDatabase("QSQLITE", "reader");
    reader.setDatabaseName(QString::fromStdString(setting_));
    ASSERT_TRUE(reader.open());
    QSqlQuery view(reader);
    ASSERT_TRUE(view.exec("BEGIN") && view.exec("SELECT COUNT(*) FROM people") && view.next());
    const Deletion deletion = delete_person(desk.records, *desk.kiwi, desk.kiwi_id);
    ASSERT_EQ(deletion.left.size(), 1u);
    EXPECT_NE(deletion.left[0].find("write-ahead log"), std::string::npos);
  }
  QSqlDatabase::removeDatabase("reader");
}

TEST_P(AnyRecords, FilesOnAnotherStationGoWhenThatOneStarts) {
  Desk desk(at_station("there"), folder_);
  desk.trial(desk.kiwi_id, "first", "log one");
  Records here(at_station("here"));
  const Deletion deletion = delete_person(here, *desk.boss, desk.kiwi_id);
  EXPECT_EQ(deletion.files, 0);
  EXPECT_TRUE(fs::exists(folder_ / "first" / "trial.vtrial"));
  EXPECT_EQ(delete_pending_files(here).files, 0);
  EXPECT_EQ(delete_pending_files(desk.records).files, 2);
  EXPECT_FALSE(fs::exists(folder_ / "first"));
  EXPECT_EQ(ask("SELECT COUNT(*) FROM files_to_delete"), "0");
}

TEST_P(AnyRecords, TheLastInstructorStaysWhileThereAreOthers) {
  Desk desk(location(), folder_);
  EXPECT_NE(error_of<NotAllowed>([&] { delete_person(desk.records, *desk.boss, desk.boss->id()); }), "");
  const long long second = desk.people.create_instructor(*desk.boss, "Second", "4321");
  const long long trial = desk.trial(desk.kiwi_id, "first", "log");
  Notes(desk.records).add(desk.boss, trial, 1.0, "kept");
  delete_person(desk.records, *desk.boss, desk.boss->id());
  const auto notes = Notes(desk.records).of_trial(desk.kiwi, trial);
  ASSERT_EQ(notes.size(), 1u) << "the trainee's note to keep";
  EXPECT_EQ(notes[0].author_id, 0);
  const SignedIn boss = desk.people.sign_in(second, "4321");
  delete_person(desk.records, boss, desk.kiwi_id);
  delete_person(desk.records, boss, desk.emu_id);
  delete_person(desk.records, boss, second);
  EXPECT_FALSE(desk.people.has_instructor());
}

}  // namespace
}  // namespace vallecula::curricula::testing
