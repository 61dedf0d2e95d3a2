#include "gui/pages/start_page.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
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

constexpr const char *kWatchExpert = "scripted:expert", *kWatchNovice = "scripted:novice";

QString passes_with(const curricula::Scenario& scenario) {
  QString text =
      QString(
          "Passes with: at most %1 N on the tongue and %2 N on the gum, at least %3 % of the glottis seen, "
          "within %4 s, at most %5 s above the training target of %6 N on the tongue and %7 s at the device's "
          "force limit.")
          .arg(scenario.pass.peak_tongue_force_n, 0, 'f', 1)
          .arg(scenario.pass.peak_gum_force_n, 0, 'f', 1)
          .arg(scenario.pass.glottis_visible_percent, 0, 'f', 0)
          .arg(scenario.pass.attempt_time_s, 0, 'f', 0)
          .arg(scenario.pass.time_over_target_s, 0, 'f', 1)
          .arg(scenario.targets.tongue_force_n, 0, 'f', 1)
          .arg(scenario.pass.time_over_device_limit_s, 0, 'f', 1);
  if (!scenario.intubation) return text;
  const curricula::IntubationPass& pass = scenario.intubation->pass;
  QStringList tube, outcomes;
  for (const curricula::Outcome outcome : pass.outcomes) outcomes << QString(name_of(outcome)).replace('-', ' ');
  tube << "outcome: " + outcomes.join(" or ");
  if (pass.attempts) tube << QString("at most %1 attempts").arg(*pass.attempts);
  if (pass.time_to_pass_s) tube << QString("at most %1 s from the view to the cords passed").arg(*pass.time_to_pass_s);
  if (pass.lowest_spo2_percent) tube << QString("SpO2 not below %1 %").arg(*pass.lowest_spo2_percent);
  if (pass.lowest_heart_per_min) tube << QString("heart rate not below %1").arg(*pass.lowest_heart_per_min);
  if (pass.tube_force_n) tube << QString("at most %1 N along the tube").arg(*pass.tube_force_n);
  if (pass.co2_confirmed) tube << "the place confirmed by CO2";
  return text + " The tube: " + tube.join(", ") + ".";
}

/// Marks an entry that stands for something plugged in.
constexpr int kPluggedIn = Qt::UserRole + 1;

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  auto* title = new QLabel("Vallecula", this);
  title->setObjectName("title");
  auto* sub = new QLabel(
      "Practise neonatal intubation, and see what your hands did. A training tool, not a medical device.", this);
  sub->setObjectName("faint");
  curriculum_ = new QComboBox(this);
  curriculum_->setObjectName("curriculum");
  curriculum_->setAccessibleName("Curriculum");
  list_ = new QListWidget(this);
  list_->setAccessibleName("Scenarios");
  briefing_ = new QLabel(this);
  briefing_->setWordWrap(true);
  briefing_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  briefing_->setMinimumWidth(380);
  patient_ = new QComboBox(this);
  patient_->addItem("Built-in manikin, made for the scenario", QString());
  device_ = new QComboBox(this);
  device_->setObjectName("device");
  for (const device::DeviceKind& kind : device::device_kinds()) {
    if (!kind.argument.empty() || kind.hardware) continue;  // asks for more than a choice; offered when it is found
    device_->addItem(capitalised(QString::fromStdString(kind.description)), QString::fromStdString(kind.kind));
  }
  device_->addItem("Watch a scripted expert", kWatchExpert);
  device_->addItem("Watch a scripted novice", kWatchNovice);
  second_ = new QComboBox(this);
  second_->setObjectName("second");
  second_->addItem("The same device, blade and tube in turn (X changes)", QString());
  second_->addItem("The mouse", "mouse");
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
  left->addWidget(curriculum_);
  left->addWidget(list_, 1);
  auto* courses = new QPushButton("&Write a course ...", this);
  courses->setObjectName("courses");
  courses->setToolTip("Create, change, try, compare and share courses");
  connect(courses, &QPushButton::clicked, this, &StartPage::courses_wanted);
  left->addWidget(courses);
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
  second_label_ = new QLabel("Tube's hand", this);
  form->addRow(second_label_, second_);
  blade_label_ = new QLabel("Blade", this);
  blade_ = new QComboBox(this);
  blade_->setObjectName("blade");
  tube_label_ = new QLabel("Tube", this);
  tube_ = new QComboBox(this);
  tube_->setObjectName("tube");
  form->addRow(blade_label_, blade_);
  form->addRow(tube_label_, tube_);
  for (QComboBox* box : {blade_, tube_})
    connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::allow_start);
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

  connect(curriculum_, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::show_curriculum);
  connect(device_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this] { show_scenario(list_->currentRow()); });
  connect(list_, &QListWidget::currentRowChanged, this, &StartPage::show_scenario);
  connect(list_, &QListWidget::itemActivated, this, [this] { go_->click(); });
  connect(go_, &QPushButton::clicked, this, [this] {
    if (list_->currentRow() >= 0 && go_->isEnabled()) emit chosen(choice());
  });
  go_->setEnabled(false);
}

