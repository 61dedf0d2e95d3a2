#include "tests/curricula/export/xapi_rules.h"

#include <QDateTime>
#include <QJsonArray>
#include <QRegularExpression>
#include <QSet>
#include <QUrl>
#include <cmath>

namespace vallecula::curricula::testing {
namespace {

class Check {
 public:
  std::vector<std::string> offences;

  void demand(bool good, const QString& what) {
    if (!good) offences.push_back(what.toStdString());
  }
  /// 2.2: only what is defined; null nowhere but in extensions; what must be there is.
  void properties(const QJsonObject& object, const QString& where, const QStringList& may, const QStringList& must) {
    for (const QString& key : object.keys()) {
      demand(may.contains(key), where + ": unknown property " + key);
      demand(!object[key].isNull(), where + "." + key + " is null");
    }
    for (const QString& key : must) demand(object.contains(key), where + ": " + key + " is missing");
  }
  void iri(const QJsonValue& value, const QString& where) {
    const QUrl url(value.toString(), QUrl::StrictMode);
    demand(value.isString() && url.isValid() && !url.scheme().isEmpty() && (!url.host().isEmpty() || !url.path().isEmpty()),
           where + " is no IRI: " + value.toString());
  }
  void uuid(const QJsonValue& value, const QString& where) {  // RFC 4122: variant 10xx, versions 1 to 5
    static const QRegularExpression kUuid(
        "^[0-9a-f]{8}-[0-9a-f]{4}-[1-5][0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$");
    demand(kUuid.match(value.toString()).hasMatch(), where + " is no UUID: " + value.toString());
  }
  void languages(const QJsonValue& value, const QString& where) {  // 4.2: RFC 5646 tags to texts
    static const QRegularExpression kTag("^[a-z]{2,3}(-[A-Za-z0-9]{2,8})*$");
    demand(value.isObject(), where + " is no language map");
    for (const QString& tag : value.toObject().keys()) {
      demand(kTag.match(tag).hasMatch(), where + ": " + tag + " is no language");
      demand(value.toObject()[tag].isString(), where + "." + tag + " is no text");
    }
  }
  void extensions(const QJsonValue& value, const QString& where) {  // 4.1
    demand(value.isObject(), where + " is no object");
    for (const QString& key : value.toObject().keys()) iri(key, where);
  }
  void duration(const QJsonValue& value, const QString& where) {  // 4.6: ISO 8601, a time after T, never empty
    static const QRegularExpression kDuration(
        "^P(?=.)(\\d+Y)?(\\d+M)?(\\d+D)?(T(?=.)(\\d+H)?(\\d+M)?(\\d+(\\.\\d{1,2})?S)?)?$");
    demand(kDuration.match(value.toString()).hasMatch(), where + " is no duration: " + value.toString());
  }
  void activity(const QJsonValue& value, const QString& where) {  // 2.4.4.1
    const QJsonObject object = value.toObject();
    properties(object, where, {"objectType", "id", "definition"}, {"id"});
    demand(!object.contains("objectType") || object["objectType"] == "Activity", where + " is no Activity");
    iri(object["id"], where + ".id");
    if (!object.contains("definition")) return;
    const QJsonObject definition = object["definition"].toObject();
    properties(definition, where + ".definition", {"name", "description", "type", "moreInfo", "extensions"}, {});
    if (definition.contains("type")) iri(definition["type"], where + ".definition.type");
    if (definition.contains("name")) languages(definition["name"], where + ".definition.name");
  }
  void agent(const QJsonObject& actor) {  // 2.4.2: exactly one way to identify; we demand that it is no mailbox
    properties(actor, "actor", {"objectType", "name", "account"}, {"account"});
    demand(actor["objectType"] == "Agent", "the actor is no Agent");
    const QJsonObject account = actor["account"].toObject();
    properties(account, "actor.account", {"homePage", "name"}, {"homePage", "name"});
    iri(account["homePage"], "actor.account.homePage");
    demand(!account["name"].toString().isEmpty(), "actor.account.name is empty");
  }
  void score(const QJsonObject& score) {  // 2.4.5.1
    properties(score, "score", {"scaled", "raw", "min", "max"}, {});
    for (const QString& key : score.keys()) demand(score[key].isDouble(), "score." + key + " is no number");
    if (score.contains("scaled"))
      demand(std::abs(score["scaled"].toDouble()) <= 1.0, "score.scaled is not within -1 and 1");
    if (score.contains("min") && score.contains("max"))
      demand(score["min"].toDouble() < score["max"].toDouble(), "score.min is not below max");
    if (score.contains("raw")) {
      if (score.contains("min")) demand(score["raw"].toDouble() >= score["min"].toDouble(), "score.raw is below min");
      if (score.contains("max")) demand(score["raw"].toDouble() <= score["max"].toDouble(), "score.raw is above max");
    }
  }
};

QString verb_of(const QJsonObject& statement) { return statement["verb"].toObject()["id"].toString(); }
QDateTime time_of(const QJsonObject& statement) {
  return QDateTime::fromString(statement["timestamp"].toString(), Qt::ISODateWithMs);
}

}  // namespace

std::vector<std::string> xapi_offences(const QJsonObject& statement) {
  Check check;
  check.properties(statement, "statement",
                   {"id", "actor", "verb", "object", "result", "context", "timestamp", "stored", "authority", "version",
                    "attachments"},
                   {"actor", "verb", "object"});
  check.uuid(statement["id"], "id");
  check.agent(statement["actor"].toObject());
  const QJsonObject verb = statement["verb"].toObject();
  check.properties(verb, "verb", {"id", "display"}, {"id"});
  check.iri(verb["id"], "verb.id");
  check.languages(verb["display"], "verb.display");
  check.activity(statement["object"], "object");
  check.demand(time_of(statement).isValid(), "timestamp is no ISO 8601 time");
  if (statement.contains("result")) {
    const QJsonObject result = statement["result"].toObject();
    check.properties(result, "result", {"score", "success", "completion", "response", "duration", "extensions"}, {});
    for (const char* truth : {"success", "completion"})
      if (result.contains(truth)) check.demand(result[truth].isBool(), QString(truth) + " is no truth value");
    if (result.contains("score")) check.score(result["score"].toObject());
    if (result.contains("duration")) check.duration(result["duration"], "result.duration");
    if (result.contains("extensions")) check.extensions(result["extensions"], "result.extensions");
  }
  if (statement.contains("context")) {
    const QJsonObject context = statement["context"].toObject();
    check.properties(context, "context",
                     {"registration", "instructor", "team", "contextActivities", "revision", "platform", "language",
                      "statement", "extensions"},
                     {});
    if (context.contains("registration")) check.uuid(context["registration"], "context.registration");
    check.extensions(context["extensions"].toObject(), "context.extensions");
    const QJsonObject activities = context["contextActivities"].toObject();
    check.properties(activities, "contextActivities", {"parent", "grouping", "category", "other"}, {});
    for (const QString& list : activities.keys()) {
      check.demand(activities[list].isArray(), "contextActivities." + list + " is no list");
      for (const QJsonValue& one : activities[list].toArray()) check.activity(one, "contextActivities." + list);
    }
  }
  return check.offences;
}

std::vector<std::string> cmi5_offences(const std::vector<QJsonObject>& session, bool defined) {
  Check check;
  const QString verbs = "http://adlnet.gov/expapi/verbs/", cmi5 = "https://w3id.org/xapi/cmi5/context/";
  QSet<QString> seen;
  QDateTime before;
  for (const QJsonObject& statement : session) {
    const QString verb = verb_of(statement).mid(verbs.size());
    check.demand(verb_of(statement).startsWith(verbs) &&
                     QStringList{"initialized", "completed", "passed", "failed", "terminated"}.contains(verb),
                 "9.3: a verb that is none of an activity's: " + verb_of(statement));
    check.demand(!seen.contains(verb), "9.3: " + verb + " twice in a session");
    seen.insert(verb);
    check.demand(!before.isValid() || before <= time_of(statement), "9.3: " + verb + " is before the one before");
    before = time_of(statement);
    check.demand(statement["timestamp"].toString().endsWith('Z'), "9.7: " + verb + " is not in UTC");
    check.demand(statement.contains("id"), "9.1: no id");
    check.demand(statement["actor"].toObject()["account"].isObject(), "9.2: an actor without account");
    check.demand(statement["object"] == session.front()["object"], "9.4: another object");

    const QJsonObject result = statement["result"].toObject(), score = result["score"].toObject();
    const bool judged = verb == "passed" || verb == "failed";
    check.demand(!result.contains("score") || judged, "9.5.1: a score with " + verb);
    if (score.contains("scaled"))
      check.demand(score["scaled"].toDouble() >= 0.0 && score["scaled"].toDouble() <= 1.0, "9.5.1: scaled below 0");
    for (const char* whole : {"raw", "min", "max"})
      if (score.contains(whole))
        check.demand(score[whole].toDouble() == std::floor(score[whole].toDouble()), "9.5.1: not whole");
    check.demand(!score.contains("raw") || (score.contains("min") && score.contains("max")), "9.5.1: raw alone");
    check.demand(result.contains("success") == judged, "9.5.2: success of " + verb);
    if (judged) check.demand(result["success"].toBool() == (verb == "passed"), "9.5.2: success is not " + verb);
    check.demand(result.contains("completion") == (verb == "completed"), "9.5.3: completion of " + verb);
    if (verb == "completed") check.demand(result["completion"].toBool(), "9.5.3: completed, and not");
    if (verb != "initialized") check.demand(result.contains("duration"), "9.5.4: no duration of " + verb);

    const QJsonObject context = statement["context"].toObject(), extensions = context["extensions"].toObject();
    check.demand(context["registration"] == session.front()["context"].toObject()["registration"] &&
                     context["registration"].isString(),
                 "9.6.1: another registration");
    QStringList categories;
    for (const QJsonValue& one : context["contextActivities"].toObject()["category"].toArray())
      categories << one.toObject()["id"].toString();
    check.demand(categories.contains(cmi5 + "categories/cmi5") == defined, "9.6.2.1: the cmi5 category of " + verb);
    check.demand(categories.contains(cmi5 + "categories/moveon") ==
                     (defined && (result.contains("success") || result.contains("completion"))),
                 "9.6.2.2: the moveon category of " + verb);
    check.demand(!defined || extensions.contains(cmi5 + "extensions/sessionid"), "9.6.3.1: no session id");
    if (extensions.contains(cmi5 + "extensions/masteryscore") && score.contains("scaled"))
      check.demand((score["scaled"].toDouble() >= extensions[cmi5 + "extensions/masteryscore"].toDouble()) ==
                       (verb == "passed"),
                   "9.3.4, 9.3.5: " + verb + " against the mastery score");
  }
  check.demand(!session.empty() && verb_of(session.front()) == verbs + "initialized", "7.1.1: initialized is not the first");
  check.demand(!session.empty() && verb_of(session.back()) == verbs + "terminated", "7.1.2: terminated is not the last");
  check.demand(!(seen.contains("passed") && seen.contains("failed")), "9.3: passed and failed in one session");
  return check.offences;
}

}  // namespace vallecula::curricula::testing
