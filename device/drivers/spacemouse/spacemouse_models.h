// The SpaceMouse family on the USB and Bluetooth bus.
#pragma once

#include <cstdint>
#include <vector>

namespace vallecula::device {

struct SpaceMouseModel {
  std::uint16_t vendor, product;
  const char* name;
};

/// 3Dconnexion's own vendor number; its first devices still carry Logitech's, 046d.
constexpr std::uint16_t k3DconnexionVendor = 0x256f;
/// What a SpaceMouse calls itself among the interfaces of a device (a receiver also shows a mouse and a keyboard):
/// generic desktop page, multi-axis controller.
constexpr std::uint16_t kUsagePage = 0x01, kUsage = 0x08;

const std::vector<SpaceMouseModel>& spacemouse_models();

/// Whether a HID interface steers: a model of the list, or another 3Dconnexion device, with the right usage. The name
/// of the model; null for anything else.
const char* spacemouse_name(std::uint16_t vendor, std::uint16_t product, std::uint16_t usage_page, std::uint16_t usage);

}  // namespace vallecula::device
