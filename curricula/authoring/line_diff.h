// What two texts have in common, line by line.
#pragma once

#include <string>
#include <vector>

namespace vallecula::curricula {

struct DiffLine {
  enum class Kind { same, removed, added };
  Kind kind = Kind::same;
  int old_line = 0, new_line = 0;  ///< from 1; 0: not in that text
  std::string text;
};

/// From `before` to `after`, over a longest common subsequence of lines. Texts whose changed part has more than 4000
/// lines on both sides are told as all removed and all added there: the table grows with the product.
std::vector<DiffLine> line_diff(const std::string& before, const std::string& after);

}  // namespace vallecula::curricula
