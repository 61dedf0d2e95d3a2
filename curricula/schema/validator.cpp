#include "curricula/schema/validator.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>

#include "curricula/scenario.h"

namespace vallecula::curricula {
namespace {

constexpr std::size_t kShownValue = 60;  ///< characters of a value repeated in a message

std::string number_text(double value) { return QString::number(value, 'g', 12).toStdString(); }

std::string text_of(const QJsonValue& value) { return value.toString().toStdString(); }

/// 1-based line; 0 when the parser knows none.
int line_of(const YAML::Node& node, int otherwise) {
  const YAML::Mark mark = node.Mark();
  return mark.is_null() ? otherwise : mark.line + 1;
}

std::string shown(const YAML::Node& node) {
  if (!node.IsDefined()) return "missing";
  if (node.IsNull()) return "empty";
  if (node.IsMap()) return "a group of fields";
  if (node.IsSequence()) return "a list";
  std::string value = node.Scalar();
  for (char& c : value) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  if (value.size() > kShownValue) {
    std::size_t cut = kShownValue;
    while (cut > 0 && (static_cast<unsigned char>(value[cut]) & 0xc0) == 0x80) --cut;  // not inside a UTF-8 character
    value = value.substr(0, cut) + "...";
  }
  return "'" + value + "'";
}

std::string joined(const QStringList& words) { return words.join(", ").toStdString(); }

std::string with_description(std::string allowed, const QJsonObject& schema) {
  if (schema.contains("unit")) allowed += " " + text_of(schema.value("unit"));
  const std::string description = text_of(schema.value("description"));
  return description.empty() ? allowed : allowed + " (" + description + ")";
}

/// "string" for a text that may also be a group of texts.
std::string main_type(const QJsonObject& schema) {
  const QJsonValue type = schema.value("type");
  return text_of(type.isArray() ? type.toArray().first() : type);
}

std::string range_text(const char* noun, const QJsonObject& schema) {
  return std::string(noun) + " from " + number_text(schema.value("minimum").toDouble(-HUGE_VAL)) + " to " +
         number_text(schema.value("maximum").toDouble(HUGE_VAL));
}

/// What a schema allows, in words.
std::string allowed_by(const QJsonObject& schema) {
  const std::string type = main_type(schema);
  std::string allowed;
  if (schema.contains("const")) {
    allowed = number_text(schema.value("const").toDouble());
  } else if (schema.contains("enum")) {
    QStringList words;
    for (const QJsonValue& word : schema.value("enum").toArray()) words << word.toVariant().toString();
    allowed = "one of " + joined(words);
  } else if (type == "number") {
    allowed = range_text("a number", schema);
  } else if (type == "integer") {
    allowed = range_text("a whole number", schema);
  } else if (type == "string") {
    allowed = "text of " + number_text(schema.value("minLength").toDouble(1)) + " to " +
              number_text(schema.value("maxLength").toDouble()) + " characters";
  } else if (type == "boolean") {
    allowed = "true or false";
  } else if (type == "array") {
    allowed = "a list of " + number_text(schema.value("minItems").toDouble()) + " to " +
              number_text(schema.value("maxItems").toDouble()) + " entries";
  } else {
    allowed = "a group of the fields " + joined(schema.value("properties").toObject().keys());
  }
  return with_description(allowed, schema);
}

void refuse_unknown_keywords(const QJsonObject& schema) {
  // The last three say something to people: "default" and "left_out" what holds for a field that is not there.
  static const std::set<QString> known = {"$schema",
                                          "$defs",
                                          "$ref",
                                          "title",
                                          "description",
                                          "type",
                                          "required",
                                          "pattern",
                                          "maxLength",
                                          "minLength",
                                          "enum",
                                          "const",
                                          "minimum",
                                          "maximum",
                                          "minItems",
                                          "maxItems",
                                          "items",
                                          "propertyNames",
                                          "additionalProperties",
                                          "properties",
                                          "unit",
                                          "default",
                                          "left_out"};
  for (const QString& keyword : schema.keys()) {
    if (known.count(keyword) == 0)
      throw std::logic_error("schema keyword '" + keyword.toStdString() + "' is not understood");
  }
}

bool matches(const QString& pattern, const QString& whole) {
  return QRegularExpression(QRegularExpression::anchoredPattern(pattern)).match(whole).hasMatch();
}

std::string child_path(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

}  // namespace

bool yaml_number(const YAML::Node& node, double& value) {
  if (!node.IsScalar() || node.Tag() != "?") return false;  // "?": not quoted
  const std::string& text = node.Scalar();
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

double checked_number(const YAML::Node& node) {
  double value = 0.0;
  yaml_number(node, value);
  return value;
}

bool checked_bool(const YAML::Node& node) { return node.Scalar() == "true"; }

std::string with_unit(double value, const char* unit) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return std::string(digits.data(), end) + " " + unit;
}

Validator::Validator(const char* schema_json, std::string file) : file_(std::move(file)) {
  const QJsonDocument document = QJsonDocument::fromJson(schema_json);
  if (!document.isObject()) throw std::logic_error("the curriculum schema is not a JSON object");
  schema_ = document.object();
  refuse_unknown_keywords(schema_);
}

void Validator::fail(int line, const std::string& path, const std::string& value, const std::string& allowed) const {
  const std::string message = (path.empty() ? "the document" : path) + " is " + value + "; allowed: " + allowed;
  throw CurriculumError(file_ + ":" + std::to_string(line) + ": " + message, {line, path, value, allowed, message});
}

void Validator::fail(const YAML::Node& node, const std::string& path, const std::string& allowed) const {
  fail(line_of(node, 1), path, shown(node), allowed);
}

void Validator::fail_missing(const YAML::Node& map, const std::string& path, const std::string& allowed) const {
  fail(line_of(map, 1), path, "missing", allowed);
}

void Validator::check(const YAML::Node& node, const std::string& definition, const std::string& path) const {
  check(node, schema_.value("$defs").toObject().value(QString::fromStdString(definition)).toObject(), path, 1);
}

std::vector<Problem> Validator::problems(const YAML::Node& node, const std::string& definition) const {
  std::vector<Problem> found;
  collected_ = &found;
  one([&] { check(node, definition, ""); });
  collected_ = nullptr;
  std::stable_sort(found.begin(), found.end(), [](const Problem& a, const Problem& b) { return a.line < b.line; });
  return found;
}

template <class Check>
void Validator::one(const Check& check) const {
  try {
    check();
  } catch (const CurriculumError& error) {
    if (collected_ == nullptr) throw;
    collected_->push_back(error.problem());
  }
}

QJsonObject resolved_schema(const QJsonObject& document, const QJsonObject& given) {
  if (!given.contains("$ref")) return given;
  const QString name = given.value("$ref").toString().mid(static_cast<int>(sizeof("#/$defs/")) - 1);
  QJsonObject schema = document.value("$defs").toObject().value(name).toObject();
  if (schema.isEmpty()) throw std::logic_error("the curriculum schema does not define '" + name.toStdString() + "'");
  for (auto own = given.begin(); own != given.end(); ++own)  // what stands beside the reference is nearer
    if (own.key() != "$ref") schema.insert(own.key(), own.value());
  return schema;
}

void Validator::check(const YAML::Node& node, const QJsonObject& given, const std::string& path, int line) const {
  const QJsonObject schema = resolved_schema(schema_, given);
  refuse_unknown_keywords(schema);
  line = line_of(node, line);
  const std::string type = schema.value("type").isArray() && node.IsMap() ? "object" : main_type(schema);
  if (type == "object") {
    check_map(node, schema, path, line);
  } else if (type == "array") {
    check_list(node, schema, path, line);
  } else if (type == "number" || type == "integer") {
    check_number(node, schema, path, line);
  } else if (type == "string") {
    check_string(node, schema, path, line);
  } else if (type == "boolean") {
    check_boolean(node, schema, path, line);
  } else {
    throw std::logic_error("schema type '" + type + "' is not understood");
  }
}

void Validator::check_field(const YAML::Node& key_node, const YAML::Node& value, const QJsonObject& schema,
                            const std::string& path, int line, std::set<std::string>& seen) const {
  const QJsonObject properties = schema.value("properties").toObject();
  const int key_line = line_of(key_node, line);
  if (!key_node.IsScalar()) fail(key_line, path, "not named by a word", allowed_by(schema));
  const std::string key = key_node.Scalar(), name = child_path(path, key);
  const auto property = properties.find(QString::fromStdString(key));
  if (property == properties.end() && schema.value("additionalProperties").isObject()) {
    // Fields of one kind whose names are free, like the texts by language.
    const QJsonObject names = schema.value("propertyNames").toObject();
    if (!matches(names.value("pattern").toString(), QString::fromStdString(key)))
      fail(key_line, child_path(path, key.substr(0, kShownValue)),
           "an unknown field with the value " + shown(value), text_of(names.value("description")));
    if (!seen.insert(key).second) fail(key_line, name, "given twice", "once");
    check(value, schema.value("additionalProperties").toObject(), name, key_line);
    return;
  }
  if (property == properties.end()) {
    fail(key_line, child_path(path, key.substr(0, kShownValue)), "an unknown field with the value " + shown(value),
         "the fields " + joined(properties.keys()));
  }
  if (!seen.insert(key).second)
    fail(key_line, name, "given twice, here with the value " + shown(value), "once");
  check(value, property.value().toObject(), name, key_line);
}

void Validator::check_map(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const {
  if (!node.IsMap()) fail(line, path, shown(node), allowed_by(schema));
  const QJsonObject properties = schema.value("properties").toObject();
  std::set<std::string> seen;
  for (const auto& entry : node) one([&] { check_field(entry.first, entry.second, schema, path, line, seen); });
  for (const QJsonValue& required : schema.value("required").toArray()) {
    const std::string key = text_of(required);
    if (seen.count(key) != 0) continue;
    const QJsonObject property = properties.value(required.toString()).toObject();
    const bool of_one_kind = property.isEmpty() && schema.value("additionalProperties").isObject();
    const QJsonObject missing =
        resolved_schema(schema_, of_one_kind ? schema.value("additionalProperties").toObject() : property);
    one([&] { fail(line, child_path(path, key), "missing", allowed_by(missing)); });
  }
}

void Validator::check_list(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const {
  if (!node.IsSequence()) fail(line, path, shown(node), allowed_by(schema));
  const auto count = static_cast<double>(node.size());
  if (count < schema.value("minItems").toDouble(0) || count > schema.value("maxItems").toDouble(HUGE_VAL)) {
    fail(line, path, "a list of " + number_text(count), allowed_by(schema));
  }
  for (std::size_t i = 0; i < node.size(); ++i) {
    one([&] { check(node[i], schema.value("items").toObject(), path + "[" + std::to_string(i) + "]", line); });
  }
}

void Validator::check_number(const YAML::Node& node, const QJsonObject& schema, const std::string& path,
                             int line) const {
  double value = 0.0;
  bool ok = yaml_number(node, value);
  if (ok && text_of(schema.value("type")) == "integer") {
    ok = node.Scalar().find_first_of(".eE") == std::string::npos;  // 3.0 and 3e0 are not how a whole number is written
  }
  ok =
      ok && value >= schema.value("minimum").toDouble(-HUGE_VAL) && value <= schema.value("maximum").toDouble(HUGE_VAL);
  ok = ok && (!schema.contains("const") || value == schema.value("const").toDouble());
  ok = ok && (!schema.contains("enum") || schema.value("enum").toArray().contains(value));
  if (!ok) fail(line, path, shown(node), allowed_by(schema));
}

void Validator::check_string(const YAML::Node& node, const QJsonObject& schema, const std::string& path,
                             int line) const {
  if (!node.IsScalar()) fail(line, path, shown(node), allowed_by(schema));
  const QString value = QString::fromStdString(node.Scalar());
  bool ok =
      value.size() >= schema.value("minLength").toInt(0) && value.size() <= schema.value("maxLength").toInt(INT_MAX);
  if (schema.contains("enum")) ok = ok && schema.value("enum").toArray().contains(value);
  if (schema.contains("pattern")) {
    ok = ok && matches(schema.value("pattern").toString(), value);
  }
  if (!ok) fail(line, path, shown(node), allowed_by(schema));
}

void Validator::check_boolean(const YAML::Node& node, const QJsonObject& schema, const std::string& path,
                              int line) const {
  const bool ok =
      node.IsScalar() && node.Tag() == "?" && (node.Scalar() == "true" || node.Scalar() == "false");  // not quoted
  if (!ok) fail(line, path, shown(node), allowed_by(schema));
}

}  // namespace vallecula::curricula
