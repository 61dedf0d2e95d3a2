// The trial log's header and footer as JSON.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <cmath>

#include "curricula/qt_text.h"
#include "curricula/trial_log_format.h"

namespace vallecula::curricula::log_format {
namespace {

constexpr std::array<const char*, 3> kEventKinds{"shown", "answered", "silenced"};  ///< by LogEvent::Kind

double finite_or_throw(double value, const std::string& name) {
  if (!std::isfinite(value)) throw TrialLogError("'" + name + "' is not a finite number and cannot be stored");
  return value;
}

QJsonObject parse_object(const std::string& json) {
  QJsonParseError error{};
  const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json), &error);
  if (!document.isObject()) throw TrialLogError("its JSON cannot be read (" + error.errorString().toStdString() + ")");
  return document.object();
}

QJsonValue field(const QJsonObject& object, const char* name, QJsonValue::Type type) {
  const QJsonValue value = object.value(QLatin1String(name));
  if (value.type() != type) throw TrialLogError(std::string("field '") + name + "' is missing or of the wrong type");
  return value;
}
std::string get_text(const QJsonObject& o, const char* name) {
  return field(o, name, QJsonValue::String).toString().toStdString();
}
double get_number(const QJsonObject& o, const char* name) { return field(o, name, QJsonValue::Double).toDouble(); }
bool get_bool(const QJsonObject& o, const char* name) { return field(o, name, QJsonValue::Bool).toBool(); }
std::int64_t get_integer(const QJsonObject& o, const char* name) {
  return field(o, name, QJsonValue::Double).toVariant().toLongLong();
}

std::string compact(const QJsonObject& object) {
  return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString();
}

/// Without this length no depth of a tube could be judged.
void check_depth_is_known(const LogHeader& header) {
  const auto found = header.settings.find(kCordsToCarina);
  if (found == header.settings.end() || !(found->second > 0.0))
    throw TrialLogError(std::string("its setting ") + kCordsToCarina + " is missing or not positive");
}

}  // namespace

std::string header_to_json(const LogHeader& header) {
  QJsonObject o;
  const bool fourth = header.has_events || header.has_contact_areas;
  o["schema"] = fourth ? 4 : header.has_intubation ? 3 : header.tool_sha256.empty() ? 1 : 2;
  if (fourth) {
    o["has_events"] = header.has_events;
    o["has_contact_areas"] = header.has_contact_areas;
    o["has_intubation"] = header.has_intubation;
  }
  o["software_version"] = text(header.software_version);
  o["build_hash"] = text(header.build_hash);
  o["instruction_set"] = text(header.instruction_set);
  o["package_name"] = text(header.package_name);
  o["package_path"] = text(header.package_path);
  o["package_sha256"] = text(header.package_sha256);
  o["curriculum_path"] = text(header.curriculum_path);
  o["scenario_id"] = text(header.scenario_id);
  o["scenario_yaml"] = text(header.scenario_yaml);
  o["scenario_sha256"] = text(header.scenario_sha256);
  if (!header.tool_sha256.empty()) o["tool_sha256"] = text(header.tool_sha256);
  o["device_kind"] = text(header.device_kind);
  if (!(header.servo_period_s > 0.0)) throw TrialLogError("'servo_period_s' must be positive");
  o["servo_period_s"] = finite_or_throw(header.servo_period_s, "servo_period_s");
  o["device_limit_n"] = finite_or_throw(header.device_limit_n, "device_limit_n");
  o["realtime"] = header.realtime;
  QJsonObject settings, landmarks;
  for (const auto& [name, value] : header.settings) settings[text(name)] = finite_or_throw(value, name);
  for (const auto& [name, point] : header.landmarks_m) {
    QJsonArray coordinates;
    for (double c : point) coordinates.append(finite_or_throw(c, name));
    landmarks[text(name)] = coordinates;
  }
  if (header.has_intubation) check_depth_is_known(header);
  o["settings"] = settings;
  o["landmarks_m"] = landmarks;
  return compact(o);
}

