#include "gui/pages/start_page.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <stdexcept>

#include "device/factory.h"
#include "device/found_devices.h"
#include "gui/pages/device_dialog.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/module_words.h"
#include "gui/report/markdown.h"
#include "gui/session/device_choice.h"
#include "gui/session/device_rows.h"
#include "gui/views/capitalised.h"
#include "gui/views/theme.h"

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
  if (pass.depth_neutral) tube << "good depth with the head neutral, too";
  if (pass.oesophagus_in_time)
    tube << QString("a tube in the oesophagus recognised within %1 breaths").arg(scenario.intubation->breaths_to_confirm);
  if (pass.no_severe_desaturation) tube << "no fall of saturation by 20 points in an attempt";
  return text + " The tube: " + tube.join(", ") + ".";
}

/// Marks an entry that stands for something plugged in.
constexpr int kPluggedIn = Qt::UserRole + 1;

/// What a row of the tree stands for.
enum RowKind { kCourseRow, kModuleRow, kScenarioRow };
constexpr int kRowKind = Qt::UserRole, kRowId = Qt::UserRole + 1;
constexpr int kTitle = 0, kState = 1;

QString course_text(const curricula::Curriculum& curriculum) {
  QString text = "<p>Whoever has finished this course can:</p><ul>";
  for (const auto& goal : curriculum.goals) text += "<li>" + plain_of(goal).toHtmlEscaped() + "</li>";
  return text + "</ul>";
}

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
  tree_ = new QTreeWidget(this);
  tree_->setAccessibleName("Modules and scenarios");
  tree_->setColumnCount(2);
  tree_->setHeaderHidden(true);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(kTitle, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(kState, QHeaderView::ResizeToContents);
  tree_->setStyleSheet("QTreeView::item { padding: 6px 4px; }");
  tree_->setIndentation(18);
  briefing_ = new QLabel(this);
  briefing_->setWordWrap(true);
  briefing_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  mode_ = new QComboBox(this);
  mode_->setObjectName("mode");
  mode_->addItem("Practice", static_cast<int>(curricula::Mode::practice));
  mode_->addItem("Assessment: as written, no helps, you rate yourself first, replay locked",
                 static_cast<int>(curricula::Mode::assessment));
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
  left->addWidget(tree_, 1);
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
  mode_label_ = new QLabel("Mode", this);
  form->addRow(mode_label_, mode_);
  auto* right_panel = new QFrame(this);
  right_panel->setObjectName("panel");
  auto* right = new QVBoxLayout(right_panel);
  right->setContentsMargins(18, 16, 18, 16);
  heading_ = new QLabel(this);
  heading_->setObjectName("heading");
  heading_->setWordWrap(true);
  why_ = new QLabel(this);
  why_->setWordWrap(true);
  why_->setStyleSheet(QString("color: %1;").arg(theme::kOver.name()));
  auto* scrolled = new QScrollArea(this);  // a course's texts are as long as its author likes
  scrolled->setWidget(briefing_);
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scrolled->setFocusPolicy(Qt::NoFocus);
  scrolled->setMinimumWidth(400);
  right->addWidget(heading_);
  right->addWidget(scrolled, 1);
  right->addLayout(form);
  right->addSpacing(6);
  right->addWidget(why_);
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
  for (QComboBox* hand : {device_, second_})
    connect(hand, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::show_modules);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &StartPage::show_chosen);
  connect(tree_, &QTreeWidget::itemActivated, this, [this] { go_->click(); });
  connect(go_, &QPushButton::clicked, this, [this] { emit chosen(choice()); });
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

void StartPage::set_past(PastResults past) {
  past_ = std::move(past);
  show_modules();
}

const curricula::Curriculum* StartPage::curriculum() const {
  return curriculum_->currentIndex() < 0 ? nullptr
                                         : &curricula_[static_cast<std::size_t>(curriculum_->currentIndex())];
}

const curricula::Scenario* StartPage::chosen_scenario() const {
  const QTreeWidgetItem* item = tree_->currentItem();
  if (curriculum() == nullptr || item == nullptr || item->data(kTitle, kRowKind).toInt() != kScenarioRow) return nullptr;
  return curriculum()->find(item->data(kTitle, kRowId).toString().toStdString());
}

bool StartPage::watching() const { return is_scripted(device_->currentData().toString().toStdString()); }

