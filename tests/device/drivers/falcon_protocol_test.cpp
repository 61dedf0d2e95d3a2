#include "device/drivers/falcon/falcon_protocol.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace vallecula::device::falcon {
namespace {

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

/// What the firmware sends, written down by hand: low nibble first, 'A' for 0.
//   0x1234 -> 4 3 2 1, 0xffff -> f f f f, 0x8000 -> 0 0 0 8; all homed and buttons 1 and 4: 0x79 + 0x41 = 0xba.
const std::string kByHand = "<EDCBPPPPAAAI\xba\x41>";

TEST(FalconProtocol, ReadsAPacketWrittenByHand) {
  Packet packet{};
  std::copy(kByHand.begin(), kByHand.end(), packet.begin());
  const auto report = decode(packet);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->encoders, (std::array<std::int16_t, 3>{0x1234, -1, -32768}));
  EXPECT_EQ(report->homed, kAllHomed);
  EXPECT_EQ(report->buttons, 0x9);
}

TEST(FalconProtocol, WritesAPacketAsByHand) {
  Command command;
  command.motors = {0x0fff, -2, 0};
  command.lights = kRedLight;
  command.homing = true;
  const Packet packet = encode(command);
  EXPECT_EQ(std::string(packet.begin(), packet.end()), std::string("<PPPAOPPPAAAA\x4a\x41>"));
  command.homing = false;
  command.lights = 0xff;  // what is no light is not sent
  EXPECT_EQ(encode(command)[13], 0x41 + 0x0e);
}

TEST(FalconProtocol, EveryMotorValueIsItself) {
  for (int value = -32768; value <= 32767; ++value) {
    Command command;
    command.motors = {static_cast<std::int16_t>(value), static_cast<std::int16_t>(~value), 7};
    const auto report = decode(encode(command));  // the two ways share the form of their numbers
    ASSERT_TRUE(report);
    ASSERT_EQ(report->encoders, command.motors);
  }
}

TEST(FalconProtocol, RefusesWhatTheFirmwareCannotSend) {
  Packet good{};
  std::copy(kByHand.begin(), kByHand.end(), good.begin());
  for (std::size_t place = 0; place < kPacketBytes; ++place) {
    int accepted = 0;
    for (int value = 0; value < 256; ++value) {
      Packet packet = good;
      packet[place] = static_cast<std::uint8_t>(value);
      accepted += decode(packet).has_value();
    }
    const int permitted = place == 0 || place == 15 ? 1 : place == 13 ? 128 : place == 14 ? 255 : 16;
    EXPECT_EQ(accepted, permitted) << "place " << place;
  }
}

TEST(FalconProtocol, TakesOutTheStatusOfEveryBusPacket) {
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> payload;
  for (int packet = 0; packet < 3; ++packet) {
    bytes.push_back(0x01);
    bytes.push_back(0x60);
    for (int i = 0; i < (packet < 2 ? 62 : 5); ++i) {
      payload.push_back(static_cast<std::uint8_t>(100 + payload.size()));
      bytes.push_back(payload.back());
    }
  }
  const std::size_t left = strip_modem_status(bytes.data(), bytes.size());
  EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + left), payload);
  std::uint8_t status[2] = {0x01, 0x60};
  for (const std::size_t count : {0u, 1u, 2u}) EXPECT_EQ(strip_modem_status(status, count), 0u);
}

/// The rule that lets a person use it names the numbers the driver looks for.
TEST(FalconProtocol, TheUdevRuleNamesIt) {
  std::ifstream in(std::string(VALLECULA_SOURCE_DIR) + "/packaging/60-vallecula.rules");
  bool named = false;
  for (std::string line; std::getline(in, line);) {
    named = named || (line.rfind("SUBSYSTEM==\"usb\"", 0) == 0 && line.find("{idVendor}==\"0403\"") != line.npos &&
                      line.find("{idProduct}==\"cb48\"") != line.npos && line.find("uaccess") != line.npos);
  }
  EXPECT_TRUE(named);
  EXPECT_EQ(kVendor, 0x0403);
  EXPECT_EQ(kProduct, 0xcb48);
}

TEST(FalconReader, FindsAPacketHoweverItIsCut) {
  for (std::size_t cut = 0; cut <= kPacketBytes; ++cut) {
    PacketReader reader;
    const auto bytes = bytes_of(kByHand);
    const int found = reader.feed(bytes.data(), cut) + reader.feed(bytes.data() + cut, bytes.size() - cut);
    EXPECT_EQ(found, 1) << cut;
    EXPECT_EQ(reader.newest().encoders[0], 0x1234);
    EXPECT_EQ(reader.malformed(), 0u);
  }
}

TEST(FalconReader, ABrokenPacketCostsNoWholeOne) {
  const auto whole = bytes_of(kByHand);
  // Lost bytes at every place and of every number, the whole packet right behind.
  for (std::size_t from = 0; from < kPacketBytes; ++from) {
    for (std::size_t lost = 1; from + lost <= kPacketBytes; ++lost) {
      std::vector<std::uint8_t> bytes(whole.begin(), whole.begin() + from);
      bytes.insert(bytes.end(), whole.begin() + from + lost, whole.end());
      bytes.insert(bytes.end(), whole.begin(), whole.end());
      PacketReader reader;
      EXPECT_EQ(reader.feed(bytes.data(), bytes.size()), 1) << from << ' ' << lost;
      EXPECT_EQ(reader.newest().encoders, (std::array<std::int16_t, 3>{0x1234, -1, -32768}));
    }
  }
  // Bytes too many; rubbish between; two in one piece.
  for (const std::string& text :
       {"<EDCBPPPPAAAIAA\xba\x41>" + kByHand, "\x01\x60zz>>" + kByHand + ">><<<", "<<<" + kByHand}) {
    PacketReader reader;
    const auto bytes = bytes_of(text);
    EXPECT_EQ(reader.feed(bytes.data(), bytes.size()), 1) << text;
  }
  PacketReader reader;
  auto twice = bytes_of(kByHand + kByHand);
  twice[16 + 1] = 'B';
  EXPECT_EQ(reader.feed(twice.data(), twice.size()), 2);
  EXPECT_EQ(reader.newest().encoders[0], 0x1231);  // the later of the two
}

