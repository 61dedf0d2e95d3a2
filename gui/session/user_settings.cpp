#include "gui/session/user_settings.h"

#include <QUrl>
#include <algorithm>
#include <cmath>

#include "gui/session/user_paths.h"

namespace vallecula::gui {
namespace {

QString group_of(const device::DeviceInfo& info) {
  const std::string name = info.serial.empty() ? info.kind : info.kind + "-" + info.serial;
  return "devices/" + QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(name)));
}

/// The kept number, or `otherwise` when it is none or out of its range.
double number(const QSettings& kept, const char* key, double low, double high, double otherwise) {
  bool is_number = false;
  const double value = kept.value(key).toDouble(&is_number);
  return is_number && value >= low && value <= high ? value : otherwise;
}

}  // namespace

std::unique_ptr<QSettings> user_settings() {
  const QString file = QString::fromStdString((user_data_folder() / "settings.ini").string());
  return std::make_unique<QSettings>(file, QSettings::IniFormat);
}

DeviceSettings device_settings(const device::DeviceInfo& info) {
  const auto kept = user_settings();
  kept->beginGroup(group_of(info));
  DeviceSettings settings;
  settings.map.motion_scale =
      number(*kept, "motion_scale", device::kLeastMotionScale, device::kMostMotionScale, settings.map.motion_scale);
  settings.map.turned_rad = number(*kept, "turned_rad", -M_PI, M_PI, settings.map.turned_rad);
  settings.map.left_handed = kept->value("left_handed", false).toBool();
  settings.force_scale = number(*kept, "force_scale", kLeastForceScale, 1.0, 0.0);
  settings.clutch_button = static_cast<std::uint32_t>(number(*kept, "clutch_button", 0, 65535, settings.clutch_button));
  return settings;
}

void keep_device_settings(const device::DeviceInfo& info, const DeviceSettings& settings) {
  const auto kept = user_settings();
  kept->beginGroup(group_of(info));
  kept->setValue("motion_scale", settings.map.motion_scale);
  kept->setValue("turned_rad", settings.map.turned_rad);
  kept->setValue("left_handed", settings.map.left_handed);
  // Between none and the least: whoever asks for less gets the least, not all that the device can.
  kept->setValue("force_scale", settings.force_scale > 0.0 ? std::max(settings.force_scale, kLeastForceScale) : 0.0);
  kept->setValue("clutch_button", settings.clutch_button);
}

device::GuardSettings guard_settings(const device::DeviceInfo& info) {
  if (!info.own_axes) return device::guard_for(info);
  const DeviceSettings settings = device_settings(info);
  device::GuardSettings guard = device::guard_for(info, settings.map);
  guard.clutch_button = settings.clutch_button;
  if (settings.force_scale > 0.0)
    guard.limits.force_scale = std::min(settings.force_scale, device::most_force_scale(info, settings.map));
  return guard;
}

int button_of(std::uint32_t bit) { return bit == 0 ? 0 : 1 + static_cast<int>(std::log2(bit)); }
std::uint32_t bit_of_button(int button) { return button == 0 ? 0u : 1u << (button - 1); }

int clutch_button_in_hand(const device::DeviceInfo& info) {
  if (!info.own_axes) return 0;
  const DeviceSettings settings = device_settings(info);
  const int button = button_of(settings.clutch_button);
  const bool exchanged = settings.map.left_handed && (button == 1 || button == 2);
  return exchanged ? 3 - button : button;
}

double mouse_gain() { return number(*user_settings(), "mouse/gain", kLeastMouseGain, kMostMouseGain, 1.0); }

void keep_mouse_gain(double gain) {
  user_settings()->setValue("mouse/gain", std::clamp(gain, kLeastMouseGain, kMostMouseGain));
}

}  // namespace vallecula::gui
