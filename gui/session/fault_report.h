// A fault of the loop in plain words, and the ticks that led to it as a table.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device/guarded_device.h"
#include "engine/tick_record.h"

namespace vallecula::gui {

/// The faults that freeze the last ticks: the engine's or the pose's own, not an unplugged device or a late step.
constexpr std::uint32_t kLoopFaults = engine::kFaultDevicePose | engine::kFaultTissue | engine::kFaultForce;

/// One sentence for a person; empty without one of kLoopFaults.
std::string fault_words(std::uint32_t faults);

/// When the last of `ticks` came, what was wrong with it, and the name of the file that holds them.
std::string fault_sentence(const std::vector<engine::TickRecord>& ticks, const std::string& file_name);

/// Why the trial is paused and what to do; empty while it is not. `recorded`: the pause is a recorded hand's.
std::string pause_words(device::GuardState state, device::DeviceFault fault, bool recorded);

/// One row a tick, oldest first; units in the column names, world axes (patient LPS).
std::string fault_csv(const std::vector<engine::TickRecord>& ticks);

}  // namespace vallecula::gui
