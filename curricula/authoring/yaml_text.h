// A YAML text and where each value stands in it, so that one value can be changed and every other byte kept.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vallecula::curricula {

/// A value of the document; where it stands is known for those that YamlText has read.
struct YamlNode {
  enum class Kind { scalar, list, group };
  Kind kind = Kind::scalar;
  std::string key;                 ///< its field, in a group
  std::string value;               ///< of a scalar, without quotes
  bool is_text = false;            ///< a scalar that was quoted or written as a block; a number or true is not
  std::vector<YamlNode> children;  ///< of a list or group, in the file's order

  int line = 0;                            ///< of the value's first byte, from 1
  bool flow = false;                       ///< in brackets or braces
  std::size_t key_begin = 0, key_end = 0;  ///< the field's name and its colon
  std::size_t begin = 0, end = 0;          ///< the value's own bytes

  const YamlNode* child(const std::string& name) const;  ///< null: none
};

/// What is written: a number, true or false; a text; a list; a group.
YamlNode yaml_plain(std::string value);
YamlNode yaml_text(std::string value);
YamlNode yaml_list(std::vector<YamlNode> items);
YamlNode yaml_group(std::vector<std::pair<std::string, YamlNode>> fields);
/// The same but for where they stand and how they are quoted.
bool same_value(const YamlNode& a, const YamlNode& b);

/// "scenarios[0].pass.attempt_time_s", as in messages, taken apart.
struct YamlStep {
  std::string key;  ///< empty: an index
  std::size_t index = 0;
};
std::vector<YamlStep> yaml_steps(const std::string& path);

class YamlText {
 public:
  /// Throws CurriculumError as `load_curriculum` does for YAML that is broken or hostile; and for one that it reads but
  /// that cannot be changed in place (tags, keys that are no words).
  explicit YamlText(std::string text);
  const std::string& text() const { return text_; }
  const YamlNode& root() const { return root_; }
  const YamlNode* find(const std::string& path) const;  ///< empty path: the root; null: not there
  /// The innermost field on this line (from 1) or the last before it; empty: none.
  std::string path_at(int line) const;

 private:
  std::string text_;
  YamlNode root_;
};

}  // namespace vallecula::curricula
