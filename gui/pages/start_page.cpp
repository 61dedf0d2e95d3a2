#include "gui/pages/start_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>
#include <stdexcept>

#include "device/factory.h"
#include "device/found_devices.h"
#include "gui/pages/device_dialog.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/module_tree.h"
#include "gui/pages/module_words.h"
#include "gui/pages/offered_tools.h"
#include "gui/pages/pass_words.h"
#include "gui/report/markdown.h"
#include "gui/session/device_choice.h"
#include "gui/session/device_rows.h"
#include "gui/session/recent_files.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr const char *kWatchExpert = "scripted:expert", *kWatchNovice = "scripted:novice";

/// Marks an entry that stands for something plugged in.
constexpr int kPluggedIn = Qt::UserRole + 1;

QString course_text(const curricula::Curriculum& curriculum) {
  QString text = "<p>" + QCoreApplication::translate("StartPage", "Whoever has finished this course can:") + "</p><ul>";
  for (const auto& goal : curriculum.goals) text += "<li>" + plain_of(goal).toHtmlEscaped() + "</li>";
  return text + "</ul>";
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  auto* title = new QLabel("Vallecula", this);
  title->setObjectName("title");
  auto* home = new QPushButton(tr("H&ome"), this);
  home->setObjectName("home");
  home->setToolTip(tr("Back to the first page (Esc)"));
  home->setShortcut(Qt::Key_Escape);
  connect(home, &QPushButton::clicked, this, &StartPage::home_wanted);
  auto* sub = new QLabel(
      tr("Practise neonatal intubation, and see what your hands did. A training tool, not a medical device."), this);
  sub->setObjectName("faint");
  curriculum_ = new QComboBox(this);
  curriculum_->setObjectName("curriculum");
  curriculum_->setAccessibleName(tr("Curriculum"));
  tree_ = new ModuleTree(this);
  briefing_ = new QLabel(this);
  briefing_->setWordWrap(true);
  briefing_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  mode_ = new QComboBox(this);
  mode_->setObjectName("mode");
  mode_->addItem(tr("Practice"), static_cast<int>(curricula::Mode::practice));
  mode_->addItem(tr("Assessment: no helps, own rating first, no replay"),
                 static_cast<int>(curricula::Mode::assessment));
  patient_ = new QComboBox(this);
  patient_->addItem(tr("Built-in manikin, made for the scenario"), QString());
  device_ = new QComboBox(this);
  device_->setObjectName("device");
  for (const device::DeviceKind& kind : device::device_kinds()) {
    if (!kind.argument.empty() || kind.hardware) continue;  // asks for more than a choice; offered when it is found
    device_->addItem(capitalised(in_words(kind.description)), QString::fromStdString(kind.kind));
  }
  device_->addItem(tr("Watch a scripted expert"), kWatchExpert);
  device_->addItem(tr("Watch a scripted novice"), kWatchNovice);
  second_ = new QComboBox(this);
  second_->setObjectName("second");
  second_->addItem(tr("The same device, blade and tube in turn (X changes)"), QString());
  second_->addItem(tr("The mouse"), "mouse");
  for (const auto& [box, name] : {std::pair(mode_, tr("Mode")),
                                  {patient_, tr("Patient")},
                                  {device_, tr("Device")},
                                  {second_, tr("Tube's hand")}}) {
    box->setAccessibleName(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // a small window cuts it short
    box->setMinimumContentsLength(16);
    connect(box, &QComboBox::currentTextChanged, box, &QWidget::setToolTip);
    box->setToolTip(box->currentText());
  }
  connect(mode_, qOverload<int>(&QComboBox::activated), this,
          [this] { mode_wanted_ = static_cast<curricula::Mode>(mode_->currentData().toInt()); });
  auto* browse = new QPushButton(tr("Other patient ..."), this);
  connect(browse, &QPushButton::clicked, this, &StartPage::browse);
  auto* from_ct = new QPushButton(tr("New patient from a CT ..."), this);
  connect(from_ct, &QPushButton::clicked, this, &StartPage::import_wanted);
  auto* devices = new QPushButton(tr("Devices ..."), this);
  connect(devices, &QPushButton::clicked, this, &StartPage::devices_wanted);
  go_ = new QPushButton(tr("Prepare the trial"), this);
  go_->setObjectName("primary");
  go_->setDefault(true);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* left = new QVBoxLayout;
  left->addWidget(curriculum_);
  left->addWidget(tree_, 1);
  auto* courses = new QPushButton(QCoreApplication::translate("StartPage", "&Write a course ..."), this);
  courses->setObjectName("courses");
  courses->setToolTip(QCoreApplication::translate("StartPage", "Create, change, try, compare and share courses"));
  connect(courses, &QPushButton::clicked, this, &StartPage::courses_wanted);
  left->addWidget(courses);
  auto* patient_row = new QHBoxLayout;
  patient_row->setSpacing(8);
  patient_row->addWidget(patient_, 1);
  patient_row->addWidget(browse);
  patient_row->addWidget(from_ct);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(12);
  form->addRow(QCoreApplication::translate("StartPage", "Patient"), patient_row);
  auto* device_row = new QHBoxLayout;
  device_row->setSpacing(8);
  auto* set_up = new QPushButton(QCoreApplication::translate("StartPage", "Device settings ..."), this);
  connect(set_up, &QPushButton::clicked, this, [this] {
    if (const auto dialog = device_settings()) dialog->exec();
  });
  device_row->addWidget(device_, 1);
  device_row->addWidget(devices);
  device_row->addWidget(set_up);
  form->addRow(QCoreApplication::translate("StartPage", "Device"), device_row);
  second_label_ = new QLabel(QCoreApplication::translate("StartPage", "Tube's hand"), this);
  form->addRow(second_label_, second_);
  mode_label_ = new QLabel(QCoreApplication::translate("StartPage", "Mode"), this);
  form->addRow(mode_label_, mode_);
  offered_ = new OfferedTools(this);
  form->addRow(offered_);
  connect(offered_, &OfferedTools::changed, this, &StartPage::allow_start);
  auto* right_panel = new QFrame(this);
  right_panel->setObjectName("panel");
  auto* right = new QVBoxLayout(right_panel);
  right->setContentsMargins(18, 16, 18, 16);
  heading_ = new QLabel(this);
  heading_->setObjectName("heading");
  heading_->setWordWrap(true);
  why_ = new QLabel(this);
  why_->setWordWrap(true);
  why_->setProperty("role", "warning");
  auto* scrolled = new QScrollArea(this);  // a course's texts are as long as its author likes
  scrolled->setWidget(briefing_);
  scrolled->setWidgetResizable(true);
  for (QWidget* ground : {scrolled->viewport(), static_cast<QWidget*>(briefing_)})
    ground->setAutoFillBackground(false);  // the panel's own shows
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
  auto* head = new QHBoxLayout;
  head->addWidget(title, 1);
  head->addWidget(home);
  all->addLayout(head);
  all->addWidget(sub);
  all->addSpacing(10);
  all->addLayout(columns, 1);
  all->addWidget(message_);

  connect(curriculum_, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::show_modules);
  for (QComboBox* hand : {device_, second_})
    connect(hand, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::show_modules);
  connect(tree_, &ModuleTree::chosen, this, &StartPage::show_chosen);
  connect(tree_, &QTreeWidget::itemActivated, this, [this] { go_->click(); });
  connect(go_, &QPushButton::clicked, this, [this] {
    if (tree_->scenario() != nullptr && go_->isEnabled()) emit chosen(choice());
  });
  for (QComboBox* box : {patient_, device_, second_, mode_})
    connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::changed);
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
  show_modules();
}

