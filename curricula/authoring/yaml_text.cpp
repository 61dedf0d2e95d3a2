#include "curricula/authoring/yaml_text.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdlib>

#include "curricula/scenario.h"
#include "curricula/schema/safe_yaml.h"

namespace vallecula::curricula {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Finds where the values of a parsed document end: the parser says only where they begin.
class Locator {
 public:
  explicit Locator(const std::string& text) : text_(text), shift_(text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0) {}

  YamlNode locate(const YAML::Node& node, std::size_t after) const {
    YamlNode out;
    const bool given = !node.IsNull();
    out.begin = given ? static_cast<std::size_t>(node.Mark().pos) + shift_ : after;
    out.line = node.Mark().line + 1;
    if (node.IsMap()) {
      out.kind = YamlNode::Kind::group;
      out.flow = node.Style() == YAML::EmitterStyle::Flow;
      for (const auto& entry : node) {
        if (!entry.first.IsScalar()) refuse(out.begin);
        const std::size_t key_begin = static_cast<std::size_t>(entry.first.Mark().pos) + shift_;
        const std::size_t colon = text_.find_first_not_of(" \t", scalar_end(entry.first, key_begin));
        if (colon == std::string::npos || text_[colon] != ':') refuse(key_begin);
        YamlNode child = locate(entry.second, colon + 1);
        child.key = entry.first.Scalar();
        child.key_begin = key_begin;
        child.key_end = colon + 1;
        if (entry.second.IsNull()) child.line = entry.first.Mark().line + 1;
        out.children.push_back(std::move(child));
      }
    } else if (node.IsSequence()) {
      out.kind = YamlNode::Kind::list;
      out.flow = node.Style() == YAML::EmitterStyle::Flow;
      std::size_t last = out.begin;
      for (const auto& item : node) {
        out.children.push_back(locate(item, last));
        last = out.children.back().end;
      }
    } else {
      out.value = given ? node.Scalar() : "";
      out.is_text = given && node.Tag() != "?";
      out.end = given ? scalar_end(node, out.begin) : empty_end(after);
      return out;
    }
    out.end = out.children.empty() ? out.begin + 1 : out.children.back().end;
    if (out.flow) out.end = past_bracket(out.end, out.kind == YamlNode::Kind::group ? '}' : ']');
    return out;
  }

 private:
  [[noreturn]] void refuse(std::size_t at) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw CurriculumError("line " + std::to_string(line) +
                          ": written in a way that can only be changed as text; allowed: fields, lists, values");
  }

  /// "~" or "null" written out, or nothing.
  std::size_t empty_end(std::size_t after) const {
    const std::size_t at = text_.find_first_not_of(" \t", after);
    if (at != std::string::npos && text_[at] == '~') return at + 1;
    if (at != std::string::npos && text_.compare(at, 4, "null") == 0) return at + 4;
    return after;
  }

  std::size_t past_bracket(std::size_t at, char closing) const {
    while (at < text_.size() && text_[at] != closing) {
      if (text_[at] == '#')
        at = std::min(text_.find('\n', at), text_.size());
      else if (is_space(text_[at]) || text_[at] == ',')
        ++at;
      else
        refuse(at);
    }
    return at + 1;
  }

  std::size_t scalar_end(const YAML::Node& node, std::size_t begin) const {
    const char first = begin < text_.size() ? text_[begin] : '\0';
    if (node.Tag() != "?") {
      if (first == '"' || first == '\'') return quoted_end(begin, first);
      if (first == '|' || first == '>') return block_end(node.Scalar(), begin);
      refuse(begin);
    }
    std::size_t at = begin;  // plain: the same characters, but that any space may be a line's end
    for (const char c : node.Scalar()) {
      if (c == ' ' || c == '\n') {
        while (at < text_.size() && is_space(text_[at])) ++at;
      } else {
        if (at >= text_.size() || text_[at] != c) refuse(begin);
        ++at;
      }
    }
    return at;
  }

  std::size_t quoted_end(std::size_t begin, char quote) const {
    std::size_t at = begin + 1;
    for (; at < text_.size(); ++at) {
      if (quote == '"' && text_[at] == '\\') {
        ++at;
      } else if (text_[at] == quote) {
        if (quote == '"' || at + 1 >= text_.size() || text_[at + 1] != quote) return at + 1;
        ++at;  // '' stands for one
      }
    }
    refuse(begin);
  }