LogHeader header_from_json(const std::string& json) {
  const QJsonObject o = parse_object(json);
  LogHeader header;
  header.schema = static_cast<int>(get_integer(o, "schema"));
  if (header.schema < 1 || header.schema > 4) {
    throw TrialLogError("its schema is " + std::to_string(header.schema) +
                        ", this version reads 1 to 4; use the newer Vallecula");
  }
  const auto in_fourth = [&](const char* name) { return header.schema == 4 && get_bool(o, name); };
  header.has_events = in_fourth("has_events");
  header.has_contact_areas = in_fourth("has_contact_areas");
  header.has_intubation = header.schema == 3 || in_fourth("has_intubation");
  header.software_version = get_text(o, "software_version");
  header.build_hash = get_text(o, "build_hash");
  header.instruction_set = get_text(o, "instruction_set");
  header.package_name = get_text(o, "package_name");
  header.package_path = get_text(o, "package_path");
  header.package_sha256 = get_text(o, "package_sha256");
  header.curriculum_path = get_text(o, "curriculum_path");
  header.scenario_id = get_text(o, "scenario_id");
  header.scenario_yaml = get_text(o, "scenario_yaml");
  header.scenario_sha256 = get_text(o, "scenario_sha256");
  if (header.schema == 2 || o.contains("tool_sha256")) header.tool_sha256 = get_text(o, "tool_sha256");
  header.device_kind = get_text(o, "device_kind");
  header.servo_period_s = get_number(o, "servo_period_s");
  if (!(header.servo_period_s > 0.0)) throw TrialLogError("its servo_period_s is not positive");
  header.device_limit_n = get_number(o, "device_limit_n");
  header.realtime = get_bool(o, "realtime");
  const QJsonObject settings = field(o, "settings", QJsonValue::Object).toObject();
  for (auto it = settings.begin(); it != settings.end(); ++it)
    header.settings[it.key().toStdString()] = it.value().toDouble();
  if (header.has_intubation) check_depth_is_known(header);
  const QJsonObject landmarks = field(o, "landmarks_m", QJsonValue::Object).toObject();
  for (auto it = landmarks.begin(); it != landmarks.end(); ++it) {
    const QJsonArray c = it.value().toArray();
    if (c.size() != 3) throw TrialLogError("landmark '" + it.key().toStdString() + "' does not have three coordinates");
    header.landmarks_m[it.key().toStdString()] = {c[0].toDouble(), c[1].toDouble(), c[2].toDouble()};
  }
  return header;
}

std::string event_to_json(const LogEvent& event) {
  QJsonObject o;
  o["tick"] = static_cast<qint64>(event.tick);
  o["kind"] = kEventKinds[static_cast<std::size_t>(event.kind)];
  o["distraction"] = event.distraction;
  o["answer"] = event.answer;
  return compact(o);
}

LogEvent event_from_json(const std::string& json) {
  const QJsonObject o = parse_object(json);
  LogEvent event;
  event.tick = get_integer(o, "tick");
  const std::string kind = get_text(o, "kind");
  const auto known = std::find(kEventKinds.begin(), kEventKinds.end(), kind);
  if (known == kEventKinds.end()) throw TrialLogError("an event's kind '" + kind + "' is unknown");
  event.kind = static_cast<LogEvent::Kind>(known - kEventKinds.begin());
  event.distraction = static_cast<int>(get_integer(o, "distraction"));
  event.answer = static_cast<int>(get_integer(o, "answer"));
  if (event.tick < 0 || event.distraction < 1 || event.answer < 0)
    throw TrialLogError("an event's tick, distraction or answer is out of range");
  return event;
}

std::string footer_to_json(const LogFooter& footer, std::int64_t ticks) {
  QJsonObject o;
  o["complete"] = footer.complete;
  o["ended"] = text(footer.ended);
  o["loop_rate_hz"] = finite_or_throw(footer.loop_rate_hz, "loop_rate_hz");
  o["deadline_misses"] = static_cast<qint64>(footer.deadline_misses);
  o["overruns"] = static_cast<qint64>(footer.overruns);
  o["real_time_setup"] = text(footer.real_time_setup);
  QJsonArray faults;
  for (const std::string& fault : footer.pause_faults) faults.append(text(fault));
  o["pause_faults"] = faults;
  o["ticks"] = static_cast<qint64>(ticks);
  return compact(o);
}

LogFooter footer_from_json(const std::string& json, std::int64_t& ticks) {
  const QJsonObject o = parse_object(json);
  LogFooter footer;
  footer.complete = get_bool(o, "complete");
  footer.ended = get_text(o, "ended");
  footer.loop_rate_hz = get_number(o, "loop_rate_hz");
  footer.deadline_misses = get_integer(o, "deadline_misses");
  footer.overruns = get_integer(o, "overruns");
  // Older logs lack these two.
  if (o.contains("real_time_setup")) footer.real_time_setup = get_text(o, "real_time_setup");
  for (const QJsonValue& fault : o.value("pause_faults").toArray())
    footer.pause_faults.push_back(fault.toString().toStdString());
  ticks = get_integer(o, "ticks");
  return footer;
}

}  // namespace vallecula::curricula::log_format