std::string StartPage::hands() const {
  const auto kind = [](const QComboBox* box) {
    return box->currentData().toString().section(':', 0, 0).toStdString();
  };
  const std::string blade = kind(device_), tube = kind(second_);
  return watching() || blade == "mouse" || tube.empty() ? blade : blade + "+" + tube;
}

void StartPage::show_curriculum(int) {
  {
    const QSignalBlocker quiet(tree_);
    tree_->clear();  // what was chosen was another curriculum's
  }
  show_modules();
}

void StartPage::add_scenario(QTreeWidgetItem* to, const std::string& id,
                             const std::vector<curricula::PastResult>& past) {
  auto* row = new QTreeWidgetItem(to);
  row->setText(kTitle, QString::fromStdString(curriculum()->find(id)->title));
  row->setData(kTitle, kRowKind, kScenarioRow);
  row->setData(kTitle, kRowId, QString::fromStdString(id));
  const bool passed = std::any_of(past.begin(), past.end(), [&](const curricula::PastResult& result) {
    return result.scenario_id == id && result.device_kind == hands() && result.passed;
  });
  row->setText(kState, passed ? "passed" : "");
  row->setForeground(kState, theme::kWithin.lighter(130));
  if (!watching() && !why_closed(*curriculum(), progress_, id).isEmpty()) row->setForeground(kTitle, theme::kFaint);
}

void StartPage::show_modules() {
  const QTreeWidgetItem* before = tree_->currentItem();
  const QString chosen = before != nullptr ? before->data(kTitle, kRowId).toString() : QString();
  const QSignalBlocker quiet(tree_);
  tree_->clear();
  progress_.clear();
  if (curriculum() != nullptr) {
    const auto past = with_hands(past_[curriculum()->id], *curriculum(), hands());
    progress_ = curricula::progress_of(*curriculum(), past, hands());
    if (!curriculum()->goals.empty()) {
      auto* course = new QTreeWidgetItem(tree_->invisibleRootItem());
      course->setText(kTitle, "About this course");
      course->setData(kTitle, kRowKind, kCourseRow);
      course->setData(kTitle, kRowId, ":course");
      course->setForeground(kTitle, theme::kFaint);
    }
    const bool one = curriculum()->modules.size() == 1;  // its only module needs no row of its own
    for (std::size_t m = 0; m < curriculum()->modules.size(); ++m) {
      const curricula::Module& module = curriculum()->modules[m];
      QTreeWidgetItem* row = tree_->invisibleRootItem();
      if (!one) {
        row = new QTreeWidgetItem(tree_->invisibleRootItem());
        QFont font = row->font(kTitle);
        font.setBold(true);
        row->setFont(kTitle, font);
        row->setText(kTitle, QString("%1  %2").arg(m + 1).arg(QString::fromStdString(module.title)));
        row->setData(kTitle, kRowKind, kModuleRow);
        row->setData(kTitle, kRowId, ":" + QString::fromStdString(module.id));
        row->setText(kState, state_of(progress_[m]));
        row->setForeground(kState, progress_[m].mastered ? theme::kWithin.lighter(130)
                                   : progress_[m].open   ? theme::kText
                                                         : theme::kFaint);
      }
      for (const std::string& id : module.scenarios) add_scenario(row, id, past);
      if (!one) row->setExpanded(progress_[m].open && !progress_[m].mastered);
    }
  }
  QTreeWidgetItem* now = chosen.isEmpty() ? nullptr : item_of(chosen);
  tree_->setCurrentItem(now != nullptr ? now : next_to_do());
  show_chosen();
}

QTreeWidgetItem* StartPage::item_of(const QString& id) const {
  for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it)
    if ((*it)->data(kTitle, kRowId).toString() == id) return *it;
  return nullptr;
}

QTreeWidgetItem* StartPage::next_to_do() const {
  QTreeWidgetItem* first = nullptr;
  for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it) {
    if ((*it)->data(kTitle, kRowKind).toInt() != kScenarioRow) continue;
    if (first == nullptr) first = *it;
    const std::string id = (*it)->data(kTitle, kRowId).toString().toStdString();
    if ((*it)->text(kState).isEmpty() && why_closed(*curriculum(), progress_, id).isEmpty()) return *it;
  }
  return first;
}

QStringList StartPage::states() const {
  QStringList states;
  for (std::size_t m = 0; m < progress_.size(); ++m)
    states << QString::fromStdString(curriculum()->modules[m].title) + ": " + state_of(progress_[m]);
  return states;
}

