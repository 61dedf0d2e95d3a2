// Checks a YAML node against a JSON Schema (private to the library). Understands the keywords the shipped schema uses
// and refuses a schema that uses another, so that no rule is silently not applied.
#pragma once

#include <yaml-cpp/yaml.h>

#include <QJsonObject>
#include <set>
#include <string>
#include <vector>

#include "curricula/scenario.h"

namespace vallecula::curricula {

/// `given` of a schema document, with what it refers to put in its place.
QJsonObject resolved_schema(const QJsonObject& document, const QJsonObject& given);

class Validator {
 public:
  /// `file`: stands in front of every message. Throws std::logic_error when the schema is not JSON.
  Validator(const char* schema_json, std::string file);

  /// Checks `node` against "#/$defs/<definition>"; `path` is the node's name in messages, empty for the document.
  /// Fields that are not named in the schema are errors. Throws CurriculumError: file, line, field, value, what is
  /// allowed.
  void check(const YAML::Node& node, const std::string& definition, const std::string& path) const;

  /// The same, but goes on after a mistake; all of them, by line.
  std::vector<Problem> problems(const YAML::Node& node, const std::string& definition) const;

  /// Throws CurriculumError in the same form, for rules no schema can say.
  [[noreturn]] void fail(const YAML::Node& node, const std::string& path, const std::string& allowed) const;
  /// The same for a field that `map` should hold and does not.
  [[noreturn]] void fail_missing(const YAML::Node& map, const std::string& path, const std::string& allowed) const;

 private:
  void check(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_map(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  /// One entry of a group; `seen`: the names before it.
  void check_field(const YAML::Node& key_node, const YAML::Node& value, const QJsonObject& schema,
                   const std::string& path, int line, std::set<std::string>& seen) const;
  void check_list(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_number(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_string(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  void check_boolean(const YAML::Node& node, const QJsonObject& schema, const std::string& path, int line) const;
  [[noreturn]] void fail(int line, const std::string& path, const std::string& value, const std::string& allowed) const;

  /// Runs one check; what it throws is thrown on, or put with the others.
  template <class Check>
  void one(const Check& check) const;

  QJsonObject schema_;
  std::string file_;
  mutable std::vector<Problem>* collected_ = nullptr;  ///< null: the first mistake is thrown
};

/// A YAML number as JSON Schema means it: an unquoted decimal number, finite. The point is a point in every locale.
bool yaml_number(const YAML::Node& node, double& value);

/// Of a node that the validator has let pass.
double checked_number(const YAML::Node& node);
bool checked_bool(const YAML::Node& node);

/// A value for a message, "6.5 N".
std::string with_unit(double value, const char* unit);

}  // namespace vallecula::curricula
