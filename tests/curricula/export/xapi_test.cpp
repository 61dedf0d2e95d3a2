// Statements keep the published rules, whatever the trial was; the checker of the rules finds what is wrong.
#include "curricula/export/xapi.h"

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <random>

#include "curricula/score/figures.h"
#include "tests/curricula/export/xapi_rules.h"
#include "tests/curricula/records/any_records.h"

namespace vallecula::curricula::testing {
namespace {

const XapiSource kSource{"https://training.example.org/vallecula"};
const std::string kActor = R"({"objectType":"Agent","account":{"homePage":"https://lms.example.org","name":"1625378"}})";
const std::string kRegistration = "760e3480-ba55-4991-94b0-01820dbd23a2";
const std::string kActivity = "https://lms.example.org/au/17";
const std::string kTemplate =
    R"({"extensions":{"https://w3id.org/xapi/cmi5/context/extensions/sessionid":"s-1","https://lms.example.org/x":5},)"
    R"("contextActivities":{"grouping":[{"id":"https://publisher.example.org/au"}]}})";

std::string launch_file(const std::string& more_of_data, const std::string& more = "") {
  return R"({"actor":)" + kActor + R"(,"registration":")" + kRegistration + R"(","activityId":")" + kActivity +
         R"(","launchData":{"contextTemplate":)" + kTemplate + more_of_data + "}" + more + "}";
}
Cmi5Launch launch(const std::string& more_of_data = "", const std::string& more = "") {
  return read_cmi5_launch(launch_file(R"(,"launchMode":"Normal")" + more_of_data, more));
}

RecordRow trial() {
  RecordRow row = sample("2026-05-03T10:20:30Z");
  row.id = 17;
  row.uid = "0123456789abcdef0123456789abcdef";
  row.trainee_id = 4;
  row.started_utc = "2026-05-03T10:19:50Z";
  row.module_id = "the-view";
  row.mode = Mode::assessment;
  row.attempt_seed = 4294967295u;
  row.duration_s = 38.126;
  row.points = 62.5;
  row.figures = {{"passed", 1.0}, {"peak_tongue_force_n", 5.125}};
  return row;
}

std::vector<QJsonObject> objects(const std::vector<XapiStatement>& statements) {
  std::vector<QJsonObject> all;
  for (const XapiStatement& one : statements) {
    all.push_back(QJsonDocument::fromJson(QByteArray::fromStdString(one.json)).object());
    EXPECT_EQ(all.back()["id"].toString().toStdString(), one.id);
    EXPECT_EQ(one.json.find('\n'), std::string::npos);
  }
  return all;
}

std::vector<std::string> verbs(const std::vector<QJsonObject>& statements) {
  std::vector<std::string> all;
  for (const QJsonObject& one : statements)
    all.push_back(one["verb"].toObject()["id"].toString().section('/', -1).toStdString());
  return all;
}

void expect_by_the_rules(const std::vector<QJsonObject>& session, bool defined) {
  std::vector<std::string> offences = cmi5_offences(session, defined);
  for (const QJsonObject& one : session)
    for (const std::string& offence : xapi_offences(one)) offences.push_back(offence);
  for (const std::string& offence : offences) ADD_FAILURE() << offence;
}

using Verbs = std::vector<std::string>;

TEST(Xapi, ATrialIsASessionWithItsPoints) {
  const auto session = objects(statements_of(trial(), kSource));
  expect_by_the_rules(session, false);
  ASSERT_EQ(verbs(session), (Verbs{"initialized", "completed", "passed", "terminated"}));
  const QJsonObject passed = session[2], result = passed["result"].toObject(), score = result["score"].toObject();
  EXPECT_EQ(score["scaled"].toDouble(), 0.625);
  EXPECT_EQ(score["raw"].toInt(), 63);
  EXPECT_EQ(result["duration"].toString(), "PT38.13S");
  EXPECT_EQ(session[0]["timestamp"].toString(), "2026-05-03T10:19:50.000Z");
  EXPECT_EQ(session[3]["timestamp"].toString(), "2026-05-03T10:20:30.000Z");
  EXPECT_EQ(passed["actor"].toObject()["account"].toObject()["name"].toString(), "trainee-4");
  EXPECT_EQ(passed["object"].toObject()["definition"].toObject()["type"].toString(),
            "http://adlnet.gov/expapi/activities/simulation");
  const QJsonObject context = passed["context"].toObject(), extensions = context["extensions"].toObject();
  EXPECT_EQ(context["platform"].toString(), "Vallecula");
  EXPECT_EQ(extensions["https://vallecula.invalid/xapi/device-kind"].toString(), "mouse");
  EXPECT_EQ(extensions["https://vallecula.invalid/xapi/mode"].toString(), "assessment");
  EXPECT_EQ(extensions["https://vallecula.invalid/xapi/seed"].toDouble(), 4294967295.0);
  const QJsonObject parent = context["contextActivities"].toObject()["parent"].toArray()[0].toObject();
  EXPECT_EQ(parent["id"].toString(), "https://vallecula.invalid/xapi/curricula/first-steps/modules/the-view");
  EXPECT_EQ(result["extensions"].toObject()["https://vallecula.invalid/xapi/figures/peak_tongue_force_n"].toDouble(),
            5.125);
}

