// Opens one device through HDAPI and asks what it is.
#pragma once

#include <string>

#include "device/drivers/hdapi/hd_channel.h"

namespace vallecula::device::hdapi {

/// Empties the library's stack of errors; the oldest, the cause of the others. Success where there is none.
ErrorInfo take_errors(const Functions& hd) noexcept;

/// Opens the device that the vendor's set-up calls `name` (empty: the usual default names in turn), enables its force
/// output and attaches it to `channel`. The library's loop must stand. Throws HdError with each name tried, the
/// library's error and the mend.
Properties open_device(const Functions& hd, const std::string& name, Channel& channel);

}  // namespace vallecula::device::hdapi
