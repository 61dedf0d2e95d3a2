// Comma-separated values as RFC 4180 has them (private to the library).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vallecula::curricula {

/// A cell of text: quoted where it holds a comma, a quote or a line break. A text that a spreadsheet would take for a
/// formula (it begins with =, +, -, @, a tab or a line break) gets an apostrophe before it, which spreadsheets do not
/// show.
std::string csv_text(const std::string& text);
/// The shortest decimal number that reads back to the same bits, with a dot in every country; empty: there is none, or
/// it is not finite.
std::string csv_number(std::optional<double> value);
/// Cells that are ready, joined, with the line's end (CR LF).
std::string csv_line(const std::vector<std::string>& cells);

/// One column of a table for a person who reads it: in exports, in the README, in `vallecula records columns`.
struct ColumnText {
  std::string name, unit, definition, source;
};
/// As a Markdown table with this heading line.
std::string column_table(const std::vector<ColumnText>& columns);

}  // namespace vallecula::curricula