TEST(Xapi, IdsAreTheTrialsOwnAndStayTheSame) {
  const auto once = statements_of(trial(), kSource), twice = statements_of(trial(), kSource);
  RecordRow other = trial();
  other.uid = "0123456789abcdef0123456789abcdee";
  const auto others = statements_of(other, kSource);
  std::set<std::string> ids;
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].json, twice[i].json);
    ids.insert(once[i].id);
    ids.insert(others[i].id);
  }
  EXPECT_EQ(ids.size(), 8u);
}

TEST(Xapi, EveryTrialThatTheRecordsMayHoldKeepsTheRules) {
  std::mt19937 draw(7);
  const auto coin = [&draw] { return draw() % 2 == 0; };
  int failed = 0, cut_off = 0;
  for (int i = 0; i < 500; ++i) {
    RecordRow row = trial();
    row.uid = coin() ? std::to_string(i) : "";
    row.trainee_id = coin() ? 0 : i;
    row.score.complete = draw() % 4 != 0;
    row.score.passed = coin();
    row.points = coin() ? std::optional(static_cast<double>(draw() % 10001) / 100.0) : std::nullopt;
    row.duration_s = coin() ? std::optional(static_cast<double>(draw() % 900000) / 1000.0) : std::nullopt;
    if (coin()) row.started_utc.clear();
    if (coin()) row.started_utc = "2026-05-03T11:00:00+02:00";
    if (draw() % 5 == 0) row.started_utc = "2027-01-01T00:00:00Z";  // the clock went back
    row.curriculum_id = coin() ? "a-course" : "an older; odd/id ü";
    if (coin()) row.module_id.clear();
    if (coin()) row.score.intubation.emplace().outcome = Outcome::mainstem;
    failed += row.score.complete && !row.score.passed ? 1 : 0;
    cut_off += row.score.complete ? 0 : 1;
    const auto session = objects(statements_of(row, kSource));
    expect_by_the_rules(session, false);
    EXPECT_EQ(session.size(), row.score.complete ? 4u : 2u) << "a trial that was cut off is neither completed nor judged";
    Cmi5Launch launched = launch(coin() ? R"(,"masteryScore":0.8)" : "");
    launched.judged = coin();
    expect_by_the_rules(objects(statements_of(row, kSource, launched)), true);
    if (HasFailure()) break;
  }
  EXPECT_GT(failed, 50);
  EXPECT_GT(cut_off, 50);
}

TEST(Xapi, NoResearchersFigureAndNoNameGoesOut) {
  RecordRow row = trial();
  for (const Figure& figure : figures()) row.figures[figure.name] = 1.5;
  std::string all;
  for (const XapiStatement& one : statements_of(row, kSource)) all += one.json;
  for (const Figure& figure : figures()) {
    const bool told = all.find(std::string("figures/") + figure.name + "\"") != std::string::npos;
    EXPECT_EQ(told, !figure.for_researchers && std::string(figure.name) != "passed") << figure.name;
  }
  EXPECT_EQ(all.find("mbox"), std::string::npos);
  EXPECT_EQ(all.find(row.trial_path), std::string::npos);
}

TEST(Xapi, ALaunchGivesActorActivityRegistrationAndContext) {
  const auto session = objects(statements_of(trial(), kSource, launch()));
  expect_by_the_rules(session, true);
  for (const QJsonObject& one : session) {
    EXPECT_EQ(one["actor"].toObject()["account"].toObject()["name"].toString(), "1625378");
    EXPECT_EQ(one["object"].toObject()["id"].toString().toStdString(), kActivity);
    const QJsonObject context = one["context"].toObject();
    EXPECT_EQ(context["registration"].toString().toStdString(), kRegistration);
    EXPECT_EQ(context["extensions"].toObject()["https://lms.example.org/x"].toInt(), 5);
    EXPECT_EQ(context["contextActivities"].toObject()["grouping"].toArray()[0].toObject()["id"].toString(),
              "https://publisher.example.org/au");
  }
  EXPECT_NE(session[0]["id"], objects(statements_of(trial(), kSource))[0]["id"]);
}

