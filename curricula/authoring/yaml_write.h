// Values as YAML text (private to the library).
#pragma once

#include <string>

#include "curricula/authoring/yaml_text.h"

namespace vallecula::curricula {

/// How the value that is replaced was written: a text keeps its quotes, or its folded lines.
struct WriteStyle {
  bool flow = false;  ///< within brackets: one line
  char was = '\0';    ///< first byte of the old value
};

/// What stands after "field:" or "-" (with the blank before it), or on the lines below it, `indent` deep. Lines end
/// with `newline`; the last has none.
std::string yaml_after(const YamlNode& value, std::size_t indent, const WriteStyle& style, const std::string& newline);
/// What yaml_after gave for a list's entry: its first line stands beside the dash.
std::string beside_dash(const std::string& after, std::size_t indent, const std::string& newline);
/// The same of a value that is written on one line, without the blank; empty: it needs more than one.
std::string yaml_inline(const YamlNode& value, const WriteStyle& style);

}  // namespace vallecula::curricula
