#include "device/drivers/falcon/falcon_protocol.h"

#include <algorithm>
#include <cstdlib>

namespace vallecula::device::falcon {
namespace {

constexpr std::uint8_t kBegin = '<', kEnd = '>', kOffset = 0x41;
constexpr std::size_t kNibbles = 12, kInfo = 13, kUnknown = 14, kLast = 15;
constexpr std::size_t kBusPacketBytes = 64, kModemStatusBytes = 2;

/// Whether a well-formed packet can have `byte` at `place`.
bool permitted(std::size_t place, std::uint8_t byte) noexcept {
  if (place == 0) return byte == kBegin;
  if (place <= kNibbles) return byte >= kOffset && byte < kOffset + 16;
  if (place == kInfo) return byte >= kOffset && byte <= kOffset + 0x7f;
  return place == kUnknown ? byte != kBegin : byte == kEnd;
}

}  // namespace

Packet encode(const Command& command) noexcept {
  Packet packet{};
  packet[0] = kBegin;
  for (std::size_t n = 0; n < kNibbles; ++n) {
    const auto value = static_cast<std::uint16_t>(command.motors[n / 4]);
    packet[1 + n] = static_cast<std::uint8_t>(kOffset + ((value >> (4 * (n % 4))) & 0xf));
  }
  packet[kInfo] = static_cast<std::uint8_t>(
      kOffset + ((command.lights & (kGreenLight | kBlueLight | kRedLight)) | (command.homing ? kAskHoming : 0)));
  packet[kUnknown] = kOffset;
  packet[kLast] = kEnd;
  return packet;
}

std::optional<Report> decode(const Packet& packet) noexcept {
  for (std::size_t place = 0; place < kPacketBytes; ++place) {
    if (!permitted(place, packet[place])) return std::nullopt;
  }
  Report report;
  for (std::size_t leg = 0; leg < 3; ++leg) {
    unsigned value = 0;
    for (std::size_t n = 0; n < 4; ++n) value |= static_cast<unsigned>(packet[1 + 4 * leg + n] - kOffset) << (4 * n);
    report.encoders[leg] = static_cast<std::int16_t>(value);
  }
  const auto info = static_cast<std::uint8_t>(packet[kInfo] - kOffset);
  report.homed = (info >> 4) & kAllHomed;
  report.buttons = info & 0x0f;
  return report;
}

std::size_t strip_modem_status(std::uint8_t* bytes, std::size_t count) noexcept {
  std::size_t kept = 0;
  for (std::size_t at = 0; at < count; at += kBusPacketBytes) {
    const std::size_t end = std::min(count, at + kBusPacketBytes);
    for (std::size_t i = at + kModemStatusBytes; i < end; ++i) bytes[kept++] = bytes[i];
  }
  return kept;
}

int PacketReader::feed(const std::uint8_t* bytes, std::size_t count) noexcept {
  int found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!permitted(length_, bytes[i])) {
      if (length_ > 0) ++malformed_;
      length_ = 0;
      if (bytes[i] != kBegin) continue;  // one that breaks off may be followed by a whole one
    }
    packet_[length_++] = bytes[i];
    if (length_ < kPacketBytes) continue;
    length_ = 0;
    newest_ = *decode(packet_);  // every byte was permitted
    ++found;
  }
  return found;
}

bool Plausibility::accepts(const std::array<std::int16_t, 3>& encoders, double time_ms) noexcept {
  const auto near = [&](const Heard& other) {
    const double reach = kCountsPerMs * std::max(1.0, time_ms - other.time_ms);
    return std::abs(encoders[0] - other.encoders[0]) <= reach && std::abs(encoders[1] - other.encoders[1]) <= reach &&
           std::abs(encoders[2] - other.encoders[2]) <= reach;
  };
  if (known_ && !near(accepted_)) {
    agreeing_ = agreeing_ > 0 && near(doubted_) ? agreeing_ + 1 : 1;
    doubted_ = {encoders, time_ms};
    if (agreeing_ < kAgreeing) return false;
  }
  accepted_ = {encoders, time_ms};
  agreeing_ = 0;
  known_ = true;
  return true;
}

}  // namespace vallecula::device::falcon
