#include "gui/import/build_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/import/import_work.h"
#include "gui/import/quality_list.h"
#include "gui/import/work_strip.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

BuildPage::BuildPage(ImportWork& work, QWidget* parent) : QWidget(parent), work_(work) {
  verdict_ = new QLabel(this);
  verdict_->setObjectName("heading");
  verdict_->setWordWrap(true);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setStyleSheet(QString("color: %1;").arg(theme::kOver.name()));
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  quality_ = new QualityList(this);
  strip_ = new WorkStrip(work_, this);
  leave_ = new QPushButton("Leave", this);
  back_ = new QPushButton("Back to the &check", this);
  save_ = new QPushButton("&Save the patient", this);
  save_->setObjectName("primary");
  practise_ = new QPushButton("&Practise with this patient", this);
  practise_->setObjectName("primary");
  auto* foot = new QHBoxLayout;
  foot->addWidget(leave_);
  foot->addWidget(back_);
  foot->addStretch(1);
  foot->addWidget(save_);
  foot->addWidget(practise_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(10);
  all->addWidget(verdict_);
  all->addWidget(strip_);
  all->addWidget(quality_, 1);
  all->addWidget(message_);
  all->addLayout(foot);
  connect(back_, &QPushButton::clicked, this, &BuildPage::back_wanted);
  connect(leave_, &QPushButton::clicked, this, &BuildPage::left);
  connect(save_, &QPushButton::clicked, this, &BuildPage::write_wanted);
  connect(practise_, &QPushButton::clicked, this, &BuildPage::practise_wanted);
}

void BuildPage::show_building() {
  built_ = written_ = false;
  quality_->show_items({});
  verdict_->setText("Building the patient");
  message_->clear();
  strip_->begin("Making the surfaces");
  show_state();
}

void BuildPage::show_report(const std::vector<pipeline::QualityItem>& quality) {
  built_ = true;
  quality_->show_items(quality);
  const int look = quality_->to_look_at();
  verdict_->setText(look == 0 ? QString("The patient is built. Nothing stands out.")
                              : QString("The patient is built. %1 to be looked at first: marked LOOK.")
                                    .arg(look == 1 ? QString("One thing is") : QString("%1 things are").arg(look)));
  show_state();
  save_->setFocus();
}

void BuildPage::show_writing() {
  message_->clear();
  strip_->begin("Writing the patient");
  show_state();
}

void BuildPage::show_written(const QString& package) {
  written_ = true;
  verdict_->setText("The patient is saved.");
  message_->setText("In " + package);
  show_state();
  practise_->setFocus();
}

void BuildPage::show_message(const QString& message) {
  message_->setText(message);
  if (!built_) verdict_->setText("The patient could not be built.");
  show_state();
}

void BuildPage::show_state() {
  const bool busy = work_.busy();
  strip_->setVisible(busy);
  back_->setEnabled(!busy && !written_);
  leave_->setEnabled(!busy);
  save_->setVisible(!written_);
  save_->setEnabled(!busy && built_);
  practise_->setVisible(written_);
}

}  // namespace vallecula::gui
