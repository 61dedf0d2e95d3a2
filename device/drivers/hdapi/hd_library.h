// Finds the user's libHD.so at run time.
#pragma once

#include <string>
#include <vector>

#include "device/drivers/hdapi/hd_api.h"
#include "device/trajectory.h"

namespace vallecula::device::hdapi {

/// What is wrong and how to mend it, together in what() and apart for the list of devices.
struct HdError : DeviceError {
  HdError(const std::string& what_is_wrong, const std::string& what_helps)
      : DeviceError("touch: " + what_is_wrong + ". " + what_helps), problem(what_is_wrong), mend(what_helps) {}
  std::string problem, mend;
};

/// Where libHD.so may be, in the order tried: the file that VALLECULA_LIBHD names, if it is set; what the loader finds;
/// the places that the vendor's installers use.
std::vector<std::string> library_paths();

/// Loads the first of `paths` that can be loaded and resolves every function. The library stays loaded until the
/// program ends: it has threads of its own. Throws HdError naming every path tried and why it failed, or the
/// functions that the library lacks. A path from VALLECULA_LIBHD is named by that word, never by its folder.
Functions load_library(const std::vector<std::string>& paths);

}  // namespace vallecula::device::hdapi
