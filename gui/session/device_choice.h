// From a device's name on the command line to the device.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "curricula/scenario.h"
#include "device/haptic_device.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// A device name that means nothing: wrong usage, not a failure.
class UnknownDevice : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws UnknownDevice when `name` is none of the forms that make_device takes. Reads no file.
void check_device_name(const std::string& name);

/// `name` is KIND[:ARG]: "mouse", "scripted:expert", "scripted:novice", "scripted:press", "scripted:FILE.csv"
/// (t,x,y,z[,qw,qx,qy,qz], s and m, patient axes). Throws UnknownDevice, or std::runtime_error naming the file at
/// fault.
std::unique_ptr<device::HapticDevice> make_device(const std::string& name, const pipeline::PatientPackage& package,
                                                  const curricula::Scenario& scenario);

}  // namespace vallecula::gui
