#include "curricula/authoring/yaml_write.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstring>

namespace vallecula::curricula {
namespace {

constexpr std::size_t kWidth = 110;  ///< of a folded text's lines

/// Unquoted, other readers of YAML would take it for a number or a yes.
bool looks_like_no_text(const std::string& value) {
  static const std::array<const char*, 9> words{"true", "false", "null", "yes", "no", "on", "off", "y", "n"};
  std::string lower = value;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(words.begin(), words.end(), lower) != words.end() ||
         std::strspn(value.c_str(), "0123456789.,:eE+-_") == value.size();
}

/// Needs no quotes, wherever it stands.
bool plain_is_safe(const std::string& value, bool flow) {
  if (value.empty() || value.front() == ' ' || value.back() == ' ') return false;
  const auto first = static_cast<unsigned char>(value[0]);
  if (std::isalnum(first) == 0 && first < 0x80) return false;
  if (value.find(": ") != std::string::npos || value.find(" #") != std::string::npos || value.back() == ':')
    return false;
  if (flow && value.find_first_of(",[]{}:") != std::string::npos) return false;
  return std::none_of(value.begin(), value.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

std::string double_quoted(const std::string& value) {
  std::string out = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\x%02x", static_cast<unsigned>(c));
      out += code.data();
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string inline_scalar(const YamlNode& value, const WriteStyle& style) {
  if (!value.is_text)
    return plain_is_safe(value.value, style.flow) || value.value[0] == '-' ? value.value : double_quoted(value.value);
  const bool plain = style.was != '"' && style.was != '\'' && plain_is_safe(value.value, style.flow) &&
                     !looks_like_no_text(value.value);
  return plain ? value.value : double_quoted(value.value);
}

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t at = 0;
  for (std::size_t stop; (stop = text.find('\n', at)) != std::string::npos; at = stop + 1)
    lines.push_back(text.substr(at, stop - at));
  if (at < text.size()) lines.push_back(text.substr(at));
  return lines;
}

/// A block can hold it: no other control characters, and a first line that shows the indentation.
bool fits_block(const std::string& value) {
  if (value.find_first_not_of('\n') == std::string::npos || value[0] == ' ' || value[0] == '\n') return false;
  if (value.size() > 1 && value.compare(value.size() - 2, 2, "\n\n") == 0) return false;
  return std::none_of(value.begin(), value.end(), [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7f; });
}

std::string wrapped(const std::string& line, const std::string& margin, const std::string& newline) {
  std::string out;
  std::size_t at = 0;
  while (line.size() - at > kWidth) {
    std::size_t cut = line.rfind(' ', at + kWidth);
    // A line that begins or ends with a blank would not fold back to the same.
    while (cut != std::string::npos && cut > at && (line[cut - 1] == ' ' || line[cut + 1] == ' '))
      cut = line.rfind(' ', cut - 1);
    if (cut == std::string::npos || cut <= at) break;
    out += margin + line.substr(at, cut - at) + newline;
    at = cut + 1;
  }
  return out + margin + line.substr(at);
}

std::string block_scalar(const std::string& value, std::size_t indent, char was, const std::string& newline) {
  const std::vector<std::string> lines = lines_in(value);
  const bool folds = was == '>' && std::none_of(lines.begin(), lines.end(), [](const std::string& line) {
                       return !line.empty() && (line[0] == ' ' || line[0] == '\t' || line.back() == ' ');
                     });
  const std::string margin(indent, ' ');
  std::string out = std::string(" ") + (folds ? ">" : "|") + (value.back() == '\n' ? "" : "-");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (folds && i > 0 && !lines[i - 1].empty()) out += newline;  // a line's end is an empty line more
    out += newline;
    if (!lines[i].empty()) out += folds ? wrapped(lines[i], margin, newline) : margin + lines[i];
  }
  return out;
}

}  // namespace

std::string yaml_inline(const YamlNode& value, const WriteStyle& style) {
  const WriteStyle inner{true, '\0'};
  std::string out;
  if (value.kind == YamlNode::Kind::scalar) {
    const bool block = !style.flow && fits_block(value.value) &&
                       (value.value.find('\n') != std::string::npos || style.was == '|' || style.was == '>');
    return block ? "" : inline_scalar(value, style);
  }
  const bool list = value.kind == YamlNode::Kind::list;
  const bool short_list = list && std::all_of(value.children.begin(), value.children.end(), [](const YamlNode& c) {
                            return c.kind == YamlNode::Kind::scalar && c.value.size() <= 30;
                          });
  if (!style.flow && !short_list && !value.children.empty()) return "";
  for (const YamlNode& child : value.children)
    out += (out.empty() ? "" : ", ") + (list ? "" : child.key + ": ") + yaml_inline(child, inner);
  return list ? "[" + out + "]" : "{ " + out + " }";
}

std::string beside_dash(const std::string& after, std::size_t indent, const std::string& newline) {
  const bool below = after.compare(0, newline.size(), newline) == 0;
  return below ? " " + after.substr(newline.size() + indent) : after;
}

std::string yaml_after(const YamlNode& value, std::size_t indent, const WriteStyle& style, const std::string& newline) {
  const std::string one_line = yaml_inline(value, style);
  if (!one_line.empty()) return " " + one_line;
  if (value.kind == YamlNode::Kind::scalar) return block_scalar(value.value, indent, style.was, newline);
  const std::string margin(indent, ' ');
  std::string out;
  for (const YamlNode& child : value.children) {
    out += newline + margin;
    if (value.kind == YamlNode::Kind::group) {
      out += child.key + ":" + yaml_after(child, indent + 2, {}, newline);
      continue;
    }
    out += "-" + beside_dash(yaml_after(child, indent + 2, {}, newline), indent + 2, newline);
  }
  return out;
}

}  // namespace vallecula::curricula