  /// The last line that is indented as the first is and not empty.
  std::size_t block_end(const std::string& value, std::size_t begin) const {
    std::size_t end = line_end(begin);
    const std::size_t header = text_.find_first_of("123456789", begin);
    if (header < end && text_.find('#', begin) > header) refuse(begin);  // its indentation is written out
    if (value.find_first_not_of(" \n") == std::string::npos) return end;
    std::size_t indent = std::string::npos;
    for (std::size_t at = next_line(end); at < text_.size();) {
      const std::size_t stop = line_end(at), content = text_.find_first_not_of(" ", at);
      if (content < stop) {
        if (indent == std::string::npos) indent = content - at;
        if (content - at < indent) break;
        end = stop;
      }
      at = next_line(stop);
    }
    return end;
  }

  std::size_t line_end(std::size_t at) const {
    std::size_t end = std::min(text_.find('\n', at), text_.size());
    if (end > at && text_[end - 1] == '\r') --end;
    return end;
  }
  std::size_t next_line(std::size_t at) const {
    const std::size_t end = text_.find('\n', at);
    return end == std::string::npos ? text_.size() : end + 1;
  }

  const std::string& text_;
  std::size_t shift_;
};

/// Calls `see(path, node)` for every node, the outer before the inner.
template <class See>
void walk(const YamlNode& node, const std::string& path, const See& see) {
  see(path, node);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const YamlNode& child = node.children[i];
    const std::string name = node.kind == YamlNode::Kind::list ? "[" + std::to_string(i) + "]"
                             : path.empty()                    ? child.key
                                                               : "." + child.key;
    walk(child, path + name, see);
  }
}

}  // namespace

const YamlNode* YamlNode::child(const std::string& name) const {
  if (kind != Kind::group) return nullptr;
  const auto found = std::find_if(children.begin(), children.end(), [&](const YamlNode& c) { return c.key == name; });
  return found == children.end() ? nullptr : &*found;
}

YamlNode yaml_plain(std::string value) {
  YamlNode node;
  node.value = std::move(value);
  return node;
}

YamlNode yaml_text(std::string value) {
  YamlNode node = yaml_plain(std::move(value));
  node.is_text = true;
  return node;
}

YamlNode yaml_list(std::vector<YamlNode> items) {
  YamlNode node;
  node.kind = YamlNode::Kind::list;
  node.children = std::move(items);
  return node;
}

YamlNode yaml_group(std::vector<std::pair<std::string, YamlNode>> fields) {
  YamlNode node;
  node.kind = YamlNode::Kind::group;
  for (auto& [key, value] : fields) {
    node.children.push_back(std::move(value));
    node.children.back().key = key;
  }
  return node;
}

bool same_value(const YamlNode& a, const YamlNode& b) {
  return a.kind == b.kind && a.key == b.key && a.value == b.value &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(), same_value);
}

std::vector<YamlStep> yaml_steps(const std::string& path) {
  std::vector<YamlStep> steps;
  for (std::size_t at = 0; at < path.size();) {
    if (path[at] == '[') {
      const std::size_t close = path.find(']', at);
      steps.push_back({"", static_cast<std::size_t>(std::strtoul(path.c_str() + at + 1, nullptr, 10))});
      at = close == std::string::npos ? path.size() : close + 1;
    } else {
      if (path[at] == '.') ++at;
      const std::size_t stop = std::min(path.find_first_of(".[", at), path.size());
      steps.push_back({path.substr(at, stop - at), 0});
      at = stop;
    }
  }
  return steps;
}

YamlText::YamlText(std::string text) : text_(std::move(text)) {
  root_ = Locator(text_).locate(parse_safely(text_, "the text"), 0);
}

const YamlNode* YamlText::find(const std::string& path) const {
  const YamlNode* node = &root_;
  for (const YamlStep& step : yaml_steps(path)) {
    if (!step.key.empty())
      node = node->child(step.key);
    else
      node = node->kind == YamlNode::Kind::list && step.index < node->children.size() ? &node->children[step.index]
                                                                                      : nullptr;
    if (node == nullptr) return nullptr;
  }
  return node;
}

std::string YamlText::path_at(int line) const {
  std::string best;
  walk(root_, "", [&](const std::string& path, const YamlNode& node) {
    if (!path.empty() && node.line <= line) best = path;
  });
  return best;
}

}  // namespace vallecula::curricula
