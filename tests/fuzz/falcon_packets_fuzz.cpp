// Any bytes as what a Falcon sends: the decoder finds the same packets however the bytes are cut, takes none that it
// could not have been sent, and any encoders end in a place that has them, or in none.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "device/drivers/falcon/falcon_kinematics.h"
#include "device/drivers/falcon/falcon_protocol.h"

using namespace vallecula::device;
using namespace vallecula::device::falcon;

namespace {

void must(bool condition) {
  if (!condition) std::abort();
}

void check(const Report& report, Plausibility& plausibility, double time_ms, Vector& position) {
  must(report.homed <= kAllHomed && report.buttons < 16);
  Command command;
  command.motors = report.encoders;
  const auto again = decode(encode(command));
  must(again && again->encoders == report.encoders);
  if (!plausibility.accepts(report.encoders, time_ms)) return;
  Angles angles{};
  for (int leg = 0; leg < 3; ++leg) angles[leg] = leg_angle(report.encoders[leg]);
  if (const auto found = position_of(angles, position)) {
    position = *found;
    const auto back = leg_angles(position);
    must(back && length(subtract(*back, angles)) < 1e-8);
    if (const auto torques = leg_torques(position, {5.0, -5.0, 3.0})) {
      for (const std::int16_t motor : motor_commands(*torques)) must(std::abs(motor) <= kMostMotor);
    }
  }
}

/// The bytes as contents of packets that are well-formed but for what a byte of 0xff takes away.
std::vector<std::uint8_t> shaped(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = i % 14;
    if (place == 0) bytes.push_back('<');
    if (data[i] != 0xff) bytes.push_back(static_cast<std::uint8_t>('A' + (data[i] & (place < 12 ? 0x0f : 0x7f))));
    if (place == 13) bytes.push_back('>');
  }
  return bytes;
}

void read_all(const std::uint8_t* bytes, std::size_t count) {
  PacketReader whole, single;
  Plausibility plausibility;
  Vector position{0, 0, 0};
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (single.feed(bytes + i, 1) == 0) continue;
    ++found;
    check(single.newest(), plausibility, static_cast<double>(found), position);
  }
  must(whole.feed(bytes, count) == static_cast<int>(found) && whole.malformed() == single.malformed());
  must(whole.newest().encoders == single.newest().encoders);
  must(found * kPacketBytes <= count);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes(data, data + size);
  const std::size_t left = strip_modem_status(bytes.data(), bytes.size());
  must(left + 2 * ((size + 63) / 64) >= size && left <= size);

  read_all(data, size);
  read_all(bytes.data(), left);
  const auto packets = shaped(data, size);
  read_all(packets.data(), packets.size());
  return 0;
}
