// What the application remembers for its user: one file in the user's data folder.
#pragma once

#include <QSettings>
#include <memory>

#include "device/guarded_device.h"

namespace vallecula::gui {

/// settings.ini of the user's data folder. Throws std::runtime_error when that folder is not known.
std::unique_ptr<QSettings> user_settings();

constexpr double kLeastForceScale = 0.2;

/// How a person has set a device up; kept by its kind and serial number.
struct DeviceSettings {
  device::MapSettings map;
  double force_scale = 0.0;         ///< force shown over the model's, kLeastForceScale to 1; 0: as its peak asks for
  std::uint32_t clutch_button = 2;  ///< bit of the button; 0: none
};
/// What was kept of this device; where nothing was, or what is no setting, the default.
DeviceSettings device_settings(const device::DeviceInfo& info);
void keep_device_settings(const device::DeviceInfo& info, const DeviceSettings& settings);

/// A device's own limits with the person's settings; the force chosen no larger than the device shows without buzzing.
/// Those of a device that is nobody's (scripted, recorded) are not
/// the person's.
device::GuardSettings guard_settings(const device::DeviceInfo& info);

/// The n-th button (from 1) of this bit, and back; 0: none.
int button_of(std::uint32_t bit);
std::uint32_t bit_of_button(int button);
/// Which of the device's own buttons, as a person counts them, is the clutch; 0: none.
int clutch_button_in_hand(const device::DeviceInfo& info);

/// Way of the blade over way of the mouse on the picture: 0.25 to 4, 1 unless chosen.
constexpr double kLeastMouseGain = 0.25, kMostMouseGain = 4.0;
double mouse_gain();
void keep_mouse_gain(double gain);

}  // namespace vallecula::gui
