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

namespace {

/// A kind of which the system sees none.
FoundDevice none_of(const char* kind, const char* model, const char* driver) {
  FoundDevice none;
  none.info.kind = kind;
  none.info.model = model;
  none.info.driver = driver;
  none.figures_known = false;
  none.problem = "none plugged in";
  none.mend = "if there is one, check its cable and power";
  return none;
}

}  // namespace

std::vector<FoundDevice> find_devices() {
  std::vector<FoundDevice> found = {found_mouse()};
  const auto add = [&found](const std::vector<FoundDevice>& some) {
    found.insert(found.end(), some.begin(), some.end());
  };
  add(hdapi::find_touch());
  const auto falcons = find_falcon();
  add(falcons.empty() ? std::vector{none_of("falcon", "Novint Falcon", "libusb")} : falcons);
  const auto spacemice = find_spacemouse();
  add(spacemice.empty() ? std::vector{none_of("spacemouse", "SpaceMouse", "hidapi")} : spacemice);
  return found;
}

}  // namespace vallecula::device
