#include "curricula/authoring/yaml_edit.h"

#include <algorithm>
#include <stdexcept>

#include "curricula/authoring/yaml_write.h"

namespace vallecula::curricula {
namespace {

[[noreturn]] void refuse(const std::string& path) {
  throw std::runtime_error((path.empty() ? "the document" : path) +
                           " is written in a way that cannot be changed here; change it in the text");
}

std::string newline_of(const std::string& text) { return text.find("\r\n") == std::string::npos ? "\n" : "\r\n"; }

std::size_t line_begin(const std::string& text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return before == std::string::npos ? 0 : before + 1;
}
std::size_t line_end(const std::string& text, std::size_t at) {
  const std::size_t end = std::min(text.find('\n', at), text.size());
  return end > at && text[end - 1] == '\r' ? end - 1 : end;
}
std::size_t next_line(const std::string& text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string::npos ? text.size() : end + 1;
}
std::size_t column(const std::string& text, std::size_t at) {
  const std::size_t begin = line_begin(text, at);
  return at - begin - (begin == 0 && text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0);
}

std::string spliced(const std::string& text, std::size_t begin, std::size_t end, const std::string& with) {
  return text.substr(0, begin) + with + text.substr(end);
}

/// "a.b[3]" -> "a.b" and "[3]".
std::pair<std::string, std::string> parent_of(const std::string& path) {
  const std::size_t cut = path.find_last_of(".[");
  if (cut == std::string::npos) return {"", path};
  return {path.substr(0, cut), path[cut] == '[' ? path.substr(cut) : path.substr(cut + 1)};
}

YamlNode* find_in(YamlNode& root, const std::string& path) {
  YamlNode* node = &root;
  for (const YamlStep& step : yaml_steps(path)) {
    const auto found = step.key.empty() ? node->children.begin() +
                                              static_cast<std::ptrdiff_t>(std::min(step.index, node->children.size()))
                                        : std::find_if(node->children.begin(), node->children.end(),
                                                       [&](const YamlNode& child) { return child.key == step.key; });
    if (found == node->children.end()) return nullptr;
    node = &*found;
  }
  return node;
}

/// The only way out: what was written must read as what was meant, and everything else as before.
std::string checked(std::string text, const YamlNode& meant, const std::string& path) {
  if (!same_value(YamlText(text).root(), meant)) refuse(path);
  return text;
}

/// A list's entries as pieces of the text, with what stands between them.
struct Pieces {
  std::size_t begin = 0, end = 0;          ///< of all
  std::vector<std::string> entries, gaps;  ///< one gap less than entries
  std::size_t dash_column = 0;             ///< of a list in lines
};

/// The dash before an entry, which stands first on its line.
std::size_t dash_of(const std::string& text, const YamlNode& item, const std::string& path) {
  std::size_t at = item.begin;
  while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\n' || text[at - 1] == '\r')) --at;
  const std::size_t begin = at == 0 ? 0 : line_begin(text, at);
  if (at == 0 || text[at - 1] != '-' || text.find_first_not_of(' ', begin) != at - 1) refuse(path);
  return at - 1;
}

/// Comments right above an entry, indented as it is, belong to it.
std::size_t with_comments(const std::string& text, std::size_t dash) {
  const std::size_t indent = column(text, dash);
  std::size_t begin = line_begin(text, dash);
  while (begin > 0) {
    const std::size_t above = line_begin(text, begin - 1);
    const std::size_t first = text.find_first_not_of(' ', above);
    if (first >= begin || text[first] != '#' || first - above != indent) break;
    begin = above;
  }
  return begin;
}

Pieces pieces_of(const std::string& text, const YamlNode& list, const std::string& path) {
  if (list.kind != YamlNode::Kind::list || list.children.empty()) refuse(path);
  Pieces pieces;
  std::size_t last = 0;
  for (const YamlNode& item : list.children) {
    const std::size_t dash = list.flow ? item.begin : dash_of(text, item, path);
    const std::size_t begin = list.flow ? item.begin : with_comments(text, dash);
    const std::size_t end = list.flow ? item.end : line_end(text, item.end);
    if (pieces.entries.empty()) {
      pieces.begin = begin;
      pieces.dash_column = list.flow ? 0 : column(text, dash);
    } else {
      pieces.gaps.push_back(text.substr(last, begin - last));
    }
    pieces.entries.push_back(text.substr(begin, end - begin));
    last = end;
  }
  pieces.end = last;
  return pieces;
}

std::string put_together(const std::string& text, const Pieces& pieces) {
  std::string all = pieces.entries[0];
  for (std::size_t i = 1; i < pieces.entries.size(); ++i) all += pieces.gaps[i - 1] + pieces.entries[i];
  return spliced(text, pieces.begin, pieces.end, all);
}

/// Every line of a piece of text, `by` columns to the right (or left).
std::string shifted(const std::string& lines, std::ptrdiff_t by) {
  std::string out;
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t next = next_line(lines, at);
    std::string line = lines.substr(at, next - at);
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    if (line.find_first_not_of(" \r\n") != std::string::npos) {
      if (by > 0) line.insert(0, static_cast<std::size_t>(by), ' ');
      if (by < 0) line.erase(0, std::min(blanks, static_cast<std::size_t>(-by)));
    }
    out += line;
    at = next;
  }
  return out;
}

std::string insert_piece(const YamlText& text, const std::string& path, std::size_t to, const std::string& piece) {
  const YamlNode& list = *text.find(path);
  Pieces pieces = pieces_of(text.text(), list, path);
  const std::string newline = newline_of(text.text());
  std::string gap = list.flow ? ", " : newline;
  // Entries that are set apart by an empty line stay so.
  if (!pieces.gaps.empty() && pieces.gaps[0].find_first_not_of(list.flow ? ", " : "\r\n") == std::string::npos)
    gap = pieces.gaps[0];
  to = std::min(to, pieces.entries.size());
  pieces.entries.insert(pieces.entries.begin() + static_cast<std::ptrdiff_t>(to), piece);
  const std::size_t at = to == pieces.entries.size() - 1 ? pieces.gaps.size() : to;
  pieces.gaps.insert(pieces.gaps.begin() + static_cast<std::ptrdiff_t>(at), gap);
  return put_together(text.text(), pieces);
}

YamlNode meant_with_item(const YamlText& text, const std::string& path, std::size_t to, YamlNode item) {
  YamlNode meant = text.root();
  auto& items = find_in(meant, path)->children;
  item.key.clear();
  items.insert(items.begin() + static_cast<std::ptrdiff_t>(std::min(to, items.size())), std::move(item));
  return meant;
}

void add_field(YamlNode& group, const std::string& key, const YamlNode& value) {
  group.children.push_back(value);
  group.children.back().key = key;
}

/// Behind the last field of a group that is there.
std::string with_field_added(const std::string& text, const YamlNode& group, const std::string& key,
                             const YamlNode& value) {
  const std::string newline = newline_of(text);
  if (group.flow) {
    const std::string field = key + ": " + yaml_inline(value, {true, '\0'});
    if (group.children.empty()) return spliced(text, group.begin, group.end, "{ " + field + " }");
    return spliced(text, group.children.back().end, group.children.back().end, ", " + field);
  }
  const std::size_t at = line_end(text, group.end), indent = column(text, group.children.front().key_begin);
  return spliced(text, at, at,
                 newline + std::string(indent, ' ') + key + ":" + yaml_after(value, indent + 2, {}, newline));
}

}  // namespace

