// How a device is set up for its person: gain of the mouse; scale, side and hand of a device with axes of its own.
#pragma once

#include <QDialog>
#include <functional>

#include "device/haptic_device.h"

class QFormLayout;

namespace vallecula::gui {

/// Shows what was kept and keeps what is chosen when it is accepted. A device without axes of its own that is no mouse
/// has nothing to set; has_settings() says so beforehand.
class DeviceDialog : public QDialog {
  Q_OBJECT
 public:
  explicit DeviceDialog(const device::DeviceInfo& info, QWidget* parent = nullptr);
  static bool has_settings(const device::DeviceInfo& info) { return info.kind == "mouse" || info.own_axes; }

 private:
  void set_mouse(QFormLayout& form);
  void set_device(QFormLayout& form, const device::DeviceInfo& info);
  std::function<void()> keep_;
};

}  // namespace vallecula::gui
