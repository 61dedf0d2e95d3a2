#include "device/drivers/spacemouse/spacemouse_models.h"

namespace vallecula::device {

const std::vector<SpaceMouseModel>& spacemouse_models() {
  static const std::vector<SpaceMouseModel> kModels = {
      {0x046d, 0xc603, "SpaceMouse Plus"},
      {0x046d, 0xc605, "CADman"},
      {0x046d, 0xc606, "SpaceMouse Classic"},
      {0x046d, 0xc621, "SpaceBall 5000"},
      {0x046d, 0xc623, "SpaceTraveler"},
      {0x046d, 0xc625, "SpacePilot"},
      {0x046d, 0xc626, "SpaceNavigator"},
      {0x046d, 0xc627, "SpaceExplorer"},
      {0x046d, 0xc628, "SpaceNavigator for Notebooks"},
      {0x046d, 0xc629, "SpacePilot Pro"},
      {0x046d, 0xc62b, "SpaceMouse Pro"},
      {k3DconnexionVendor, 0xc62e, "SpaceMouse Wireless (cable)"},
      {k3DconnexionVendor, 0xc62f, "SpaceMouse Wireless (receiver)"},
      {k3DconnexionVendor, 0xc631, "SpaceMouse Pro Wireless (cable)"},
      {k3DconnexionVendor, 0xc632, "SpaceMouse Pro Wireless (receiver)"},
      {k3DconnexionVendor, 0xc633, "SpaceMouse Enterprise"},
      {k3DconnexionVendor, 0xc635, "SpaceMouse Compact"},
      {k3DconnexionVendor, 0xc636, "SpaceMouse Module"},
      {k3DconnexionVendor, 0xc638, "SpaceMouse Pro Wireless (Bluetooth)"},
      {k3DconnexionVendor, 0xc63a, "SpaceMouse Wireless (Bluetooth)"},
      {k3DconnexionVendor, 0xc652, "3Dconnexion Universal Receiver"},
  };
  return kModels;
}

const char* spacemouse_name(std::uint16_t vendor, std::uint16_t product, std::uint16_t usage_page,
                            std::uint16_t usage) {
  if (usage_page != kUsagePage || usage != kUsage) return nullptr;
  for (const SpaceMouseModel& model : spacemouse_models())
    if (model.vendor == vendor && model.product == product) return model.name;
  return vendor == k3DconnexionVendor ? "3Dconnexion device" : nullptr;
}

}  // namespace vallecula::device
