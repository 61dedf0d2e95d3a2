#include "device/found_devices.h"

#include "device/drivers/falcon/falcon_device.h"
#include "device/drivers/hdapi/hd_device.h"
#include "device/drivers/spacemouse/spacemouse_list.h"

namespace vallecula::device {

FoundDevice found_mouse() {
  FoundDevice mouse;
  mouse.name = "mouse";
  mouse.info.kind = "mouse";
  mouse.info.model = "mouse and keyboard";
  return mouse;
}

std::vector<FoundDevice> find_devices() {
  std::vector<FoundDevice> found = {found_mouse()};
  for (const FoundDevice& touch : hdapi::find_touch()) found.push_back(touch);
  for (const FoundDevice& falcon : find_falcon()) found.push_back(falcon);
  for (const FoundDevice& spacemouse : find_spacemouse()) found.push_back(spacemouse);
  return found;
}

}  // namespace vallecula::device
