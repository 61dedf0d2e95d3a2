#include "curricula/authoring/field_rules.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

#include "curricula/schema/validator.h"

namespace vallecula::curricula {
namespace {

QString number_text(double value) { return QString::number(value, 'g', 12); }

FieldRule::Kind kind_of(const QJsonObject& schema, const QJsonObject& items) {
  using Kind = FieldRule::Kind;
  const QJsonValue type = schema.value("type");
  if (type.isArray()) return Kind::text;
  if (type == "number") return Kind::number;
  if (type == "integer") return schema.contains("enum") ? Kind::word : Kind::whole_number;
  if (type == "boolean") return Kind::truth;
  if (type == "object") return Kind::group;
  if (type == "array") {
    if (items.value("type") == "object") return Kind::groups;
    if (items.value("type") == "number") return Kind::range;
    return items.value("type").isArray() ? Kind::texts : Kind::words;
  }
  return schema.contains("enum") ? Kind::word : Kind::plain_text;
}

std::vector<FieldRule> fields_in(const QJsonObject& document, const QJsonObject& schema, const QStringList& skipped);

FieldRule rule_of(const QJsonObject& document, const QString& name, const QJsonObject& given) {
  const QJsonObject schema = resolved_schema(document, given);
  const QJsonObject items = resolved_schema(document, schema.value("items").toObject());
  const QJsonObject& values = schema.contains("items") ? items : schema;
  FieldRule rule;
  rule.name = name;
  rule.label = schema.value("title").toString(label_of(name));
  rule.kind = kind_of(schema, items);
  rule.unit = values.value("unit").toString();
  rule.help = schema.value("description").toString(items.value("description").toString());
  rule.left_out = schema.value("left_out").toString();
  if (rule.left_out.isEmpty() && schema.contains("default"))
    rule.left_out = schema.value("default").toVariant().toString();
  rule.minimum = values.value("minimum").toDouble();
  rule.maximum = values.value("maximum").toDouble();
  rule.longest = values.value("maxLength").toInt();
  for (const QJsonValue& word : values.value("enum").toArray()) rule.words << word.toVariant().toString();
  rule.words_are_text = values.value("type") == "string";
  if (values.value("type") == "object") rule.fields = fields_in(document, values, {});
  return rule;
}

std::vector<FieldRule> fields_in(const QJsonObject& document, const QJsonObject& schema, const QStringList& skipped) {
  const QJsonObject properties = schema.value("properties").toObject();
  std::vector<FieldRule> rules;
  QStringList names;
  for (const QJsonValue& required : schema.value("required").toArray()) names << required.toString();
  const int required = names.size();
  for (const QString& name : properties.keys())
    if (!names.contains(name)) names << name;
  for (int i = 0; i < names.size(); ++i) {
    if (skipped.contains(names[i])) continue;
    rules.push_back(rule_of(document, names[i], properties.value(names[i]).toObject()));
    rules.back().required = i < required;
  }
  // What is one line comes before what opens a group.
  std::stable_partition(rules.begin(), rules.end(), [](const FieldRule& rule) { return rule.fields.empty(); });
  return rules;
}

}  // namespace

QString FieldRule::allowed() const {
  const QString with_unit = unit.isEmpty() ? "" : " " + unit;
  switch (kind) {
    case Kind::number:
    case Kind::whole_number:
    case Kind::range:
      return number_text(minimum) + " to " + number_text(maximum) + with_unit;
    case Kind::plain_text:
    case Kind::text:
    case Kind::texts:
      return longest > 0 ? "up to " + QString::number(longest) + " characters" : "";
    default:
      return "";
  }
}

std::vector<FieldRule> fields_of(const char* schema_json, const QString& definition, const QStringList& skipped) {
  const QJsonObject document = QJsonDocument::fromJson(schema_json).object();
  return fields_in(document, document.value("$defs").toObject().value(definition).toObject(), skipped);
}

QString label_of(const QString& name) {
  static const QStringList units{"n", "s", "kg", "mm", "ml", "pa", "percent", "weeks", "min", "f"};
  QStringList words = name.split('_');
  while (words.size() > 1 && units.contains(words.last())) words.removeLast();
  if (words.size() > 1 && words.last() == "per") words.removeLast();
  QString label = words.join(' ');
  label.replace("spo2", "SpO2").replace("co2", "CO2");
  if (!label.isEmpty()) label[0] = label[0].toUpper();
  return label;
}

}  // namespace vallecula::curricula
