#include "curricula/authoring/line_diff.h"

#include <algorithm>
#include <cstdint>

namespace vallecula::curricula {
namespace {

constexpr std::size_t kLongest = 4000;  ///< lines on each side; 16 million cells of two bytes

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at - (end > at && text[end - 1] == '\r' ? 1 : 0)));
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::vector<DiffLine> line_diff(const std::string& before, const std::string& after) {
  const std::vector<std::string> a = lines_of(before), b = lines_of(after);
  std::size_t head = 0, tail = 0;
  while (head < a.size() && head < b.size() && a[head] == b[head]) ++head;
  while (tail < a.size() - head && tail < b.size() - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) ++tail;
  const std::size_t rows = a.size() - head - tail, columns = b.size() - head - tail;

  // common[i][j]: lines in common from a[head + i] and b[head + j] on.
  const bool compared = rows <= kLongest && columns <= kLongest;
  std::vector<std::uint16_t> common(compared ? (rows + 1) * (columns + 1) : 0, 0);
  const auto at = [&](std::size_t i, std::size_t j) -> std::uint16_t& { return common[i * (columns + 1) + j]; };
  for (std::size_t i = compared ? rows : 0; i-- > 0;)
    for (std::size_t j = columns; j-- > 0;)
      at(i, j) = a[head + i] == b[head + j] ? static_cast<std::uint16_t>(at(i + 1, j + 1) + 1)
                                            : std::max(at(i + 1, j), at(i, j + 1));

  std::vector<DiffLine> lines;
  std::size_t i = 0, j = 0;
  const auto same = [&] {
    lines.push_back({DiffLine::Kind::same, static_cast<int>(++i), static_cast<int>(++j), a[i - 1]});
  };
  while (i < head) same();
  while (i < head + rows || j < head + columns) {
    const std::size_t r = i - head, c = j - head;
    if (compared && r < rows && c < columns && a[i] == b[j]) {
      same();
    } else if (r < rows && (c == columns || !compared || at(r + 1, c) >= at(r, c + 1))) {
      lines.push_back({DiffLine::Kind::removed, static_cast<int>(i + 1), 0, a[i]});
      ++i;
    } else {
      lines.push_back({DiffLine::Kind::added, 0, static_cast<int>(j + 1), b[j]});
      ++j;
    }
  }
  while (i < a.size()) same();
  return lines;
}

}  // namespace vallecula::curricula
