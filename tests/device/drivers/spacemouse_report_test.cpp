#include "device/drivers/spacemouse/spacemouse_report.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

namespace vallecula::device {
namespace {

using Axes = std::array<std::int16_t, 3>;

bool take(const std::vector<std::uint8_t>& bytes, SpaceMouseState& state) {
  return apply_report(bytes.data(), bytes.size(), state);
}

bool same(const SpaceMouseState& a, const SpaceMouseState& b) {
  return a.translation == b.translation && a.rotation == b.rotation && a.buttons == b.buttons &&
         a.translation_reports == b.translation_reports && a.rotation_reports == b.rotation_reports;
}

/// Bytes as recorded from a SpaceNavigator on the bus: ffe2 is -30.
TEST(SpaceMouseReport, OldLayoutTellsTranslationAndRotationApart) {
  SpaceMouseState state;
  EXPECT_TRUE(take({1, 0x5e, 0x01, 0xa2, 0xfe, 0x00, 0x80}, state));
  EXPECT_EQ(state.translation, (Axes{350, -350, -32768}));
  EXPECT_EQ(state.rotation, (Axes{0, 0, 0}));
  EXPECT_TRUE(take({2, 0x00, 0x00, 0xe2, 0xff, 0x00, 0x00}, state));
  EXPECT_EQ(state.rotation, (Axes{0, -30, 0}));
  EXPECT_EQ(state.translation, (Axes{350, -350, -32768}));
  EXPECT_EQ(state.translation_reports, 1u);
  EXPECT_EQ(state.rotation_reports, 1u);
}

TEST(SpaceMouseReport, NewLayoutTellsAllSixAtOnce) {
  SpaceMouseState state;
  EXPECT_TRUE(take({1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 0xfa, 0xff}, state));
  EXPECT_EQ(state.translation, (Axes{1, 2, 3}));
  EXPECT_EQ(state.rotation, (Axes{4, 5, -6}));
  EXPECT_TRUE(take({1, 7, 0, 8, 0, 9, 0}, state)) << "the same model may split it";
  EXPECT_EQ(state.translation, (Axes{7, 8, 9}));
  EXPECT_EQ(state.rotation, (Axes{4, 5, -6}));
  EXPECT_EQ(state.translation_reports, 2u);
  EXPECT_EQ(state.rotation_reports, 1u);
}

TEST(SpaceMouseReport, ButtonsAreAMaskOfOneToFourBytes) {
  SpaceMouseState state;
  EXPECT_TRUE(take({3, 0x02, 0x00}, state));
  EXPECT_EQ(state.buttons, 2u);
  EXPECT_TRUE(take({3, 0x01}, state));
  EXPECT_EQ(state.buttons, 1u);
  EXPECT_TRUE(take({3, 1, 2, 4, 0x80, 0xff, 0xff}, state));
  EXPECT_EQ(state.buttons, 0x80040201u);
  EXPECT_TRUE(take({3, 0, 0}, state));
  EXPECT_EQ(state.buttons, 0u);
}

TEST(SpaceMouseReport, RepeatedItSaysTheSame) {
  SpaceMouseState once, often;
  const std::vector<std::uint8_t> held = {1, 10, 0, 20, 0, 30, 0};
  take(held, once);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(take(held, often));
  EXPECT_EQ(often.translation, once.translation);
  EXPECT_EQ(often.translation_reports, 5u);
}

TEST(SpaceMouseReport, ShortAndForeignReportsChangeNothing) {
  SpaceMouseState state;
  take({1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0}, state);
  take({3, 5}, state);
  const SpaceMouseState before = state;
  EXPECT_FALSE(apply_report(nullptr, 0, state));
  for (const std::uint8_t number : {1, 2}) {
    for (std::size_t size = 0; size < 7; ++size) {
      std::vector<std::uint8_t> bytes(size, 0xff);
      if (size > 0) bytes[0] = number;
      EXPECT_FALSE(take(bytes, state)) << int(number) << " with " << size << " bytes";
    }
  }
  EXPECT_FALSE(take({3}, state));
  EXPECT_FALSE(take({0x17, 100, 0}, state)) << "the battery";
  EXPECT_FALSE(take({0, 1, 2, 3, 4, 5, 6}, state));
  EXPECT_TRUE(same(state, before));
}

/// Whatever is taken is what the bytes say by another way of reading them; nothing beyond the size is read (the vector
/// ends there: the address sanitizer would see it).
TEST(SpaceMouseReport, AgreesWithAPlainReadingOnAnyBytes) {
  std::mt19937 random(7);
  for (int round = 0; round < 200000; ++round) {
    std::vector<std::uint8_t> bytes(random() % 20);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    if (!bytes.empty() && round % 4 != 0) bytes[0] = static_cast<std::uint8_t>(random() % 4);
    SpaceMouseState state;
    const bool taken = take(bytes, state);
    const auto number = bytes.empty() ? 0 : bytes[0];
    ASSERT_EQ(taken, ((number == 1 || number == 2) && bytes.size() >= 7) || (number == 3 && bytes.size() >= 2));
    if (!taken || number == 3) continue;
    Axes read;
    std::memcpy(read.data(), bytes.data() + 1, 6);  // this machine is little-endian, as the reports are
    ASSERT_EQ(number == 1 ? state.translation : state.rotation, read);
    if (number != 1 || bytes.size() < 13) continue;
    std::memcpy(read.data(), bytes.data() + 7, 6);
    ASSERT_EQ(state.rotation, read);
  }
}

}  // namespace
}  // namespace vallecula::device
