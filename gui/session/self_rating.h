// What trainees think of their own trial before they see its score.
#pragma once

#include <filesystem>
#include <optional>

namespace vallecula::gui {

struct SelfRating {
  int global = 0;                         ///< 1 to 5
  std::optional<bool> tube_in_trachea{};  ///< of a trial with a tube
  std::optional<bool> sure{};             ///< of that
};

/// Keeps it as self-rating.json beside the log, with the time. Throws std::runtime_error.
void keep_self_rating(const std::filesystem::path& log, const SelfRating& rating);

}  // namespace vallecula::gui
