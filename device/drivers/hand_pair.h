// Two scripted hands and what they ask for, from one file.
#pragma once

#include <filesystem>

#include "device/action_plan.h"
#include "device/drivers/scripted_device.h"

namespace vallecula::device {

struct HandPair {
  HandScript blade, tube;  ///< `tube`: where the second hand holds it; the settings of `# hand` are both hands'
  ActionPlan actions;
};

/// Whether the first row of a hand's file has a pair's columns. False for a file that cannot be read.
bool is_hand_pair(const std::filesystem::path& file);

/// Rows `t,x,y,z,qw,qx,qy,qz,x2,y2,z2,qw2,qx2,qy2,qz2,actions` and remarks as in a hand's file; `# second-fault KIND
/// FROM_S FOR_S` is the second device's. Throws DeviceError naming file and line.
HandPair read_hand_pair(const std::filesystem::path& file);

}  // namespace vallecula::device
