// Checks a YAML node against a JSON Schema (private to the library). Understands the keywords the shipped schema uses
// and refuses a schema that uses another, so that no rule is silently not applied.
#pragma once

#include <yaml-cpp/yaml.h>

#include <QJsonObject>
#include <string>

namespace vallecula::curricula {

class Validator {
 public:
  /// `file`: stands in front of every message. Throws std::logic_error when the schema is not JSON.
  Validator(const char* schema_json, std::string file);

  /// Checks `node` against "#/$defs/<definition>"; `path` is the node's name in messages, empty for the document.
  /// Fields that are not named in the schema are errors. Throws CurriculumError: file, line, field, value, what is
  /// allowed.
  void check(const YAML::Node& node, const std::string& definition, const std::string& path) const;

  /// Throws CurriculumError in the same form, for rules no schema can say.
  [[noreturn]] void fail(const YAML::Node& node, const std::string& path, const std::string& allowed) const;
  /// The same for a field that `map` should hold and does not.
  [[noreturn]] void fail_missing(const YAML::Node& map, const std::string& path, const std::string& allowed) const;

 private:
  void check(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_map(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_list(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_number(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_string(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_boolean(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  [[noreturn]] void fail(int line, const std::string& path, const std::string& value, const std::string& allowed) const;

  QJsonObject schema_;
  std::string file_;
};

/// A YAML number as JSON Schema means it: an unquoted decimal number, finite. The point is a point in every locale.
bool yaml_number(const YAML::Node& node, double& value);

/// Of a node that the validator has let pass.
double checked_number(const YAML::Node& node);
bool checked_bool(const YAML::Node& node);

/// A value for a message, "6.5 N".
std::string with_unit(double value, const char* unit);

}  // namespace vallecula::curricula
