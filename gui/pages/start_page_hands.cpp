// Patients and devices that the course's page offers.
#include <QComboBox>
#include <QFileDialog>
#include <algorithm>

#include "gui/pages/device_dialog.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/fitting_scenario.h"
#include "gui/pages/module_tree.h"
#include "gui/pages/start_page.h"
#include "gui/session/device_choice.h"
#include "gui/session/device_rows.h"
#include "gui/session/patient_fit.h"
#include "gui/session/recent_files.h"
#include "gui/session/words_from_below.h"

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

void StartPage::take_patient(const std::filesystem::path& package) {
  add_patient(package, true);
  emit patient_taken(patient_->currentData().toString());
}

void StartPage::offer_start() { go_->setFocus(); }

std::string StartPage::chosen_scenario() const {
  const curricula::Scenario* chosen = tree_->scenario();
  return chosen == nullptr ? std::string() : chosen->id;
}

QString StartPage::fit_scenario(const std::filesystem::path& package, double weight_kg) {
  if (hands().patient != package) return {};
  const curricula::Scenario* chosen = tree_->scenario();
  if (chosen != nullptr && fits(*chosen, weight_kg)) return {};
  std::vector<OpenScenarios> open;
  const auto add = [&](const curricula::Curriculum& course) {
    open.push_back({&course, {}});
    const auto past = with_hands(past_[course.id], course, kinds());
    for (const curricula::ModuleProgress& module : curricula::progress_of(course, past, kinds()))
      open.back().ids.insert(open.back().ids.end(), module.open_scenarios.begin(), module.open_scenarios.end());
    if (!all_open_ && !watching()) return;
    open.back().ids.clear();
    for (const curricula::Scenario& one : course.scenarios) open.back().ids.push_back(one.id);
  };
  if (curriculum() != nullptr) add(*curriculum());
  for (const curricula::Curriculum& course : curricula_)
    if (&course != curriculum()) add(course);
  const QString patient_kg = decimal(weight_kg, 1);
  const FittingScenario found = fitting_scenario(open, chosen, weight_kg);
  if (found.scenario == nullptr)
    return chosen == nullptr
               ? QString()
               : tr("This patient is as large as an infant of %1 kg; the chosen scenario is for one of %2 kg. "
                    "None that is open is nearer: blade, tube and targets do not fit.")
                     .arg(patient_kg, decimal(chosen->manikin.weight_kg, 1));
  show_course(found.course->id);
  tree_->choose(found.scenario->id);
  return tr("This patient is as large as an infant of %1 kg: \"%2\" was chosen, with blade, tube and targets for %3 "
            "kg.")
      .arg(patient_kg, course_words(found.scenario->title), short_decimal(found.scenario->manikin.weight_kg, 3));
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
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Choose a patient package (a folder NAME.patient)"), folder_to_open());
  if (folder.isEmpty()) return;
  keep_opened(folder);
  if (!std::filesystem::exists(std::filesystem::path(folder.toStdString()) / "patient.yaml")) {
    set_message(
        tr("%1 is not a patient package (it holds no patient.yaml); make one with `vallecula import`.").arg(folder));
    return;
  }
  set_message("");
  take_patient(folder.toStdString());
}

}  // namespace vallecula::gui
