#include "device/found_devices.h"

namespace vallecula::device {

std::vector<FoundDevice> find_devices() {
  std::vector<FoundDevice> found;
  FoundDevice mouse;
  mouse.name = "mouse";
  mouse.info.kind = "mouse";
  mouse.info.model = "mouse and keyboard";
  found.push_back(mouse);
  return found;
}

}  // namespace vallecula::device
