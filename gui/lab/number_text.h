// Numbers as files and options write them: a decimal point, whatever the user's language writes.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace vallecula::gui {

/// The whole text as a finite number; nothing if it is anything else.
inline std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace vallecula::gui
