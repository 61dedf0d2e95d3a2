#include "curricula/trial_log_format.h"

#include <cstring>

namespace vallecula::curricula::log_format {
namespace {

template <class Unsigned>
void put_unsigned(std::string& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 0xffu));
}

template <class Unsigned>
Unsigned get_unsigned(const char* bytes) noexcept {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    value |= static_cast<Unsigned>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

void put(std::string& out, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  put_unsigned(out, bits);
}
void put(std::string& out, std::int64_t value) { put_unsigned(out, static_cast<std::uint64_t>(value)); }
void put(std::string& out, std::int32_t value) { put_unsigned(out, static_cast<std::uint32_t>(value)); }
void put(std::string& out, std::uint32_t value) { put_unsigned(out, value); }
void put(std::string& out, std::uint8_t value) { out.push_back(static_cast<char>(value)); }
void put(std::string& out, bool value) { out.push_back(value ? '\1' : '\0'); }
template <std::size_t N>
void put(std::string& out, const std::array<double, N>& values) {
  for (double v : values) put(out, v);
}
void put(std::string& out, const LogPose& pose) {
  put(out, pose.position_m);
  put(out, pose.rotation_wxyz);
}

/// Takes fields off the front of a tick's bytes, in the order in which put_tick wrote them.
struct Cursor {
  const char* at;

  void get(double& value) {
    const auto bits = get_unsigned<std::uint64_t>(at);
    std::memcpy(&value, &bits, sizeof bits);
    at += 8;
  }
  void get(std::int64_t& value) { value = static_cast<std::int64_t>(get_unsigned<std::uint64_t>(at)), at += 8; }
  void get(std::int32_t& value) { value = static_cast<std::int32_t>(get_unsigned<std::uint32_t>(at)), at += 4; }
  void get(std::uint32_t& value) { value = get_unsigned<std::uint32_t>(at), at += 4; }
  void get(std::uint8_t& value) { value = static_cast<std::uint8_t>(*at++); }
  void get(bool& value) { value = *at++ != 0; }
  template <std::size_t N>
  void get(std::array<double, N>& values) {
    for (double& v : values) get(v);
  }
  void get(LogPose& pose) {
    get(pose.position_m);
    get(pose.rotation_wxyz);
  }
};

void put_intubation(std::string& out, const LogIntubation& i) {
  put(out, i.hand_pose);
  put(out, i.hand_valid);
  put(out, static_cast<std::uint8_t>(i.in_hand));
  put(out, i.tip_m);
  put(out, i.tip_direction);
  put(out, static_cast<std::uint8_t>(i.place));
  put(out, static_cast<std::uint8_t>(i.side));
  put(out, i.past_cords_m);
  put(out, i.at_mouth_m);
  put(out, i.buckled_m);
  put(out, i.model_force_n);
  put(out, i.displayed_force_n);
  put(out, i.loads_n);
  put(out, i.tip_load_n);
  put(out, i.tip_against);
  put(out, i.glottis_opening);
  put(out, i.spasm);
  put(out, i.secretions_ml);
  put(out, i.sao2);
  put(out, i.spo2);
  put(out, i.heart_per_min);
  put(out, i.detector_yellow);
  put(out, i.breaths_given);
  put(out, i.given_per_min);
  put(out, i.faults);
}

/// A byte that must name one of `last` + 1 things; `what` and `tick` for the message.
std::uint8_t known(std::uint8_t value, std::uint8_t last, const char* what, std::int64_t tick) {
  if (value > last)
    throw TrialLogError("tick " + std::to_string(tick) + " has the unknown " + what + " " + std::to_string(value));
  return value;
}

LogIntubation get_intubation(Cursor& c, std::int64_t tick) {
  LogIntubation i;
  std::uint8_t in_hand = 0, place = 0, side = 0;
  c.get(i.hand_pose);
  c.get(i.hand_valid);
  c.get(in_hand);
  c.get(i.tip_m);
  c.get(i.tip_direction);
  c.get(place);
  c.get(side);
  c.get(i.past_cords_m);
  c.get(i.at_mouth_m);
  c.get(i.buckled_m);
  c.get(i.model_force_n);
  c.get(i.displayed_force_n);
  c.get(i.loads_n);
  c.get(i.tip_load_n);
  c.get(i.tip_against);
  c.get(i.glottis_opening);
  c.get(i.spasm);
  c.get(i.secretions_ml);
  c.get(i.sao2);
  c.get(i.spo2);
  c.get(i.heart_per_min);
  c.get(i.detector_yellow);
  c.get(i.breaths_given);
  c.get(i.given_per_min);
  c.get(i.faults);
  i.in_hand = static_cast<LoggedInHand>(
      known(in_hand, static_cast<std::uint8_t>(LoggedInHand::catheter), "thing in hand", tick));
  i.place = static_cast<LoggedPlace>(known(place, static_cast<std::uint8_t>(LoggedPlace::oesophagus), "place", tick));
  i.side = static_cast<std::int8_t>(side);
  if (i.side != -1) known(side, 1, "main bronchus", tick);
  if (i.tip_against != kNothingAgainstTip) known(i.tip_against, kTubeLoads - 1, "thing before the tip", tick);
  return i;
}

}  // namespace