TEST(FalconReader, CountsWhatItGivesUp) {
  PacketReader reader;
  const auto bytes = bytes_of("<EDCB<EDCBPPPP!" + kByHand);
  EXPECT_EQ(reader.feed(bytes.data(), bytes.size()), 1);
  EXPECT_EQ(reader.malformed(), 2u);
  const auto begun = bytes_of("<EDCB");
  reader.feed(begun.data(), begun.size());
  reader.reset();
  EXPECT_EQ(reader.feed(bytes_of(kByHand).data(), kPacketBytes), 1);
  EXPECT_EQ(reader.malformed(), 2u);
}

/// A bit that flips makes the packet malformed, or changes one value and no other; the one after it is always found.
TEST(FalconReader, FlippedBits) {
  const auto whole = bytes_of(kByHand);
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * kPacketBytes; ++bit) {
    auto bytes = whole;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << (bit % 8));
    bytes.insert(bytes.end(), whole.begin(), whole.end());
    PacketReader reader;
    const int found = reader.feed(bytes.data(), bytes.size());
    ASSERT_GE(found, 1) << bit;
    refused += found == 1;
    EXPECT_EQ(reader.newest().encoders, (std::array<std::int16_t, 3>{0x1234, -1, -32768}));
  }
  EXPECT_GT(refused, 60);  // the four high bits of each of twelve nibbles, and both ends
}

TEST(FalconReader, RandomBytesBetweenWholePackets) {
  std::mt19937 random(1);
  const auto whole = bytes_of(kByHand);
  PacketReader reader;
  int sent = 0, found = 0;
  for (int n = 0; n < 20000; ++n) {
    std::vector<std::uint8_t> bytes;
    for (int i = static_cast<int>(random() % 40); i > 0; --i) {
      const auto byte = static_cast<std::uint8_t>(random());
      if (byte != '<') bytes.push_back(byte);  // one that begins in the rubbish may swallow the next
    }
    bytes.insert(bytes.end(), whole.begin(), whole.end());
    ++sent;
    found += reader.feed(bytes.data(), bytes.size());
  }
  EXPECT_EQ(found, sent);
}

TEST(FalconPlausibility, TakesWhatAHandCanDo) {
  Plausibility check;
  EXPECT_TRUE(check.accepts({1000, -1000, 0}, 0.0));
  for (int n = 1; n <= 100; ++n)
    EXPECT_TRUE(check.accepts({static_cast<std::int16_t>(1000 - 30 * n), -1000, 5}, n)) << n;
  EXPECT_TRUE(check.accepts({-1300, -1000, 5}, 110.0));  // after a pause it may have gone further
}

TEST(FalconPlausibility, HoldsBackASingleJump) {
  Plausibility check;
  double now_ms = 0.0;
  EXPECT_TRUE(check.accepts({0, 0, 0}, now_ms));
  for (int leg = 0; leg < 3; ++leg) {
    std::array<std::int16_t, 3> jump{0, 0, 0};
    jump[leg] = 2048;  // the bit flips
    EXPECT_FALSE(check.accepts(jump, ++now_ms));
    EXPECT_TRUE(check.accepts({0, 0, 0}, ++now_ms));
  }
  EXPECT_FALSE(check.accepts({2048, 0, 0}, ++now_ms));
  EXPECT_FALSE(check.accepts({-2048, 0, 0}, ++now_ms));  // does not agree with the one before
  EXPECT_FALSE(check.accepts({2048, 0, 0}, ++now_ms));
}

TEST(FalconPlausibility, BelievesWhatIsSaidAgain) {
  Plausibility check;
  double now_ms = 1e9;  // since the machine was switched on
  EXPECT_TRUE(check.accepts({0, 0, 0}, now_ms));
  for (int n = 1; n < Plausibility::kAgreeing; ++n) EXPECT_FALSE(check.accepts({2048, 0, 0}, ++now_ms));
  EXPECT_TRUE(check.accepts({2050, 0, 0}, ++now_ms));
  EXPECT_TRUE(check.accepts({2060, 0, 0}, ++now_ms));
  check.reset();
  EXPECT_TRUE(check.accepts({-30000, 0, 0}, ++now_ms));
}

/// What is held back does not widen what is taken: the hand has had as long as the clock says since the last that was
/// taken, however many reports came in between.
TEST(FalconPlausibility, AHandHasTheTimeOfTheClock) {
  constexpr int kFar = 20 * Plausibility::kCountsPerMs;
  Plausibility check;
  EXPECT_TRUE(check.accepts({0, 0, 0}, 0.0));
  for (int ms = 1; ms < 20; ++ms) {
    const auto there = static_cast<std::int16_t>(ms % 2 == 0 ? kFar : -kFar);  // no two agree
    EXPECT_FALSE(check.accepts({there, 0, 0}, ms)) << ms;
  }
  EXPECT_TRUE(check.accepts({kFar, 0, 0}, 20.0));
}

}  // namespace
}  // namespace vallecula::device::falcon
