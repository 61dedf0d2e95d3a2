// What is plugged in, kept up to date while it is looked at, and which of it to practise with.
#pragma once

#include <QPointer>
#include <QThread>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <vector>

#include "device/found_devices.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace vallecula::gui {

class DevicesPage : public QWidget {
  Q_OBJECT
 public:
  using Finder = std::function<std::vector<device::FoundDevice>()>;
  /// `find` is asked on a thread of its own, once a second while the page is shown.
  explicit DevicesPage(QWidget* parent = nullptr, Finder find = &device::find_devices);
  ~DevicesPage() override;
  /// Asks once now, shown or not; found() follows.
  void refresh();

 signals:
  void found(const std::vector<vallecula::device::FoundDevice>& devices);
  void chosen(const vallecula::device::FoundDevice& device);
  void check_wanted(const vallecula::device::FoundDevice& device);
  void left();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void show_list(const std::vector<device::FoundDevice>& devices);
  void show_selected();
  const device::FoundDevice* selected() const;

  Finder find_;
  std::vector<device::FoundDevice> devices_;
  QTableWidget* table_;
  QLabel* about_;
  QPushButton *use_, *check_;
  QTimer clock_;
  QPointer<QThread> worker_;
};

/// "SpaceMouse Compact (A17)": how a device is named in a list to choose from.
QString device_label(const device::FoundDevice& device);

}  // namespace vallecula::gui