std::uint32_t crc32(const char* data, std::size_t size) noexcept {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1u) != 0 ? 0xedb88320u ^ (c >> 1) : c >> 1;
      entries[i] = c;
    }
    return entries;
  }();
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) crc = table[(crc ^ static_cast<unsigned char>(data[i])) & 0xffu] ^ (crc >> 8);
  return crc ^ 0xffffffffu;
}

void put_u32(std::string& out, std::uint32_t value) { put_unsigned(out, value); }
std::uint32_t get_u32(const char* bytes) noexcept { return get_unsigned<std::uint32_t>(bytes); }

std::string file_head() {
  std::string head(kMagic, kMagicBytes);
  put_u32(head, kVersion);
  return head;
}

std::string block(const char kind[4], std::uint32_t number, const std::string& payload) {
  std::string bytes(kind, 4);
  bytes.reserve(kBlockHeadBytes + payload.size() + kChecksumBytes);
  put_u32(bytes, number);
  put_u32(bytes, static_cast<std::uint32_t>(payload.size()));
  bytes += payload;
  put_u32(bytes, crc32(bytes.data(), bytes.size()));
  return bytes;
}

void put_tick(std::string& out, const LogTick& tick, bool areas) {
  put(out, tick.tick);
  put(out, tick.time_s);
  put(out, tick.device_pose);
  put(out, tick.buttons);
  put(out, tick.device_valid);
  put(out, tick.step_fed);
  put(out, tick.step_used);
  put(out, tick.proxy_pose);
  put(out, static_cast<std::uint8_t>(tick.state));
  put(out, tick.model_force_n);
  put(out, tick.model_torque_nm);
  put(out, tick.displayed_force_n);
  for (const LogLoad& load : tick.loads) {
    put(out, load.force_n);
    put(out, load.centre_m);
    put(out, load.contacts);
  }
  put(out, tick.has_sight);
  put(out, tick.glottis_visible);
  put(out, tick.faults);
  if (tick.has_intubation) put_intubation(out, tick.intubation);
  if (!areas) return;
  for (const LogLoad& load : tick.loads) put(out, load.area_m2);
}

LogTick get_tick(const char* bytes, bool intubation, bool areas) {
  LogTick tick;
  std::uint8_t state = 0;
  Cursor c{bytes};
  c.get(tick.tick);
  c.get(tick.time_s);
  c.get(tick.device_pose);
  c.get(tick.buttons);
  c.get(tick.device_valid);
  c.get(tick.step_fed);
  c.get(tick.step_used);
  c.get(tick.proxy_pose);
  c.get(state);
  c.get(tick.model_force_n);
  c.get(tick.model_torque_nm);
  c.get(tick.displayed_force_n);
  for (LogLoad& load : tick.loads) {
    c.get(load.force_n);
    c.get(load.centre_m);
    c.get(load.contacts);
  }
  c.get(tick.has_sight);
  c.get(tick.glottis_visible);
  c.get(tick.faults);
  tick.state =
      static_cast<LoggedState>(known(state, static_cast<std::uint8_t>(LoggedState::recovering), "state", tick.tick));
  tick.has_intubation = intubation;
  if (intubation) tick.intubation = get_intubation(c, tick.tick);
  tick.has_areas = areas;
  if (areas)
    for (LogLoad& load : tick.loads) c.get(load.area_m2);
  return tick;
}

}  // namespace vallecula::curricula::log_format