void StartPage::set_past(PastResults past, bool all_open) {
  past_ = std::move(past);
  all_open_ = all_open;
  show_modules();
}

const curricula::Curriculum* StartPage::curriculum() const {
  return curriculum_->currentIndex() < 0 ? nullptr : &curricula_[static_cast<std::size_t>(curriculum_->currentIndex())];
}

bool StartPage::watching() const { return is_scripted(device_->currentData().toString().toStdString()); }

std::string StartPage::kinds() const {
  const auto kind = [](const QComboBox* box) { return box->currentData().toString().section(':', 0, 0).toStdString(); };
  const std::string blade = kind(device_), tube = kind(second_);
  return watching() || blade == "mouse" || tube.empty() ? blade : blade + "+" + tube;
}

void StartPage::show_modules() {
  std::vector<curricula::PastResult> past;
  if (curriculum() != nullptr) past = with_hands(past_[curriculum()->id], *curriculum(), kinds());
  tree_->show_course(curriculum(), past, kinds(), all_open_ || watching());
}

void StartPage::forget_mode() {
  mode_wanted_ = curricula::Mode::practice;
  show_chosen();
}

QStringList StartPage::states() const { return tree_->states(); }

void StartPage::show_chosen() {
  why_->hide();
  go_->setEnabled(false);
  if (curriculum() == nullptr) {
    heading_->clear();
    briefing_->clear();
  } else if (const curricula::Scenario* scenario = tree_->scenario()) {
    show_scenario(*scenario);
  } else if (const curricula::Module* module = tree_->module()) {
    const curricula::ModuleProgress& progress = tree_->progress_of(*module);
    const QString closed = tree_->why_closed(*curriculum()->find(module->scenarios.front()));
    heading_->setText(QString::fromStdString(module->title));
    briefing_->setText(html_of(module->goal) + "<p><b>" + capitalised(state_of(progress)) +
                       "</b>: " + progress_line(*module, progress).toHtmlEscaped() + ". " + closed.toHtmlEscaped() +
                       "</p><p>" + mastery_rule(*module).toHtmlEscaped() + ' ' +
                       tr("Trials with another kind of device do not count here.") + "</p>");
  } else {
    heading_->setText(QString::fromStdString(curriculum()->title));
    briefing_->setText(course_text(*curriculum()));
  }
  emit changed();
}

