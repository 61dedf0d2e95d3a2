// The trial log's bytes (private to the log's writer and reader). Layout of a file, all numbers little-endian:
//
//   "\x89VTRIAL\n"  u32 format version
//   blocks:  kind (4 letters)  u32 number (0, 1, 2, ...)  u32 payload bytes  payload  u32 CRC-32 of all that
//     HEAD   JSON, the first block
//     TICK   whole ticks of tick_bytes() each: LogTick's fields in their order; where the header says that there is an
//            intubation (schema 3, or the field of schema 4) those of LogIntubation follow, in theirs; where it says that
//            there are contact areas (a field of schema 4), those of the loads come last. Enumerations and truth values
//            are one byte, counts and bits four, tick and steps eight.
//     EVNT   JSON, one event; only where the header says that there are events (a field of schema 4)
//     FOOT   JSON with the number of ticks, the last block
//
// Doubles are stored as their 64 bits, so a log gives back exactly what was measured, NaN included.
#pragma once

#include <cstdint>
#include <string>

#include "curricula/trial_log.h"

namespace vallecula::curricula::log_format {

constexpr char kMagic[] = "\x89VTRIAL\n";
constexpr std::size_t kMagicBytes = sizeof(kMagic) - 1;
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kFileHeadBytes = kMagicBytes + 4;
constexpr std::size_t kBlockHeadBytes = 12;
constexpr std::size_t kChecksumBytes = 4;
constexpr std::size_t kLargestPayload = 16u << 20;  ///< a longer one is damage, never memory to allocate
constexpr int kTicksPerBlock = 256;                 ///< a crash loses at most a quarter of a second

constexpr std::size_t kPoseBytes = 7 * 8, kVectorBytes = 3 * 8, kLoadBytes = 2 * kVectorBytes + 4;
constexpr std::size_t kTickBytes =
    8 + 8 + kPoseBytes + 4 + 1 + 8 + 8 + kPoseBytes + 1 + 3 * kVectorBytes + kStructures * kLoadBytes + 1 + 8 + 4;
constexpr std::size_t kIntubationBytes = kPoseBytes + 1 + 1 + 2 * kVectorBytes + 1 + 1 + 3 * 8 + 2 * kVectorBytes +
                                         kTubeLoads * 8 + 8 + 1 + 8 + 1 + 8 + 2 * 8 + 8 + 1 + 4 + 8 + 4;

constexpr std::size_t kAreaBytes = kStructures * 8;

constexpr std::size_t tick_bytes(bool intubation, bool areas) {
  return kTickBytes + (intubation ? kIntubationBytes : 0) + (areas ? kAreaBytes : 0);
}

/// CRC-32 of IEEE 802.3 (the one of zlib, PNG and Ethernet).
std::uint32_t crc32(const char* data, std::size_t size) noexcept;

void put_u32(std::string& out, std::uint32_t value);
std::uint32_t get_u32(const char* bytes) noexcept;

std::string file_head();
std::string block(const char kind[4], std::uint32_t number, const std::string& payload);

/// `areas`: of the trial, by its header.
void put_tick(std::string& out, const LogTick& tick, bool areas);
/// `bytes` holds tick_bytes(intubation, areas). Throws TrialLogError (without the file's name) on a state or place that does
/// not exist.
LogTick get_tick(const char* bytes, bool intubation, bool areas);

/// JSON texts. The getters throw TrialLogError (without the file's name) naming the field that is missing or wrong.
std::string header_to_json(const LogHeader& header);
LogHeader header_from_json(const std::string& json);
std::string event_to_json(const LogEvent& event);
LogEvent event_from_json(const std::string& json);
std::string footer_to_json(const LogFooter& footer, std::int64_t ticks);
LogFooter footer_from_json(const std::string& json, std::int64_t& ticks);

}  // namespace vallecula::curricula::log_format
