#include "curricula/export/xapi.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUrl>
#include <QUuid>
#include <algorithm>
#include <cmath>

#include "curricula/qt_text.h"
#include "curricula/records/connection.h"
#include "curricula/records/random_id.h"
#include "curricula/score/figures.h"

namespace vallecula::curricula {
namespace {

// The project owns no domain. Names under .invalid are nobody's, now and later (RFC 2606), and need not lead anywhere.
const QString kNames = QStringLiteral("https://vallecula.invalid/xapi/");
const QString kAdl = QStringLiteral("http://adlnet.gov/expapi/");
const QString kCmi5 = QStringLiteral("https://w3id.org/xapi/cmi5/context/");
/// Of the ids made here (RFC 4122, version 5).
const QUuid kIds(QStringLiteral("{6f3b9d0e-93f5-4f0a-8a0e-0c5f1b7a7d21}"));
constexpr double kTickS = 0.001;

QString in_address(const std::string& s) { return QString::fromLatin1(QUrl::toPercentEncoding(text(s))); }

QString uuid_of(const QString& name) { return QUuid::createUuidV5(kIds, name).toString(QUuid::WithoutBraces); }

QJsonObject parsed(const std::string& json, const char* what) {
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json), &error);
  if (!document.isObject())
    throw RecordsError(std::string("cmi5 launch: ") + what + " is no JSON object (" +
                       error.errorString().toStdString() + "); give it as the learning management system gave it");
  return document.object();
}

QJsonObject activity(const QString& id, const QString& type, const QString& name) {
  return {{"objectType", "Activity"},
          {"id", id},
          {"definition", QJsonObject{{"type", kAdl + "activities/" + type}, {"name", QJsonObject{{"en", name}}}}}};
}

QString duration(double seconds) {
  // Whole hundredths: receivers that compare durations look no further.
  return "PT" + QString::number(std::round(100.0 * std::max(0.0, seconds)) / 100.0, 'f', 2) + "S";
}

struct Times {
  QString begun, ended;
  double lasted_s = 0.0;
};

Times times_of(const RecordRow& trial) {
  Times times;
  times.lasted_s = trial.duration_s.value_or(kTickS * static_cast<double>(trial.score.ticks));
  const qint64 lasted_ms = std::llround(1e3 * times.lasted_s);
  QDateTime ended = QDateTime::fromString(text(trial.finished_utc), Qt::ISODate).toUTC();
  QDateTime begun = QDateTime::fromString(text(trial.started_utc), Qt::ISODate).toUTC();
  if (!begun.isValid()) begun = ended.addMSecs(-lasted_ms);
  if (ended < begun) ended = begun.addMSecs(lasted_ms);  // the clock went back during the trial
  times.begun = begun.toString(Qt::ISODateWithMs);
  times.ended = ended.toString(Qt::ISODateWithMs);
  return times;
}

QJsonObject score_of(double points) {
  return {{"scaled", std::round(100.0 * std::clamp(points, 0.0, 100.0)) / 10000.0},
          {"raw", static_cast<int>(std::lround(std::clamp(points, 0.0, 100.0)))},
          {"min", 0},
          {"max", 100}};
}

QJsonObject figures_of(const RecordRow& trial) {
  QJsonObject all;
  for (const Figure& figure : figures()) {
    const auto found = trial.figures.find(figure.name);
    if (!figure.for_researchers && std::string(figure.name) != "passed" && found != trial.figures.end())
      all[kNames + "figures/" + figure.name] = found->second;
  }
  if (trial.score.intubation) all[kNames + "outcome"] = QString(name_of(trial.score.intubation->outcome));
  return all;
}

