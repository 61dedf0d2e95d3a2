// What a person is told of a device, in words; the same on the terminal and in the window.
#pragma once

#include <array>
#include <string>

#include "device/found_devices.h"

namespace vallecula::gui {

/// One found device as a table's cells.
struct DeviceRow {
  std::string name;         ///< as `--device` takes it; "-" where it cannot be used
  std::string model;        ///< with its serial number
  std::string driver;       ///< through what it is driven
  std::string rate;         ///< of its own reports
  std::string workspace;    ///< width x height x depth
  std::string force;        ///< peak, and what it bears for long
  std::string calibration;  ///< empty where there is nothing to say
  std::string trouble;      ///< why it cannot be used and what to do, or the calibration's mend; empty: nothing
};

constexpr std::array<const char*, 7> kDeviceColumns = {"name",      "model", "driver",     "rate",
                                                       "workspace", "force", "calibration"};

/// Whether a trial can be done with it now; what it lacks all the same stands in its `problem`.
bool usable(const device::FoundDevice& found);
DeviceRow device_row(const device::FoundDevice& found);
/// The cells in the order of kDeviceColumns.
std::array<std::string, kDeviceColumns.size()> cells_of(const DeviceRow& row);
/// "good", "needs_update", ... for files and JSON.
const char* calibration_word(device::Calibration calibration);

}  // namespace vallecula::gui
