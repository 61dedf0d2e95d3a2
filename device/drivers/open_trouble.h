// Why a device that is plugged in cannot be opened, in a person's words; the same for every driver.
#pragma once

#include <cstdint>
#include <string>

namespace vallecula::device {

struct OpenTrouble {
  std::string problem;  ///< "this user may not open it"
  std::string mend;     ///< "copy packaging/60-vallecula.rules ..."
};

/// What to do where the system does not let a person at a device.
extern const char* const kPermissionMend;

/// For the errno of an open() that failed: permission, held by another program, gone, or something else are told apart.
OpenTrouble open_trouble(int error_number);

/// Whether a program drives the USB device past the kernel's own driver (one of its interfaces is bound to usbfs),
/// which keeps every other program from it. False where there is no such device.
bool taken_through_usbfs(std::uint16_t vendor, std::uint16_t product);

}  // namespace vallecula::device
