#include "gui/pages/start_page.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "device/factory.h"
#include "device/found_devices.h"
#include "gui/pages/device_dialog.h"
#include "gui/pages/devices_page.h"
#include "gui/report/markdown.h"
#include "gui/session/device_choice.h"
#include "gui/session/device_rows.h"
#include "gui/views/capitalised.h"

namespace vallecula::gui {
namespace {

/// Marks an entry that stands for something plugged in.
constexpr int kPluggedIn = Qt::UserRole + 1;

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  auto* title = new QLabel("Vallecula", this);
  title->setObjectName("title");
  auto* sub = new QLabel(
      "Practise neonatal laryngoscopy, and see what your hand did. A training tool, not a medical device.", this);
  sub->setObjectName("faint");
  curriculum_title_ = new QLabel(this);
  curriculum_title_->setObjectName("heading");
  list_ = new QListWidget(this);
  list_->setAccessibleName("Scenarios");
  briefing_ = new QLabel(this);
  briefing_->setWordWrap(true);
  briefing_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  briefing_->setMinimumWidth(380);
  patient_ = new QComboBox(this);
  patient_->addItem("Built-in manikin, made for the scenario", QString());
  device_ = new QComboBox(this);
  for (const device::DeviceKind& kind : device::device_kinds()) {
    if (!kind.argument.empty() || kind.hardware) continue;  // asks for more than a choice; offered when it is found
    device_->addItem(capitalised(QString::fromStdString(kind.description)), QString::fromStdString(kind.kind));
  }
  device_->addItem("Watch a scripted expert", "scripted:expert");
  device_->addItem("Watch a scripted novice", "scripted:novice");
  auto* browse = new QPushButton("Other patient ...", this);
  connect(browse, &QPushButton::clicked, this, &StartPage::browse);
  auto* from_ct = new QPushButton("New patient from a CT ...", this);
  connect(from_ct, &QPushButton::clicked, this, &StartPage::import_wanted);
  auto* devices = new QPushButton("Devices ...", this);
  connect(devices, &QPushButton::clicked, this, &StartPage::devices_wanted);
  go_ = new QPushButton("Prepare the trial", this);
  go_->setObjectName("primary");
  go_->setDefault(true);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setStyleSheet("color: #e69f00;");
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* left = new QVBoxLayout;
  left->addWidget(curriculum_title_);
  left->addWidget(list_, 1);
  auto* patient_row = new QHBoxLayout;
  patient_row->setSpacing(8);
  patient_row->addWidget(patient_, 1);
  patient_row->addWidget(browse);
  patient_row->addWidget(from_ct);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(12);
  form->addRow("Patient", patient_row);
  auto* device_row = new QHBoxLayout;
  device_row->setSpacing(8);
  auto* set_up = new QPushButton("Device settings ...", this);
  connect(set_up, &QPushButton::clicked, this, [this] {
    if (const auto dialog = device_settings()) dialog->exec();
  });
  device_row->addWidget(device_, 1);
  device_row->addWidget(devices);
  device_row->addWidget(set_up);
  form->addRow("Device", device_row);
  auto* right_panel = new QFrame(this);
  right_panel->setObjectName("panel");
  auto* right = new QVBoxLayout(right_panel);
  right->setContentsMargins(18, 16, 18, 16);
  auto* briefing_title = new QLabel("Briefing", this);
  briefing_title->setObjectName("heading");
  right->addWidget(briefing_title);
  right->addWidget(briefing_, 1);
  right->addLayout(form);
  right->addSpacing(12);
  right->addWidget(go_);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(14);
  columns->addLayout(left, 10);
  columns->addWidget(right_panel, 14);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(26, 20, 26, 18);
  all->addWidget(title);
  all->addWidget(sub);
  all->addSpacing(10);
  all->addLayout(columns, 1);
  all->addWidget(message_);

  connect(list_, &QListWidget::currentRowChanged, this, &StartPage::show_scenario);
  connect(list_, &QListWidget::itemActivated, this, [this] { go_->click(); });
  connect(go_, &QPushButton::clicked, this, [this] {
    if (list_->currentRow() >= 0) emit chosen(choice());
  });
  go_->setEnabled(false);
}

void StartPage::set_curriculum(const curricula::Curriculum& curriculum) {
  const int row = std::max(0, list_->currentRow());
  curriculum_ = curriculum;
  curriculum_title_->setText(QString::fromStdString(curriculum.title));
  list_->clear();
  for (const auto& scenario : curriculum.scenarios) list_->addItem(QString::fromStdString(scenario.title));
  if (list_->count() > 0) list_->setCurrentRow(std::min(row, list_->count() - 1));
  go_->setEnabled(list_->count() > 0);
}

void StartPage::show_scenario(int row) {
  if (row < 0 || row >= static_cast<int>(curriculum_.scenarios.size())) return;
  const auto& scenario = curriculum_.scenarios[static_cast<std::size_t>(row)];
  briefing_->setText(
      html_of(scenario.briefing) +
      QString("<p>Passes with: at most %1 N on the tongue and %2 N on the gum, at least %3 % of the glottis seen, "
              "within %4 s, at most %5 s above the training target of %6 N on the tongue and %7 s at the device's "
              "force limit.</p>")
          .arg(scenario.pass.peak_tongue_force_n, 0, 'f', 1)
          .arg(scenario.pass.peak_gum_force_n, 0, 'f', 1)
          .arg(scenario.pass.glottis_visible_percent, 0, 'f', 0)
          .arg(scenario.pass.attempt_time_s, 0, 'f', 0)
          .arg(scenario.pass.time_over_target_s, 0, 'f', 1)
          .arg(scenario.targets.tongue_force_n, 0, 'f', 1)
          .arg(scenario.pass.time_over_device_limit_s, 0, 'f', 1));
}

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
  set_message(is_scripted(name) ? "A scripted hand has nothing to set."
                                : "This device was not found when devices were last looked for: plug it in, and look "
                                  "again with Devices ...");
  return nullptr;
}

void StartPage::browse() {
  const QString folder = QFileDialog::getExistingDirectory(this, "Choose a patient package (a folder NAME.patient)");
  if (folder.isEmpty()) return;
  if (!std::filesystem::exists(std::filesystem::path(folder.toStdString()) / "patient.yaml")) {
    set_message(folder + " is not a patient package (it holds no patient.yaml); make one with `vallecula import`.");
    return;
  }
  set_message("");
  add_patient(folder.toStdString(), true);
}

void StartPage::set_message(const QString& message) { message_->setText(message); }

bool StartPage::select(const QString& scenario, const QString& device) {
  bool found = false;
  for (std::size_t i = 0; i < curriculum_.scenarios.size(); ++i)
    if (curriculum_.scenarios[i].id == scenario.toStdString()) {
      list_->setCurrentRow(static_cast<int>(i));
      found = true;
    }
  const int index = device_->findData(device);
  if (index >= 0) device_->setCurrentIndex(index);
  return found && index >= 0;
}

Choice StartPage::choice() const {
  return {curriculum_.file, curriculum_.scenarios.at(static_cast<std::size_t>(std::max(0, list_->currentRow()))),
          patient_->currentData().toString().toStdString(), device_->currentData().toString()};
}

}  // namespace vallecula::gui
