#include "device/drivers/open_trouble.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace vallecula::device {
namespace {

namespace fs = std::filesystem;

/// A number in hexadecimal from a file of sysfs; -1 where there is none.
long hexadecimal_in(const fs::path& file) {
  std::ifstream in(file);
  std::string text;
  return in >> text ? std::strtol(text.c_str(), nullptr, 16) : -1;
}

}  // namespace

const char* const kPermissionMend =
    "copy packaging/60-vallecula.rules to /etc/udev/rules.d, run 'udevadm control --reload' as root and plug it in "
    "again";

OpenTrouble open_trouble(int error_number) {
  switch (error_number) {
    case EACCES:
    case EPERM:
      return {"this user may not open it", kPermissionMend};
    case EBUSY:
      return {"another program holds it", "close the program that uses it"};
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return {"it is not there any more", "plug it in again"};
    default:
      return {"it cannot be opened: " + std::generic_category().message(error_number),
              "plug it in again; if that does not help, see what the system's log says about it"};
  }
}

bool taken_through_usbfs(std::uint16_t vendor, std::uint16_t product) {
  std::error_code none;
  const fs::path bus = "/sys/bus/usb/devices";
  for (const auto& entry : fs::directory_iterator(bus, none)) {
    const std::string name = entry.path().filename().string();
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) continue;  // a device; its interfaces are named DEVICE:CONFIGURATION.INTERFACE
    const fs::path device = bus / name.substr(0, colon);
    if (hexadecimal_in(device / "idVendor") != vendor || hexadecimal_in(device / "idProduct") != product) continue;
    if (fs::read_symlink(entry.path() / "driver", none).filename() == "usbfs") return true;
  }
  return false;
}

}  // namespace vallecula::device
