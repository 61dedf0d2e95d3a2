#include "gui/import/build_page.h"

#include <QCheckBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "gui/import/import_work.h"
#include "gui/import/quality_list.h"
#include "gui/import/work_strip.h"
#include "gui/views/theme.h"
#include "pipeline/mesh/anatomy_surfaces.h"

namespace vallecula::gui {

BuildPage::BuildPage(ImportWork& work, QWidget* parent) : QWidget(parent), work_(work) {
  verdict_ = new QLabel(this);
  verdict_->setObjectName("heading");
  verdict_->setWordWrap(true);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  quality_ = new QualityList(QualityList::Remarks::beside, this);
  strip_ = new WorkStrip(work_, this);
  leave_ = new QPushButton(tr("L&eave"), this);
  back_ = new QPushButton(tr("Back to the &check"), this);
  again_ = new QPushButton(tr("Build a&gain"), this);
  save_ = new QPushButton(tr("&Save the patient"), this);
  save_->setObjectName("primary");
  practise_ = new QPushButton(tr("&Practise with this patient"), this);
  practise_->setObjectName("primary");
  auto* foot = new QHBoxLayout;
  foot->addWidget(leave_);
  foot->addWidget(back_);
  foot->addStretch(1);
  foot->addWidget(again_);
  foot->addWidget(save_);
  foot->addWidget(practise_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(10);
  all->addWidget(verdict_);
  all->addWidget(strip_);
  all->addWidget(quality_, 1);
  all->addWidget(make_choices());
  all->addWidget(message_);
  all->addLayout(foot);
  connect(back_, &QPushButton::clicked, this, &BuildPage::back_wanted);
  connect(leave_, &QPushButton::clicked, this, &BuildPage::left);
  connect(again_, &QPushButton::clicked, this, &BuildPage::build_wanted);
  connect(save_, &QPushButton::clicked, this, &BuildPage::write_wanted);
  connect(practise_, &QPushButton::clicked, this, &BuildPage::practise_wanted);
}

QWidget* BuildPage::make_choices() {
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  keep_position_ = new QCheckBox(tr("&Leave mouth and neck as scanned"), panel);
  keep_position_->setToolTip(tr("Else a closed mouth is opened and the neck extended, as for an intubation"));
  newborn_size_ = new QCheckBox(tr("Scale to a &newborn's size"), panel);
  newborn_size_->setToolTip(tr("All lengths, so that the skull is as broad as a term newborn's"));
  tetrahedra_ = new QSpinBox(panel);
  tetrahedra_->setRange(pipeline::kFewestTetrahedra, pipeline::kMostTetrahedra);
  tetrahedra_->setSingleStep(1000);
  tetrahedra_->setAccessibleName(tr("Tetrahedra of the tongue"));
  tetrahedra_->setToolTip(tr("About so many (within 10 %): more are finer and slower"));
  name_ = new QLineEdit(panel);
  name_->setAccessibleName(tr("Name of the new patient"));
  name_->setMaximumWidth(320);
  name_problem_ = new QLabel(panel);
  theme::dress(*name_problem_, "color: @over@;");
  auto* how = new QHBoxLayout;
  how->setSpacing(18);
  how->addWidget(keep_position_);
  how->addWidget(newborn_size_);
  auto* count_name = new QLabel(tr("&Tetrahedra of the tongue"), panel);
  count_name->setBuddy(tetrahedra_);
  how->addWidget(count_name);
  how->addWidget(tetrahedra_);
  how->addStretch(1);
  auto* naming = new QHBoxLayout;
  naming->setSpacing(10);
  auto* name_name = new QLabel(tr("Na&me of the new patient"), panel);
  name_name->setBuddy(name_);
  naming->addWidget(name_name);
  naming->addWidget(name_);
  naming->addWidget(name_problem_, 1);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(16, 12, 16, 12);
  column->addLayout(how);
  column->addLayout(naming);
  begin({});
  connect(name_, &QLineEdit::textChanged, this, &BuildPage::show_state);
  for (QCheckBox* box : {keep_position_, newborn_size_})
    connect(box, &QCheckBox::toggled, this, &BuildPage::show_state);
  connect(tetrahedra_, qOverload<int>(&QSpinBox::valueChanged), this, &BuildPage::show_state);
  return panel;
}

void BuildPage::begin(const QString& name) {
  built_ = written_ = false;
  report_.clear();
  const BuildChoice usual;
  keep_position_->setChecked(usual.keep_position);
  newborn_size_->setChecked(usual.to_newborn_size);
  tetrahedra_->setValue(usual.tetrahedra);
  name_->setText(name);
}

BuildChoice BuildPage::choice() const {
  return {keep_position_->isChecked(), newborn_size_->isChecked(), tetrahedra_->value()};
}

QString BuildPage::name() const { return name_->text(); }

void BuildPage::show_building() {
  built_ = written_ = false;
  built_with_ = choice();
  quality_->show_items({});
  verdict_->setText(tr("Building the patient"));
  message_->clear();
  strip_->begin(tr("Bringing the patient into position"));
  show_state();
}

void BuildPage::show_report(const std::vector<pipeline::QualityItem>& quality,
                            const std::vector<pipeline::QualityItem>& checked) {
  built_ = true;
  quality_->show_items(quality, report_.empty() ? checked : report_);
  report_ = quality;
  const int check = quality_->to_check();
  verdict_->setText(check == 0 ? tr("The patient is built. Nothing stands out.")
                               : tr("The patient is built. %n thing(s) to be checked before it is saved.", "", check));
  show_state();
  save_->setFocus();
}

void BuildPage::show_writing() {
  message_->clear();
  strip_->begin(tr("Writing the patient"));
  show_state();
}

void BuildPage::show_written(const QString& package) {
  written_ = true;
  verdict_->setText(tr("The patient is saved and chosen for the next trial."));
  say(tr("In %1").arg(package), false);
  show_state();
  practise_->setFocus();
}

void BuildPage::say(const QString& message, bool problem) {
  theme::dress(*message_, problem ? "color: @over@;" : "color: @text@;");
  message_->setText(message);
}

void BuildPage::show_message(const QString& message) {
  say(message, true);
  if (!built_) verdict_->setText(tr("The patient could not be built."));
  show_state();
}

void BuildPage::show_state() {
  const bool busy = work_.busy();
  strip_->setVisible(busy);
  back_->setEnabled(!busy && !written_);
  leave_->setEnabled(!busy);
  save_->setVisible(!written_);
  const bool otherwise = !choice().same_position(built_with_) || choice().tetrahedra != built_with_.tetrahedra;
  const QString problem = written_ ? QString() : problem_with_name(name_->text());
  name_problem_->setText(problem);
  again_->setVisible(!written_);
  again_->setEnabled(!busy && (otherwise || !built_));
  save_->setEnabled(!busy && built_ && !otherwise && problem.isEmpty());
  for (QWidget* widget : {static_cast<QWidget*>(keep_position_), static_cast<QWidget*>(newborn_size_),
                          static_cast<QWidget*>(tetrahedra_), static_cast<QWidget*>(name_)})
    widget->setEnabled(!busy && !written_);
  practise_->setVisible(written_);
}

}  // namespace vallecula::gui
