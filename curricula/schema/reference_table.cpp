#include "curricula/schema/reference_table.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QString>
#include <QStringList>

#include "curricula/schema/validator.h"

namespace vallecula::curricula {
namespace {

QString number(const QJsonValue& value) { return QString::number(value.toDouble(), 'g', 12); }

QString words_of(const QJsonArray& values) {
  QStringList words;
  for (const QJsonValue& value : values) words << value.toVariant().toString();
  return words.join(", ");
}

class Table {
 public:
  explicit Table(const char* json) : document_(QJsonDocument::fromJson(json).object()) {
    group("", resolved_schema(document_, document_));
  }
  std::string text() const { return out_.toStdString(); }

 private:
  void group(const QString& path, const QJsonObject& schema) {
    const QJsonObject properties = schema.value("properties").toObject();
    const QJsonArray required = schema.value("required").toArray();
    for (auto field = properties.begin(); field != properties.end(); ++field)
      row(path + field.key(), field.value().toObject(), required.contains(field.key()));
  }

  void row(const QString& path, const QJsonObject& given, bool needed) {
    const QJsonObject schema = resolved_schema(document_, given);
    const QJsonObject items = resolved_schema(document_, schema.value("items").toObject());
    QString unit = schema.value("unit").toString(), left_out = schema.value("left_out").toString();
    if (unit.isEmpty()) unit = items.value("unit").toString();
    if (left_out.isEmpty() && schema.contains("default")) left_out = schema.value("default").toVariant().toString();
    const bool list = schema.contains("items");
    const QJsonObject& inner = list ? items : schema;
    const QString definition = (list ? schema.value("items").toObject() : given).value("$ref").toString();
    const bool told = inner.contains("properties") && told_.contains(definition);  // once is enough
    const QString type = type_of(schema, items) + (told ? ", as above" : "");
    out_ += "| `" + path + "` | " + type + " | " + unit + " | " + allowed(schema, items) + " | " +
            (needed ? "required" : left_out) + " | " + schema.value("description").toString() + " |\n";
    if (told || !inner.contains("properties")) return;
    if (!definition.isEmpty()) told_ << definition;
    group(path + (list ? "[]." : "."), inner);
  }

  static QString type_of(const QJsonObject& schema, const QJsonObject& items) {
    const QJsonValue type = schema.value("type");
    if (type.isArray()) return "text";
    if (type == "array") return "list of " + type_of(items, {}) + (items.value("type") == "object" ? "s" : "");
    if (type == "object") return "group";
    if (type == "integer") return "whole number";
    if (type == "boolean") return "true or false";
    return type == "number" ? "number" : schema.contains("enum") ? "word" : "text";
  }

  static QString allowed(const QJsonObject& schema, const QJsonObject& items) {
    if (schema.contains("const")) return number(schema.value("const"));
    if (schema.contains("enum")) return words_of(schema.value("enum").toArray());
    if (schema.contains("minimum")) return number(schema.value("minimum")) + " to " + number(schema.value("maximum"));
    if (schema.contains("maxLength")) return "up to " + number(schema.value("maxLength")) + " characters";
    if (!schema.contains("maxItems")) return "";
    const bool exactly = schema.value("minItems") == schema.value("maxItems");
    const QString count = number(schema.value("minItems")) +
                          (exactly ? QString() : " to " + number(schema.value("maxItems"))) + " entries";
    const QString each = items.value("type") == "object" ? "" : allowed(items, {});
    return each.isEmpty() ? count : count + ", each " + each;
  }

  QJsonObject document_;
  QStringList told_;
  QString out_ = "| field | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
};

}  // namespace

std::string reference_table(const char* schema_json) { return Table(schema_json).text(); }

}  // namespace vallecula::curricula
