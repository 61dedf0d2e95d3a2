// Which SpaceMice are plugged in; the one place that asks hidapi for its list.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "device/found_devices.h"

namespace vallecula::device {

struct SpaceMousePlace {
  std::string path;  ///< /dev/hidrawN
  std::string model, serial;
  std::uint16_t vendor = 0, product = 0;
};

/// hidapi's list, its open() and its close() share state that is not made for several threads: whoever calls one of
/// them holds this.
std::mutex& hid_lock();

/// Every interface that steers, each once, in the order of its path. Caller holds hid_lock().
std::vector<SpaceMousePlace> list_spacemice();

/// errno of opening this node to read and write, closed at once; 0: it can be opened.
int open_error(const std::string& path);

/// As make_device() tells them apart: nothing where there is one; its serial number where no other has it; else its
/// number in `all`, from 1.
std::string spacemouse_argument(const std::vector<SpaceMousePlace>& all, std::size_t index);
/// Index in `all` of what `argument` names (a serial number before a number of the list); all.size() if nothing is.
std::size_t find_argument(const std::vector<SpaceMousePlace>& all, const std::string& argument);

/// What is told of a SpaceMouse before and after it is opened.
DeviceInfo spacemouse_info(const SpaceMousePlace& place);

/// For find_devices(): those that can be used, those that may not be opened, those another program has taken.
std::vector<FoundDevice> find_spacemouse();

}  // namespace vallecula::device
