// From a Falcon just plugged in to one that answers packets: the user's firmware file, and the start-up sequence.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "device/drivers/falcon/falcon_protocol.h"
#include "device/drivers/falcon/falcon_usb.h"

namespace vallecula::device::falcon {

/// Where the firmware is looked for when neither an argument nor $VALLECULA_FALCON_FIRMWARE names a file, as a person
/// is told it.
constexpr const char* kFirmwareAdvice =
    "Novint's firmware is not part of this program: put the file that came with the Falcon's own software at "
    "~/.local/share/vallecula/falcon.bin, or name it (falcon:FIRMWARE.bin, or the variable VALLECULA_FALCON_FIRMWARE)";

/// The firmware file's bytes: `argument`, else $VALLECULA_FALCON_FIRMWARE, else falcon.bin in the user's data folder
/// ($VALLECULA_HOME, else $XDG_DATA_HOME/vallecula, else ~/.local/share/vallecula). Empty where none of these is given
/// and there is none in the folder: a Falcon that runs its firmware already needs none. Throws DeviceError when a file
/// that was named, or stands there, cannot be read or cannot be a firmware by its size.
std::vector<std::uint8_t> read_firmware(const std::string& argument);

/// Sends `command` and waits `time_ms` for the answer; `reader` then holds it. `late` when none came. What was on its
/// way before is taken first: the answer to an earlier command counts only if nothing newer comes.
Transfer exchange(FalconUsb& usb, PacketReader& reader, const Command& command, int time_ms) noexcept;

/// Starts an opened Falcon. One that answers packets already is left as it is; otherwise `firmware` is loaded, which
/// takes some seconds. Ends within `longest` whatever the device does, and soon after `stop`. Throws DeviceError naming
/// the step that failed.
void start(FalconUsb& usb, const std::vector<std::uint8_t>& firmware, const std::atomic<bool>& stop,
           std::chrono::milliseconds longest = std::chrono::seconds(20));

}  // namespace vallecula::device::falcon