std::string with_value(const YamlText& yaml, const std::string& path, const YamlNode& value) {
  const std::string& text = yaml.text();
  const auto [parent_path, last] = parent_of(path);
  const YamlNode* node = yaml.find(path);
  const YamlNode* parent = yaml.find(parent_path);
  YamlNode meant = yaml.root();
  if (node == nullptr) {
    if (last.empty() || last[0] == '[') refuse(path);
    const bool is_group =
        parent != nullptr && parent->kind == YamlNode::Kind::group && (parent->flow || !parent->children.empty());
    if (!is_group) {
      if (parent_path.empty() || (parent != nullptr && !parent->value.empty())) refuse(path);
      return with_value(yaml, parent_path, yaml_group({{last, value}}));
    }
    add_field(*find_in(meant, parent_path), last, value);
    return checked(with_field_added(text, *parent, last, value), meant, path);
  }
  YamlNode& there = *find_in(meant, path);
  const std::string key = there.key;
  there = value;
  there.key = key;
  const std::string newline = newline_of(text);
  const WriteStyle style{parent->flow, node->value.empty() && node->children.empty() ? '\0' : text[node->begin]};
  const std::string one_line = yaml_inline(value, style);
  const bool was_line = node->kind == YamlNode::Kind::scalar && style.was != '|' && style.was != '>';
  if (!one_line.empty() && (was_line || node->flow) && node->begin < node->end)
    return checked(spliced(text, node->begin, node->end, one_line), meant, path);
  const std::size_t indent =
      (key.empty() ? column(text, dash_of(text, *node, path)) : column(text, node->key_begin)) + 2;
  const std::size_t from = key.empty() ? dash_of(text, *node, path) + 1 : node->key_end;
  std::string after = yaml_after(value, indent, style, newline);
  if (key.empty()) after = beside_dash(after, indent, newline);
  // A comment behind the old value stays on its line.
  const std::size_t end = std::max(from, node->end), first = std::min(after.find(newline), after.size());
  const std::string comment = text.substr(end, line_end(text, end) - end);
  after.insert(first, comment);
  return checked(spliced(text, from, end + comment.size(), after), meant, path);
}

