// The widgets of the course's page and where they are. What is made first is reached first by the Tab key.
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "device/factory.h"
#include "gui/pages/module_tree.h"
#include "gui/pages/offered_tools.h"
#include "gui/pages/start_page.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"

namespace vallecula::gui {

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  QLayout* head = make_head();
  make_choices();
  QLayout* patient_row = make_patient_row();
  auto* devices = new QPushButton(tr("Devices ..."), this);
  connect(devices, &QPushButton::clicked, this, &StartPage::devices_wanted);
  go_ = new QPushButton(tr("Prepare the trial"), this);
  go_->setObjectName("primary");
  go_->setDefault(true);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QLayout* left = make_left();
  QWidget* right = make_right(make_form(patient_row, devices));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(14);
  columns->addLayout(left, 10);
  columns->addWidget(right, 14);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(26, 20, 26, 18);
  all->addLayout(head);
  all->addSpacing(10);
  all->addLayout(columns, 1);
  all->addWidget(message_);
  connect_choices();
  go_->setEnabled(false);
}

QLayout* StartPage::make_head() {
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
  auto* line = new QHBoxLayout;
  line->addWidget(title, 1);
  line->addWidget(home);
  auto* head = new QVBoxLayout;
  head->addLayout(line);
  head->addWidget(sub);
  return head;
}

void StartPage::make_choices() {
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
}

QLayout* StartPage::make_patient_row() {
  auto* browse = new QPushButton(tr("Other patient ..."), this);
  connect(browse, &QPushButton::clicked, this, &StartPage::browse);
  auto* from_ct = new QPushButton(tr("New patient from a CT ..."), this);
  connect(from_ct, &QPushButton::clicked, this, &StartPage::import_wanted);
  auto* patient_row = new QHBoxLayout;
  patient_row->setSpacing(8);
  patient_row->addWidget(patient_, 1);
  patient_row->addWidget(browse);
  patient_row->addWidget(from_ct);
  return patient_row;
}

QLayout* StartPage::make_left() {
  auto* left = new QVBoxLayout;
  left->addWidget(curriculum_);
  left->addWidget(tree_, 1);
  auto* courses = new QPushButton(QCoreApplication::translate("StartPage", "&Write a course ..."), this);
  courses->setObjectName("courses");
  courses->setToolTip(QCoreApplication::translate("StartPage", "Create, change, try, compare and share courses"));
  connect(courses, &QPushButton::clicked, this, &StartPage::courses_wanted);
  left->addWidget(courses);
  return left;
}

QLayout* StartPage::make_form(QLayout* patient_row, QWidget* devices) {
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
  return form;
}

QWidget* StartPage::make_right(QLayout* form) {
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
  return right_panel;
}

void StartPage::connect_choices() {
  connect(curriculum_, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::show_modules);
  for (QComboBox* hand : {device_, second_})
    connect(hand, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::show_modules);
  connect(tree_, &ModuleTree::chosen, this, &StartPage::show_chosen);
  connect(tree_, &QTreeWidget::itemActivated, this, [this] { go_->click(); });
  connect(go_, &QPushButton::clicked, this, [this] {
    if (tree_->scenario() != nullptr && go_->isEnabled()) emit chosen(choice());
  });
  connect(patient_, qOverload<int>(&QComboBox::activated), this, [this] {
    if (patient_->currentIndex() > 0) emit patient_taken(patient_->currentData().toString());
  });
  for (QComboBox* box : {patient_, device_, second_, mode_})
    connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &StartPage::changed);
}

}  // namespace vallecula::gui
