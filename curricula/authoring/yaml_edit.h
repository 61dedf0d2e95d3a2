// Changes of a YAML text: each gives a new text that differs where it must and nowhere else. All throw
// std::runtime_error, and change nothing, where the place can only be changed by hand; what came out is read again and
// compared before it is handed out.
#pragma once

#include <string>

#include "curricula/authoring/yaml_text.h"

namespace vallecula::curricula {

/// `path` becomes `value`; what is not there is added behind its group's last field, missing groups with it. Comments
/// and spacing stay but for those inside a replaced list or group.
std::string with_value(const YamlText& text, const std::string& path, const YamlNode& value);
/// The field is left out, and its group with it where it was the last.
std::string without_value(const YamlText& text, const std::string& path);

/// An entry of the list at `path` goes to another place among the others (0 to count - 1), comments above it with it.
std::string with_item_moved(const YamlText& text, const std::string& path, std::size_t from, std::size_t to);
std::string without_item(const YamlText& text, const std::string& path, std::size_t index);
/// A copy of the entry `index` of the list `from_path` in `from`, to become the entry `to` of the list at `path`.
std::string with_item_copied(const YamlText& text, const std::string& path, std::size_t to, const YamlText& from,
                             const std::string& from_path, std::size_t index);
/// The same with an entry that is written here; the list is made where there is none.
std::string with_item(const YamlText& text, const std::string& path, std::size_t to, const YamlNode& item);

}  // namespace vallecula::curricula
