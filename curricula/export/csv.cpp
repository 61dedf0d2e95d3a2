#include "curricula/export/csv.h"

#include <charconv>
#include <cmath>

namespace vallecula::curricula {

std::string csv_text(const std::string& text) {
  std::string cell = text;
  if (!cell.empty() && std::string("=+-@\t\r\n").find(cell.front()) != std::string::npos) cell.insert(0, 1, '\'');
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_number(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return {};
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, *value).ptr;
  return {text, end};
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : ",") + cells[i];
  return line + "\r\n";
}

std::string column_table(const std::vector<ColumnText>& columns) {
  std::string table = "| column | unit | is | source |\n|---|---|---|---|\n";
  for (const ColumnText& column : columns)
    table += "| `" + column.name + "` | " + column.unit + " | " + column.definition + " | " + column.source + " |\n";
  return table;
}

}  // namespace vallecula::curricula