std::string without_value(const YamlText& yaml, const std::string& path) {
  const std::string& text = yaml.text();
  const auto [parent_path, last] = parent_of(path);
  const YamlNode *node = yaml.find(path), *parent = yaml.find(parent_path);
  if (node == nullptr) return text;
  if (parent->kind == YamlNode::Kind::list) return without_item(yaml, parent_path, yaml_steps(last)[0].index);
  if (parent->children.size() == 1) {
    if (parent_path.empty()) refuse(path);
    return without_value(yaml, parent_path);
  }
  YamlNode meant = yaml.root();
  auto& fields = find_in(meant, parent_path)->children;
  const auto index = static_cast<std::size_t>(node - parent->children.data());
  fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(index));
  std::size_t begin = node->key_begin, end = node->end;
  if (index == 0) {  // it may stand behind a dash or a brace
    end = parent->children[1].key_begin;
  } else if (parent->flow) {
    begin = parent->children[index - 1].end;
  } else {
    begin = line_begin(text, begin);
    end = next_line(text, end);
    if (end == text.size() && text.back() != '\n' && begin > 0) begin = line_end(text, line_begin(text, begin - 1));
  }
  return checked(spliced(text, begin, end, ""), meant, path);
}

std::string with_item_moved(const YamlText& yaml, const std::string& path, std::size_t from, std::size_t to) {
  const YamlNode* list = yaml.find(path);
  if (list == nullptr || from >= list->children.size() || to >= list->children.size()) refuse(path);
  const auto move = [&](auto& entries) {
    auto entry = std::move(entries[from]);
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(from));
    entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(to), std::move(entry));
  };
  Pieces pieces = pieces_of(yaml.text(), *list, path);
  move(pieces.entries);
  YamlNode meant = yaml.root();
  move(find_in(meant, path)->children);
  return checked(put_together(yaml.text(), pieces), meant, path);
}

std::string without_item(const YamlText& yaml, const std::string& path, std::size_t index) {
  const YamlNode* list = yaml.find(path);
  if (list == nullptr || index >= list->children.size()) refuse(path);
  if (list->children.size() == 1) return without_value(yaml, path);
  Pieces pieces = pieces_of(yaml.text(), *list, path);
  pieces.entries.erase(pieces.entries.begin() + static_cast<std::ptrdiff_t>(index));
  pieces.gaps.erase(pieces.gaps.begin() + static_cast<std::ptrdiff_t>(std::min(index, pieces.gaps.size() - 1)));
  YamlNode meant = yaml.root();
  auto& items = find_in(meant, path)->children;
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(index));
  return checked(put_together(yaml.text(), pieces), meant, path);
}

std::string with_item_copied(const YamlText& yaml, const std::string& path, std::size_t to, const YamlText& from,
                             const std::string& from_path, std::size_t index) {
  const YamlNode *list = yaml.find(path), *source = from.find(from_path);
  if (list == nullptr || source == nullptr || index >= source->children.size()) refuse(path);
  const YamlNode& item = source->children[index];
  if (list->flow || source->flow) {
    YamlNode copy = item;
    return with_item(yaml, path, to, copy);
  }
  const Pieces theirs = pieces_of(from.text(), *source, from_path), ours = pieces_of(yaml.text(), *list, path);
  std::string piece = shifted(theirs.entries[index], static_cast<std::ptrdiff_t>(ours.dash_column) -
                                                         static_cast<std::ptrdiff_t>(theirs.dash_column));
  return checked(insert_piece(yaml, path, to, piece), meant_with_item(yaml, path, to, item), path);
}

std::string with_item(const YamlText& yaml, const std::string& path, std::size_t to, const YamlNode& item) {
  const YamlNode* list = yaml.find(path);
  if (list == nullptr || list->children.empty()) return with_value(yaml, path, yaml_list({item}));
  const std::string newline = newline_of(yaml.text());
  std::string piece = yaml_inline(item, {true, '\0'});
  if (!list->flow) {
    const std::size_t dash = pieces_of(yaml.text(), *list, path).dash_column;
    piece = std::string(dash, ' ') + "-" + beside_dash(yaml_after(item, dash + 2, {}, newline), dash + 2, newline);
  }
  return checked(insert_piece(yaml, path, to, piece), meant_with_item(yaml, path, to, item), path);
}

}  // namespace vallecula::curricula
