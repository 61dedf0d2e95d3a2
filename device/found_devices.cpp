#include "device/found_devices.h"

#include "device/drivers/hdapi/hd_device.h"

namespace vallecula::device {

std::vector<FoundDevice> find_devices() {
  std::vector<FoundDevice> found;
  FoundDevice mouse;
  mouse.name = "mouse";
  mouse.info.kind = "mouse";
  mouse.info.model = "mouse and keyboard";
  found.push_back(mouse);
  for (const FoundDevice& touch : hdapi::find_touch()) found.push_back(touch);
  return found;
}

}  // namespace vallecula::device
