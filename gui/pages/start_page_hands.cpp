// Patients and devices that the course's page offers.
#include <QComboBox>
#include <QFileDialog>
#include <algorithm>

#include "gui/pages/device_dialog.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/start_page.h"
#include "gui/session/device_choice.h"
#include "gui/session/device_rows.h"
#include "gui/session/recent_files.h"

namespace vallecula::gui {
namespace {

/// Marks an entry that stands for something plugged in.
constexpr int kPluggedIn = Qt::UserRole + 1;

}  // namespace

void StartPage::add_patient(const std::filesystem::path& package, bool choose) {
  const QString path = QString::fromStdString(package.string());
  int index = patient_->findData(path);
  if (index < 0) {
    patient_->addItem(QString::fromStdString(package.filename().string()), path);
    index = patient_->count() - 1;
    patient_->setItemData(index, path, Qt::ToolTipRole);
  }
  if (choose) patient_->setCurrentIndex(index);
}

void StartPage::set_found_devices(const std::vector<device::FoundDevice>& devices) {
  found_ = devices;
  const auto is_there = [&devices](const QString& name) {
    return std::any_of(devices.begin(), devices.end(),
                       [&name](const device::FoundDevice& one) { return one.name == name.toStdString(); });
  };
  for (int i = device_->count() - 1; i >= 0; --i)
    if (device_->itemData(i, kPluggedIn).toBool() && i != device_->currentIndex() &&
        !is_there(device_->itemData(i).toString()))
      device_->removeItem(i);
  for (const device::FoundDevice& one : devices) {
    if (!usable(one)) continue;
    const QString name = QString::fromStdString(one.name);
    const int index = device_->findData(name);
    if (index < 0) {
      device_->addItem(device_label(one), name);
      device_->setItemData(device_->count() - 1, true, kPluggedIn);
    } else if (device_->itemData(index, kPluggedIn).toBool()) {
      device_->setItemText(index, device_label(one));
    }
  }
}

void StartPage::choose_device(const QString& name, const QString& label) {
  int index = device_->findData(name);
  if (index < 0) {
    device_->addItem(label, name);
    index = device_->count() - 1;
    device_->setItemData(index, true, kPluggedIn);
  }
  device_->setCurrentIndex(index);
}

std::unique_ptr<QDialog> StartPage::device_settings() {
  const std::string name = device_->currentData().toString().toStdString();
  for (const device::FoundDevice& found : found_) {
    if (found.name != name && found.info.kind != name) continue;
    if (DeviceDialog::has_settings(found.info)) {
      set_message("");
      return std::make_unique<DeviceDialog>(found.info, this);
    }
  }
  set_message(is_scripted(name)
                  ? tr("A scripted hand has nothing to set.")
                  : tr("This device was not found when devices were last looked for: plug it in, and look "
                       "again with Devices ..."));
  return nullptr;
}

void StartPage::browse() {
  const QString folder = QFileDialog::getExistingDirectory(
      this, tr("Choose a patient package (a folder NAME.patient)"), folder_to_open());
  if (folder.isEmpty()) return;
  keep_opened(folder);
  if (!std::filesystem::exists(std::filesystem::path(folder.toStdString()) / "patient.yaml")) {
    set_message(
        tr("%1 is not a patient package (it holds no patient.yaml); make one with `vallecula import`.").arg(folder));
    return;
  }
  set_message("");
  add_patient(folder.toStdString(), true);
}

}  // namespace vallecula::gui
