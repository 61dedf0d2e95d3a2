// What the bytes of a SpaceMouse's HID reports mean. No I/O: any bytes may come in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace vallecula::device {

/// The cap as last reported. Axes of the cap: x to the right, y towards the person, z down; rotations right-handed
/// about them. Raw counts, about +-350 at the stops.
struct SpaceMouseState {
  std::array<std::int16_t, 3> translation{0, 0, 0};
  std::array<std::int16_t, 3> rotation{0, 0, 0};
  std::uint32_t buttons = 0;              ///< bit 0: the first button
  std::uint32_t translation_reports = 0;  ///< counted, so that a reader sees when the device falls silent
  std::uint32_t rotation_reports = 0;
};

/// Longest report any model sends, with room to spare; longer ones are cut by the reader.
constexpr std::size_t kLongestReport = 64;

/// Takes one input report (its number first) into `state`. Both layouts are understood by their length: translation in
/// report 1 and rotation in report 2, or all six axes in report 1; buttons are report 3. Returns false, and changes
/// nothing, for reports that are too short and for numbers that tell something else (battery, firmware).
bool apply_report(const std::uint8_t* data, std::size_t size, SpaceMouseState& state) noexcept;

}  // namespace vallecula::device