void StartPage::show_scenario(const curricula::Scenario& scenario) {
  heading_->setText(QString::fromStdString(scenario.title));
  QString text = html_of(scenario.briefing) + "<p>" + passes_with(scenario).toHtmlEscaped() + "</p>";
  if (const curricula::Module* module = curriculum()->module_of(scenario.id)) {
    if (!watching())
      text += "<p>" + QString::fromStdString(module->title).toHtmlEscaped() + ": " +
              progress_line(*module, tree_->progress_of(*module)).toHtmlEscaped() + ".</p>";
    auto* modes = qobject_cast<QStandardItemModel*>(mode_->model());
    const auto may = [module](curricula::Mode mode) {
      return std::count(module->modes.begin(), module->modes.end(), mode) > 0;
    };
    for (int i = 0; i < mode_->count(); ++i)
      modes->item(i)->setEnabled(may(static_cast<curricula::Mode>(mode_->itemData(i).toInt())));
    const curricula::Mode mode = may(mode_wanted_) ? mode_wanted_ : module->modes.front();
    mode_->setCurrentIndex(mode_->findData(static_cast<int>(mode)));
  }
  briefing_->setText(text);
  const QString closed = tree_->why_closed(scenario);
  why_->setText(closed + (closed.isEmpty() ? QString() : ' ' + tr("A scripted hand can be watched at it before.")));
  why_->setVisible(!closed.isEmpty());
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
  offered_->offer(scenario);
  allow_start();
}

void StartPage::allow_start() {
  const curricula::Scenario* scenario = tree_->scenario();
  go_->setEnabled(scenario != nullptr && tree_->why_closed(*scenario).isEmpty() && !offered_->open());
  go_->setToolTip(offered_->open() ? tr("Choose blade and tube first: they count in the score") : "");
  emit changed();
}

void StartPage::show_course(const std::string& id) {
  for (std::size_t c = 0; c < curricula_.size(); ++c)
    if (curricula_[c].id == id) curriculum_->setCurrentIndex(static_cast<int>(c));
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

void StartPage::set_message(const QString& message) { message_->setText(message); }

bool StartPage::select(const QString& scenario, const QString& device) {
  bool found = false;
  for (std::size_t c = 0; c < curricula_.size() && !found; ++c) {
    if (curricula_[c].find(scenario.toStdString()) == nullptr) continue;
    curriculum_->setCurrentIndex(static_cast<int>(c));
    tree_->choose(scenario.toStdString());
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

NextTrial StartPage::next_trial() const {
  NextTrial next;
  next.patient = patient_->currentIndex() == 0 ? tr("the built-in manikin")
                                               : QString::fromStdString(std::filesystem::path(
                                                     patient_->currentData().toString().toStdString()).stem().string());
  next.device = device_->currentText();
  const curricula::Scenario* scenario = tree_->scenario();
  if (scenario == nullptr) {
    next.hindrance = tr("Choose a scenario of a course first.");
    return next;
  }
  next.scenario = tr("%1 (%2)").arg(QString::fromStdString(scenario->title), QString::fromStdString(curriculum()->title));
  const curricula::Module* module = curriculum()->module_of(scenario->id);
  const bool practised = module == nullptr || watching() ||
                         std::count(module->modes.begin(), module->modes.end(), curricula::Mode::practice) > 0;
  next.hindrance = tree_->why_closed(*scenario);
  if (next.hindrance.isEmpty() && offered_->open()) next.hindrance = tr("Blade and tube are to be chosen first.");
  if (next.hindrance.isEmpty() && !practised) next.hindrance = tr("It can only be taken as an assessment.");
  return next;
}

Choice StartPage::choice() const {
  const curricula::Scenario* scenario = tree_->scenario();
  if (scenario == nullptr) throw std::logic_error("no scenario is chosen");
  const auto mode = watching() ? curricula::Mode::practice : static_cast<curricula::Mode>(mode_->currentData().toInt());
  return {curriculum()->file,
          *scenario,
          patient_->currentData().toString().toStdString(),
          device_->currentData().toString(),
          offered_->taken(),
          second_->isVisibleTo(this) ? second_->currentData().toString() : QString(),
          mode};
}

}  // namespace vallecula::gui
