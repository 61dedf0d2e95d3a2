// What the Novint Falcon and the host say to each other once its firmware runs: packets of 16 bytes, as pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace vallecula::device::falcon {

constexpr std::uint16_t kVendor = 0x0403, kProduct = 0xcb48;
constexpr std::size_t kPacketBytes = 16;
using Packet = std::array<std::uint8_t, kPacketBytes>;

/// Bits of the byte the host sends beside the motors. Sources agree that the lights are these three and differ in which
/// colour is which (check); this is the newer reading.
constexpr std::uint8_t kGreenLight = 0x02, kBlueLight = 0x04, kRedLight = 0x08;
/// Asks the firmware to look for the encoders' index marks. One source gives 0x10 (check), which others name as the
/// answer's first homed bit.
constexpr std::uint8_t kAskHoming = 0x01;

struct Command {
  std::array<std::int16_t, 3> motors{0, 0, 0};  ///< top, right, left leg, as seen from the front
  std::uint8_t lights = 0;
  bool homing = true;  ///< left on for good: the firmware keeps its count of the encoders by it
};

struct Report {
  std::array<std::int16_t, 3> encoders{0, 0, 0};  ///< counts; what they mean is known of a homed leg only
  std::uint8_t homed = 0;                         ///< a bit a leg
  std::uint8_t buttons = 0;                       ///< four of the grip
};
constexpr std::uint8_t kAllHomed = 0x07;

Packet encode(const Command& command) noexcept;
/// Nothing when the packet is not one the firmware can have sent. There is no checksum: a bit that flips from one
/// permitted value into another passes here, and is held against what a hand can do (Plausibility).
std::optional<Report> decode(const Packet& packet) noexcept;

/// The FTDI chip begins each packet of the bus (64 bytes at full speed) with two bytes about its modem lines. Takes
/// them out in place and returns how many bytes are left.
std::size_t strip_modem_status(std::uint8_t* bytes, std::size_t count) noexcept;

/// Finds packets in a stream that may begin anywhere, break off, and hold rubbish. Allocates nothing.
class PacketReader {
 public:
  /// Returns how many well-formed packets ended in these bytes; the last of them is newest().
  int feed(const std::uint8_t* bytes, std::size_t count) noexcept;
  const Report& newest() const noexcept { return newest_; }
  /// Packets given up, since the reader was made.
  std::uint64_t malformed() const noexcept { return malformed_; }
  /// Forgets a packet that has begun.
  void reset() noexcept { length_ = 0; }

 private:
  Packet packet_{};
  std::size_t length_ = 0;
  Report newest_;
  std::uint64_t malformed_ = 0;
};

/// Holds back a report whose encoders have moved further than a hand can move them, until as many agree as kAgreeing:
/// the motors would kick at a single wrong one.
class Plausibility {
 public:
  static constexpr int kAgreeing = 3;
  /// Encoder counts a millisecond: 3 m/s at the knee, some three times what a hand does.
  static constexpr int kCountsPerMs = 80;
  /// `time_ms` on any clock that does not go back; between two reports at least one millisecond is assumed.
  bool accepts(const std::array<std::int16_t, 3>& encoders, double time_ms) noexcept;
  void reset() noexcept { known_ = false; }

 private:
  struct Heard {
    std::array<std::int16_t, 3> encoders{};
    double time_ms = 0.0;
  };
  Heard accepted_, doubted_;
  int agreeing_ = 0;
  bool known_ = false;
};

}  // namespace vallecula::device::falcon
