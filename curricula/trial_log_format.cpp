#include "curricula/trial_log_format.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <cstring>

namespace vallecula::curricula::log_format {
namespace {

template <class Unsigned>
void put_unsigned(std::string& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 0xffu));
}

template <class Unsigned>
Unsigned get_unsigned(const char* bytes) noexcept {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    value |= static_cast<Unsigned>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

void put(std::string& out, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  put_unsigned(out, bits);
}
void put(std::string& out, std::int64_t value) { put_unsigned(out, static_cast<std::uint64_t>(value)); }
void put(std::string& out, std::int32_t value) { put_unsigned(out, static_cast<std::uint32_t>(value)); }
void put(std::string& out, std::uint32_t value) { put_unsigned(out, value); }
void put(std::string& out, std::uint8_t value) { out.push_back(static_cast<char>(value)); }
template <std::size_t N>
void put(std::string& out, const std::array<double, N>& values) {
  for (double v : values) put(out, v);
}
void put(std::string& out, const LogPose& pose) {
  put(out, pose.position_m);
  put(out, pose.rotation_wxyz);
}

/// Takes fields off the front of a tick's bytes, in the order in which put_tick wrote them.
struct Cursor {
  const char* at;

  void get(double& value) {
    const auto bits = get_unsigned<std::uint64_t>(at);
    std::memcpy(&value, &bits, sizeof bits);
    at += 8;
  }
  void get(std::int64_t& value) { value = static_cast<std::int64_t>(get_unsigned<std::uint64_t>(at)), at += 8; }
  void get(std::int32_t& value) { value = static_cast<std::int32_t>(get_unsigned<std::uint32_t>(at)), at += 4; }
  void get(std::uint32_t& value) { value = get_unsigned<std::uint32_t>(at), at += 4; }
  void get(std::uint8_t& value) { value = static_cast<std::uint8_t>(*at++); }
  void get(bool& value) { value = *at++ != 0; }
  template <std::size_t N>
  void get(std::array<double, N>& values) {
    for (double& v : values) get(v);
  }
  void get(LogPose& pose) {
    get(pose.position_m);
    get(pose.rotation_wxyz);
  }
};

double finite_or_throw(double value, const std::string& name) {
  if (!std::isfinite(value)) throw TrialLogError("'" + name + "' is not a finite number and cannot be stored");
  return value;
}

QString text(const std::string& s) { return QString::fromStdString(s); }

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

}  // namespace

std::uint32_t crc32(const char* data, std::size_t size) noexcept {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1u) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      entries[i] = c;
    }
    return entries;
  }();
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) crc = table[(crc ^ static_cast<unsigned char>(data[i])) & 0xffu] ^ (crc >> 8);
  return crc ^ 0xffffffffu;
}

void put_u32(std::string& out, std::uint32_t value) { put_unsigned(out, value); }
std::uint32_t get_u32(const char* bytes) noexcept { return get_unsigned<std::uint32_t>(bytes); }

std::string file_head() {
  std::string head(kMagic, kMagicBytes);
  put_u32(head, kVersion);
  return head;
}

std::string block(const char kind[4], std::uint32_t number, const std::string& payload) {
  std::string bytes(kind, 4);
  bytes.reserve(kBlockHeadBytes + payload.size() + kChecksumBytes);
  put_u32(bytes, number);
  put_u32(bytes, static_cast<std::uint32_t>(payload.size()));
  bytes += payload;
  put_u32(bytes, crc32(bytes.data(), bytes.size()));
  return bytes;
}

void put_tick(std::string& out, const LogTick& tick) {
  put(out, tick.tick);
  put(out, tick.time_s);
  put(out, tick.device_pose);
  put(out, tick.buttons);
  put(out, static_cast<std::uint8_t>(tick.device_valid));
  put(out, tick.step_fed);
  put(out, tick.step_used);
  put(out, tick.proxy_pose);
  put(out, static_cast<std::uint8_t>(tick.state));
  put(out, tick.model_force_n);
  put(out, tick.model_torque_nm);
  put(out, tick.displayed_force_n);
  for (const LogLoad& load : tick.loads) {
    put(out, load.force_n);
    put(out, load.centre_m);
    put(out, load.contacts);
  }
  put(out, static_cast<std::uint8_t>(tick.has_sight));
  put(out, tick.glottis_visible);
  put(out, tick.faults);
}

LogTick get_tick(const char* bytes) {
  LogTick tick;
  std::uint8_t state = 0;
  Cursor c{bytes};
  c.get(tick.tick);
  c.get(tick.time_s);
  c.get(tick.device_pose);
  c.get(tick.buttons);
  c.get(tick.device_valid);
  c.get(tick.step_fed);
  c.get(tick.step_used);
  c.get(tick.proxy_pose);
  c.get(state);
  c.get(tick.model_force_n);
  c.get(tick.model_torque_nm);
  c.get(tick.displayed_force_n);
  for (LogLoad& load : tick.loads) {
    c.get(load.force_n);
    c.get(load.centre_m);
    c.get(load.contacts);
  }
  c.get(tick.has_sight);
  c.get(tick.glottis_visible);
  c.get(tick.faults);
  if (state > static_cast<std::uint8_t>(LoggedState::recovering)) {
    throw TrialLogError("tick " + std::to_string(tick.tick) + " has the unknown state " + std::to_string(state));
  }
  tick.state = static_cast<LoggedState>(state);
  return tick;
}

std::string header_to_json(const LogHeader& header) {
  QJsonObject o;
  o["schema"] = header.tool_sha256.empty() ? 1 : 2;
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
  o["settings"] = settings;
  o["landmarks_m"] = landmarks;
  return compact(o);
}

LogHeader header_from_json(const std::string& json) {
  const QJsonObject o = parse_object(json);
  LogHeader header;
  header.schema = static_cast<int>(get_integer(o, "schema"));
  if (header.schema != 1 && header.schema != 2) {
    throw TrialLogError("its schema is " + std::to_string(header.schema) +
                        ", this version reads 1 and 2; use the newer Vallecula");
  }
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
  if (header.schema == 2) header.tool_sha256 = get_text(o, "tool_sha256");
  header.device_kind = get_text(o, "device_kind");
  header.servo_period_s = get_number(o, "servo_period_s");
  if (!(header.servo_period_s > 0.0)) throw TrialLogError("its servo_period_s is not positive");
  header.device_limit_n = get_number(o, "device_limit_n");
  header.realtime = get_bool(o, "realtime");
  const QJsonObject settings = field(o, "settings", QJsonValue::Object).toObject();
  for (auto it = settings.begin(); it != settings.end(); ++it)
    header.settings[it.key().toStdString()] = it.value().toDouble();
  const QJsonObject landmarks = field(o, "landmarks_m", QJsonValue::Object).toObject();
  for (auto it = landmarks.begin(); it != landmarks.end(); ++it) {
    const QJsonArray c = it.value().toArray();
    if (c.size() != 3) throw TrialLogError("landmark '" + it.key().toStdString() + "' does not have three coordinates");
    header.landmarks_m[it.key().toStdString()] = {c[0].toDouble(), c[1].toDouble(), c[2].toDouble()};
  }
  return header;
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