/// What a launch's template has stays; what we know is added.
QJsonObject context_of(const RecordRow& trial, const QString& registration, const std::optional<Cmi5Launch>& launch) {
  QJsonObject context = launch ? parsed(launch->context_template, "contextTemplate") : QJsonObject();
  QJsonObject activities = context["contextActivities"].toObject(), extensions = context["extensions"].toObject();
  const auto also = [&activities](const char* list, const QJsonObject& one) {
    QJsonArray all = activities[list].toArray();
    all.append(one);
    activities[list] = all;
  };
  const QString course = kNames + "curricula/" + in_address(trial.curriculum_id);
  const QJsonObject curriculum = activity(course, "course", text(trial.curriculum_id));
  if (trial.module_id.empty()) {
    also("parent", curriculum);
  } else {
    also("parent", activity(course + "/modules/" + in_address(trial.module_id), "module", text(trial.module_id)));
    also("grouping", curriculum);
  }
  if (launch) also("category", QJsonObject{{"objectType", "Activity"}, {"id", kCmi5 + "categories/cmi5"}});
  const QJsonObject known{{kNames + "device-kind", text(trial.device_kind)},
                          {kNames + "mode", QString(name_of(trial.mode))},
                          {kNames + "seed", static_cast<double>(trial.attempt_seed)}};
  for (auto it = known.begin(); it != known.end(); ++it)
    if (!extensions.contains(it.key())) extensions[it.key()] = it.value();
  context["registration"] = registration;
  if (!context.contains("platform")) context["platform"] = "Vallecula";
  context["contextActivities"] = activities;
  context["extensions"] = extensions;
  return context;
}

}  // namespace

XapiSource xapi_source(Records& records, const std::string& home_page) {
  if (!home_page.empty()) {
    const QUrl url(text(home_page), QUrl::StrictMode);
    if (!url.isValid() || url.host().isEmpty() || (url.scheme() != "https" && url.scheme() != "http"))
      throw RecordsError("[lrs] home_page is no address; give one as https://training.example.org/vallecula");
    return {home_page};
  }
  Connection& connection = records.connection();
  std::string uid;
  connection.write([&] {
    connection.run("INSERT INTO about (name, value) VALUES ('uid', ?) ON CONFLICT (name) DO NOTHING",
                   {bound(random_id())});
    QSqlQuery query = connection.run("SELECT value FROM about WHERE name = 'uid'", {}, Connection::kCannotBeRead);
    query.next();
    uid = query.value(0).toString().toStdString();
  });
  return {"https://vallecula.invalid/records/" + uid};
}

Cmi5Launch read_cmi5_launch(const std::string& json) {
  const QJsonObject all = parsed(json, "the file"), data = all["launchData"].toObject();
  const auto needed = [](bool there, const char* what) {
    if (!there)
      throw RecordsError(std::string("cmi5 launch: ") + what +
                         " is missing or wrong; give it as the learning management system gave it");
  };
  const QJsonObject actor = all["actor"].toObject(), account = actor["account"].toObject(),
                    context = data["contextTemplate"].toObject();
  needed(account["homePage"].isString() && account["name"].isString(), "actor with an account");
  needed(!QUuid(all["registration"].toString()).isNull(), "registration (a UUID)");
  needed(!QUrl(all["activityId"].toString()).scheme().isEmpty(), "activityId");
  needed(context["extensions"].toObject()[kCmi5 + "extensions/sessionid"].isString(),
         "launchData.contextTemplate with a session id");
  const QString mode = data["launchMode"].toString();
  needed(mode == "Normal" || mode == "Browse" || mode == "Review", "launchData.launchMode (Normal, Browse or Review)");
  const auto one_line = [](const QJsonObject& object) { return QJsonDocument(object).toJson(QJsonDocument::Compact); };
  Cmi5Launch launch;
  launch.actor = one_line(actor).toStdString();
  launch.registration = QUuid(all["registration"].toString()).toString(QUuid::WithoutBraces).toStdString();
  launch.activity_id = all["activityId"].toString().toStdString();
  launch.context_template = one_line(context).toStdString();
  launch.judged = mode == "Normal";
  if (data.contains("masteryScore")) {
    launch.mastery_score = data["masteryScore"].toDouble(-1.0);
    needed(*launch.mastery_score >= 0.0 && *launch.mastery_score <= 1.0, "launchData.masteryScore (0 to 1)");
  }
  for (const QJsonValue& verb : all["recorded"].toArray()) launch.recorded.insert(verb.toString().toStdString());
  return launch;
}