TEST(Xapi, AMasteryScoreIsAskedBesidesThePassMarks) {
  RecordRow row = trial();  // passed, with 62.5 points
  EXPECT_EQ(verbs(objects(statements_of(row, kSource, launch(R"(,"masteryScore":0.63)"))))[2], "failed");
  EXPECT_EQ(verbs(objects(statements_of(row, kSource, launch(R"(,"masteryScore":0.625)"))))[2], "passed");
  row.score.passed = false;
  const auto enough = objects(statements_of(row, kSource, launch(R"(,"masteryScore":0.6)")));
  EXPECT_EQ(verbs(enough)[2], "failed") << "points enough, but a pass mark was not met";
  EXPECT_FALSE(enough[2]["result"].toObject().contains("score")) << "cmi5: it would have to be below the mastery score";
  expect_by_the_rules(enough, true);
  const auto too_few = objects(statements_of(row, kSource, launch(R"(,"masteryScore":0.63)")));
  EXPECT_EQ(too_few[2]["result"].toObject()["score"].toObject()["scaled"].toDouble(), 0.625);
  EXPECT_EQ(verbs(objects(statements_of(row, kSource, launch())))[2], "failed");
}

TEST(Xapi, WhatTheRegistrationHasAlreadyIsLeftOut) {
  RecordRow row = trial();
  row.score.passed = false;
  EXPECT_EQ(verbs(objects(statements_of(row, kSource, launch("", R"(,"recorded":["completed","passed"])")))),
            (Verbs{"initialized", "terminated"}))
      << "no failed after a passed";
  const std::string browse = launch_file(R"(,"launchMode":"Browse")");
  EXPECT_EQ(verbs(objects(statements_of(row, kSource, read_cmi5_launch(browse)))), (Verbs{"initialized", "terminated"}));
}

TEST(Xapi, ALaunchThatLacksSomethingIsRefusedByItsName) {
  const auto refused = [](std::string json, const std::string& from, const std::string& to) {
    const std::size_t at = json.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    json.replace(at, from.size(), to);
    return error_of<RecordsError>([&] { read_cmi5_launch(json); });
  };
  const std::string good = launch_file(R"(,"launchMode":"Normal","masteryScore":0.5)");
  EXPECT_NE(refused(good, "account", "mbox").find("actor"), std::string::npos);
  EXPECT_NE(refused(good, kRegistration, "7").find("registration"), std::string::npos);
  EXPECT_NE(refused(good, kActivity, "17").find("activityId"), std::string::npos);
  EXPECT_NE(refused(good, "sessionid", "other").find("session id"), std::string::npos);
  EXPECT_NE(refused(good, "Normal", "Else").find("launchMode"), std::string::npos);
  EXPECT_NE(refused(good, "0.5", "5").find("masteryScore"), std::string::npos);
  EXPECT_NE(refused(good, "{", "").find("no JSON object"), std::string::npos);
}

TEST(XapiRules, TheCheckerFindsWhatIsWrong) {
  const auto session = objects(statements_of(trial(), kSource));
  const auto changed = [&](const QString& part, const QString& key, const QJsonValue& value) {
    QJsonObject statement = session[2], inner = statement[part].toObject();
    inner[key] = value;
    statement[part] = inner;
    return statement;
  };
  QJsonObject no_id = session[2];
  no_id["id"] = "17";
  for (const QJsonObject& wrong :
       {no_id, changed("result", "duration", "38 s"), changed("result", "duration", "PT"), changed("result", "success", 1),
        changed("result", "score", QJsonObject{{"scaled", 1.1}}), changed("verb", "id", "passed"),
        changed("result", "score", QJsonObject{{"raw", 5}, {"min", 10}, {"max", 20}}),
        changed("actor", "mbox", "mailto:anna@example.org"), changed("context", "colour", "red"),
        changed("context", "registration", "none")})
    EXPECT_FALSE(xapi_offences(wrong).empty()) << QJsonDocument(wrong).toJson().toStdString();
  const auto broken = [&](std::vector<QJsonObject> wrong) { return !cmi5_offences(wrong, false).empty(); };
  EXPECT_TRUE(broken({session[0], session[2], session[2], session[3]}));
  EXPECT_TRUE(broken({session[0], session[1], session[2]}));
  EXPECT_TRUE(broken({session[1], session[2], session[3]}));
  EXPECT_TRUE(broken({session[0], changed("result", "completion", true), session[3]}));
  EXPECT_TRUE(broken({session[0], changed("result", "success", false), session[3]}));
  EXPECT_FALSE(cmi5_offences(session, true).empty()) << "without the category";
}

TEST_P(AnyRecords, StationsThatShareRecordsShareTheTraineesHomePage) {
  Records one(at_station("a")), other(at_station("b"));
  const XapiSource source = xapi_source(one);
  EXPECT_EQ(source.home_page, xapi_source(other).home_page);
  EXPECT_EQ(source.home_page.rfind("https://vallecula.invalid/records/", 0), 0u);
  EXPECT_EQ(xapi_source(one, "https://training.example.org/v").home_page, "https://training.example.org/v");
  EXPECT_NE(error_of<RecordsError>([&] { xapi_source(one, "anna@example.org"); }).find("home_page"), std::string::npos);
}

}  // namespace
}  // namespace vallecula::curricula::testing