void StartPage::show_chosen() {
  why_->clear();
  why_->hide();
  go_->setEnabled(false);
  const QTreeWidgetItem* item = tree_->currentItem();
  if (curriculum() == nullptr || item == nullptr) {
    heading_->clear();
    briefing_->clear();
    return;
  }
  if (const curricula::Scenario* scenario = chosen_scenario()) {
    show_scenario(*scenario);
    return;
  }
  heading_->setText(item->text(kTitle));
  if (item->data(kTitle, kRowKind).toInt() == kCourseRow) {
    briefing_->setText(course_text(*curriculum()));
    return;
  }
  for (std::size_t m = 0; m < curriculum()->modules.size(); ++m) {
    const curricula::Module& module = curriculum()->modules[m];
    if (":" + QString::fromStdString(module.id) != item->data(kTitle, kRowId).toString()) continue;
    const QString closed =
        progress_[m].open ? QString() : why_closed(*curriculum(), progress_, module.scenarios.front());
    briefing_->setText(html_of(module.goal) + "<p><b>" + capitalised(state_of(progress_[m])) + "</b>: " +
                       progress_line(module, progress_[m]).toHtmlEscaped() + ". " + closed.toHtmlEscaped() + "</p><p>" +
                       mastery_rule(module).toHtmlEscaped() +
                       " Trials with another kind of device do not count here.</p>");
  }
}

void StartPage::show_scenario(const curricula::Scenario& scenario) {
  heading_->setText(QString::fromStdString(scenario.title));
  QString text = html_of(scenario.briefing) + "<p>" + passes_with(scenario).toHtmlEscaped() + "</p>";
  if (const curricula::Module* module = curriculum()->module_of(scenario.id)) {
    const auto& progress = progress_[static_cast<std::size_t>(module - curriculum()->modules.data())];
    if (!watching())
      text += "<p>" + QString::fromStdString(module->title).toHtmlEscaped() + ": " +
              progress_line(*module, progress).toHtmlEscaped() + ".</p>";
    auto* modes = qobject_cast<QStandardItemModel*>(mode_->model());
    int allowed = -1;
    for (int i = mode_->count() - 1; i >= 0; --i) {
      const auto mode = static_cast<curricula::Mode>(mode_->itemData(i).toInt());
      const bool may = std::count(module->modes.begin(), module->modes.end(), mode) > 0;
      modes->item(i)->setEnabled(may);
      if (may) allowed = i;
    }
    if (allowed >= 0 && !modes->item(mode_->currentIndex())->isEnabled()) mode_->setCurrentIndex(allowed);
  }
  briefing_->setText(text);
  const QString closed = watching() ? QString() : why_closed(*curriculum(), progress_, scenario.id);
  why_->setText(closed + (closed.isEmpty() ? "" : " A scripted hand can be watched at it before."));
  why_->setVisible(!closed.isEmpty());
  go_->setEnabled(closed.isEmpty());
  mode_->setVisible(!watching());
  mode_label_->setVisible(!watching());
  const bool tube = scenario.intubation.has_value();
  // A scripted novice lifts and levers, but has no tube.
  const int novice = device_->findData(kWatchNovice);
  if (auto* model = qobject_cast<QStandardItemModel*>(device_->model())) model->item(novice)->setEnabled(!tube);
  if (tube && device_->currentIndex() == novice) device_->setCurrentIndex(device_->findData(kWatchExpert));
  const bool choice = tube && !watching() && device_->currentData().toString() != "mouse";
  second_->setVisible(choice);
  second_label_->setVisible(choice);
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
  for (std::size_t c = 0; c < curricula_.size() && !found; ++c) {
    if (curricula_[c].find(scenario.toStdString()) == nullptr) continue;
    curriculum_->setCurrentIndex(static_cast<int>(c));
    tree_->setCurrentItem(item_of(scenario));
    found = true;
  }
  const int index = device_->findData(device);
  if (index >= 0) device_->setCurrentIndex(index);
  return found && index >= 0;
}

Choice StartPage::choice() const {
  const curricula::Scenario* scenario = chosen_scenario();
  if (scenario == nullptr) throw std::logic_error("no scenario is chosen");
  const auto mode = watching() ? curricula::Mode::practice : static_cast<curricula::Mode>(mode_->currentData().toInt());
  return {curriculum()->file, *scenario, patient_->currentData().toString().toStdString(),
          device_->currentData().toString(), second_->isVisibleTo(this) ? second_->currentData().toString() : QString(),
          mode};
}

}  // namespace vallecula::gui
