#include "device/drivers/spacemouse/spacemouse_report.h"

#include <algorithm>

namespace vallecula::device {
namespace {

constexpr std::uint8_t kTranslation = 1, kRotation = 2, kButtons = 3;
constexpr std::size_t kThreeAxes = 1 + 3 * 2, kSixAxes = 1 + 6 * 2;
constexpr std::size_t kButtonBytes =
    4;  // what a mask of 32 bits holds; models with more name their keys by other reports

/// Signed, low byte first.
std::array<std::int16_t, 3> three_axes(const std::uint8_t* data) noexcept {
  std::array<std::int16_t, 3> axes;
  for (std::size_t i = 0; i < 3; ++i)
    axes[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(data[2 * i] | data[2 * i + 1] << 8));
  return axes;
}

}  // namespace

bool apply_report(const std::uint8_t* data, std::size_t size, SpaceMouseState& state) noexcept {
  if (data == nullptr || size < 2) return false;
  if (data[0] == kTranslation && size >= kThreeAxes) {
    state.translation = three_axes(data + 1);
    ++state.translation_reports;
    if (size >= kSixAxes) {
      state.rotation = three_axes(data + kThreeAxes);
      ++state.rotation_reports;
    }
    return true;
  }
  if (data[0] == kRotation && size >= kThreeAxes) {
    state.rotation = three_axes(data + 1);
    ++state.rotation_reports;
    return true;
  }
  if (data[0] == kButtons) {
    state.buttons = 0;
    for (std::size_t i = 0; i < std::min(size - 1, kButtonBytes); ++i)
      state.buttons |= static_cast<std::uint32_t>(data[1 + i]) << (8 * i);
    return true;
  }
  return false;
}

}  // namespace vallecula::device