void StartPage::set_curricula(std::vector<curricula::Curriculum> curricula) {
  const int index = std::max(0, curriculum_->currentIndex());
  {
    const QSignalBlocker quiet(curriculum_);
    curricula_ = std::move(curricula);
    curriculum_->clear();
    for (const auto& one : curricula_) curriculum_->addItem(QString::fromStdString(one.title));
    curriculum_->setCurrentIndex(std::min(index, curriculum_->count() - 1));
  }
  curriculum_->setEnabled(curricula_.size() > 1);
  show_curriculum(curriculum_->currentIndex());
}

void StartPage::show_curriculum(int index) {
  const int row = std::max(0, list_->currentRow());
  list_->clear();
  if (index >= 0)
    for (const auto& scenario : curricula_[static_cast<std::size_t>(index)].scenarios)
      list_->addItem(QString::fromStdString(scenario.title));
  if (list_->count() > 0) list_->setCurrentRow(std::min(row, list_->count() - 1));
  allow_start();
}

const curricula::Scenario* StartPage::scenario_at(int row) const {
  if (curriculum_->currentIndex() < 0) return nullptr;
  const auto& scenarios = curricula_[static_cast<std::size_t>(curriculum_->currentIndex())].scenarios;
  return row >= 0 && row < static_cast<int>(scenarios.size()) ? &scenarios[static_cast<std::size_t>(row)] : nullptr;
}

void StartPage::show_scenario(int row) {
  const curricula::Scenario* scenario = scenario_at(row);
  if (scenario == nullptr) return;
  briefing_->setText(html_of(scenario->briefing) + "<p>" + passes_with(*scenario).toHtmlEscaped() + "</p>");
  const bool tube = scenario->intubation.has_value();
  // A scripted novice lifts and levers, but has no tube.
  const int novice = device_->findData(kWatchNovice);
  if (auto* model = qobject_cast<QStandardItemModel*>(device_->model())) model->item(novice)->setEnabled(!tube);
  if (tube && device_->currentIndex() == novice) device_->setCurrentIndex(device_->findData(kWatchExpert));
  const QString device = device_->currentData().toString();
  const bool choice = tube && !is_scripted(device.toStdString()) && device != "mouse";
  second_->setVisible(choice);
  second_label_->setVisible(choice);
  offer(*scenario);
}

void StartPage::offer(const curricula::Scenario& scenario) {
  const auto fill = [](QComboBox* box, QLabel* label, const std::vector<std::string>& offered, const char* form) {
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItem("Choose for this infant ...", QString());
    for (const std::string& one : offered) {
      const QString name = QString::fromStdString(one);
      box->addItem(QString(form).arg(capitalised(QString(name).replace('-', ' '))), name);
    }
    box->setVisible(!offered.empty());
    label->setVisible(!offered.empty());
  };
  fill(blade_, blade_label_, scenario.offered_blades, "%1");
  fill(tube_, tube_label_, scenario.intubation ? scenario.intubation->offered_tubes : std::vector<std::string>(),
       "%1 mm inner diameter");
  allow_start();
}

void StartPage::allow_start() {
  bool open = false;
  for (const QComboBox* box : {blade_, tube_})
    open = open || (box->count() > 1 && box->currentData().toString().isEmpty());
  go_->setEnabled(list_->count() > 0 && !open);
  go_->setToolTip(open ? "Choose blade and tube first: they count in the score" : "");
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
  for (std::size_t c = 0; c < curricula_.size() && !found; ++c)
    for (std::size_t i = 0; i < curricula_[c].scenarios.size() && !found; ++i) {
      if (curricula_[c].scenarios[i].id != scenario.toStdString()) continue;
      curriculum_->setCurrentIndex(static_cast<int>(c));
      list_->setCurrentRow(static_cast<int>(i));
      found = true;
    }
  const int index = device_->findData(device);
  if (index >= 0) device_->setCurrentIndex(index);
  return found && index >= 0;
}

Choice StartPage::hands() const {
  Choice choice;
  choice.patient = patient_->currentData().toString().toStdString();
  choice.device = device_->currentData().toString();
  choice.second = second_->currentData().toString();
  return choice;
}

Choice StartPage::choice() const {
  const auto& curriculum = curricula_.at(static_cast<std::size_t>(std::max(0, curriculum_->currentIndex())));
  return {curriculum.file, curriculum.scenarios.at(static_cast<std::size_t>(std::max(0, list_->currentRow()))),
          patient_->currentData().toString().toStdString(), device_->currentData().toString(),
          {blade_->currentData().toString().toStdString(), tube_->currentData().toString().toStdString()},
          second_->isVisibleTo(this) ? second_->currentData().toString() : QString()};
}

}  // namespace vallecula::gui