std::vector<XapiStatement> statements_of(const RecordRow& trial, const XapiSource& source,
                                         const std::optional<Cmi5Launch>& launch) {
  // A row older than uids is known by its number in these records.
  const QString name = trial.uid.empty() ? text(source.home_page) + "#" + QString::number(trial.id) : text(trial.uid);
  const QString registration = launch ? text(launch->registration) : uuid_of(name);
  const Times times = times_of(trial);
  const QJsonObject context = context_of(trial, registration, launch);
  QJsonObject actor{
      {"objectType", "Agent"},
      {"account", QJsonObject{{"homePage", text(source.home_page)},
                              {"name", trial.trainee_id == 0 ? QStringLiteral("nobody")
                                                             : "trainee-" + QString::number(trial.trainee_id)}}}};
  QJsonObject object = activity(kNames + "curricula/" + in_address(trial.curriculum_id) + "/scenarios/" +
                                    in_address(trial.scenario_id),
                                "simulation", text(trial.scenario_id));
  if (launch) {
    actor = parsed(launch->actor, "actor");
    object["id"] = text(launch->activity_id);
  }

  std::vector<XapiStatement> all;
  const auto state = [&](const QString& verb, const QString& at, QJsonObject result) {
    QJsonObject its_context = context;
    if (launch && (result.contains("success") || result.contains("completion"))) {
      QJsonObject activities = its_context["contextActivities"].toObject();
      QJsonArray categories = activities["category"].toArray();
      categories.append(QJsonObject{{"objectType", "Activity"}, {"id", kCmi5 + "categories/moveon"}});
      activities["category"] = categories;
      its_context["contextActivities"] = activities;
    }
    if (launch && launch->mastery_score && result.contains("success")) {
      QJsonObject extensions = its_context["extensions"].toObject();
      extensions[kCmi5 + "extensions/masteryscore"] = *launch->mastery_score;
      its_context["extensions"] = extensions;
    }
    const QString id = uuid_of(registration + "/" + name + "/" + verb);
    QJsonObject statement{
        {"id", id},
        {"actor", actor},
        {"verb", QJsonObject{{"id", kAdl + "verbs/" + verb}, {"display", QJsonObject{{"en", verb}}}}},
        {"object", object},
        {"context", its_context},
        {"timestamp", at}};
    if (!result.isEmpty()) statement["result"] = result;
    all.push_back({id.toStdString(), QJsonDocument(statement).toJson(QJsonDocument::Compact).toStdString()});
  };
  const auto recorded = [&](const char* verb) { return launch && launch->recorded.count(verb) != 0; };

  const QJsonObject lasted{{"duration", duration(times.lasted_s)}};
  state("initialized", times.begun, {});
  if (trial.score.counts() && (!launch || launch->judged)) {
    if (!recorded("completed")) {
      QJsonObject result = lasted;
      result["completion"] = true;
      state("completed", times.ended, result);
    }
    QJsonObject result = lasted;
    bool success = trial.score.passed;
    if (trial.points) {
      const QJsonObject score = score_of(*trial.points);
      const bool asked = launch && launch->mastery_score;
      const bool reached = !asked || score["scaled"].toDouble() >= *launch->mastery_score;
      success = success && reached;
      // cmi5 9.3.5: a failed statement's score is below the mastery score. Points enough make no failed trial passed, and
      // another number would be untrue: it goes without.
      if (success || !asked || !reached) result["score"] = score;
    }
    result["success"] = success;
    if (const QJsonObject extensions = figures_of(trial); !extensions.isEmpty()) result["extensions"] = extensions;
    if (!recorded("passed")) state(success ? "passed" : "failed", times.ended, result);
  }
  state("terminated", times.ended, lasted);
  return all;
}

std::string json_array(const std::vector<XapiStatement>& statements) {
  std::string json = "[";
  for (std::size_t i = 0; i < statements.size(); ++i) json += (i == 0 ? "\n" : ",\n") + statements[i].json;
  return json + "\n]\n";
}

}  // namespace vallecula::curricula
