#include "gui/import/import_wizard.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "gui/import/build_page.h"
#include "gui/import/check_page.h"
#include "gui/import/source_page.h"
#include "gui/import/window_message.h"
#include "gui/import/work_strip.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

ImportWizard::ImportWizard(QWidget* parent) : QWidget(parent) {
  pages_ = new QStackedWidget(this);
  source_ = new SourcePage(work_, pages_);
  segment_ = make_segment_page();
  check_ = new CheckPage(work_, pages_);
  build_ = new BuildPage(work_, pages_);
  for (QWidget* page :
       {static_cast<QWidget*>(source_), segment_, static_cast<QWidget*>(check_), static_cast<QWidget*>(build_)})
    pages_->addWidget(page);
  auto* head = new QHBoxLayout;
  head->setSpacing(22);
  for (const QString& text : {tr("1  Source"), tr("2  Segment"), tr("3  Check"), tr("4  Build")}) {
    steps_.push_back(new QLabel(text, this));
    head->addWidget(steps_.back());
  }
  head->addStretch(1);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(14, 10, 14, 10);
  all->setSpacing(10);
  all->addLayout(head);
  all->addWidget(pages_, 1);

  connect(source_, &SourcePage::chosen, this, &ImportWizard::begin_segmentation);
  connect(source_, &SourcePage::left, this, &ImportWizard::leave);
  connect(check_, &CheckPage::left, this, &ImportWizard::leave);
  connect(check_, &CheckPage::segment_wanted, this, [this] {
    if (work_.segment(check_->history().state())) check_->show_busy(tr("Finding the structures"));
  });
  connect(check_, &CheckPage::build_wanted, this, &ImportWizard::build);
  connect(build_, &BuildPage::build_wanted, this, &ImportWizard::build);
  connect(build_, &BuildPage::left, this, &ImportWizard::leave);
  connect(build_, &BuildPage::back_wanted, this, [this] { show_page(check_); });
  connect(build_, &BuildPage::write_wanted, this, [this] {
    if (work_.write(build_->name())) build_->show_writing();
  });
  connect(build_, &BuildPage::practise_wanted, this, [this] {
    const QString package = package_;
    stop();
    emit finished(package);
  });

  connect(&work_, &ImportWork::scan_read, this, [this] { check_->show_scan(work_.scan()); });
  connect(&work_, &ImportWork::segmented, this, [this](const SegmentedScan& scan) {
    check_->show_segmentation(scan);
    check_->show_busy();
    if (pages_->currentWidget() == segment_) show_page(check_);
  });
  connect(&work_, &ImportWork::built, this,
          [this] { build_->show_report(work_.import()->quality(), check_->report()); });
  connect(&work_, &ImportWork::written, this, [this](const QString& package) {
    package_ = package;
    build_->show_written(package);
    emit saved(package);
  });
  connect(&work_, &ImportWork::failed, this, &ImportWizard::job_failed);
  connect(&work_, &ImportWork::cancelled, this, &ImportWizard::job_cancelled);
}

QWidget* ImportWizard::make_segment_page() {
  auto* page = new QWidget(pages_);
  auto* title = new QLabel(tr("Reading the scan and finding the structures"), page);
  title->setObjectName("title");
  auto* about = new QLabel(tr("Nothing is written yet. You look at the result before it becomes a patient."), page);
  about->setObjectName("faint");
  for (QLabel* text : {title, about}) text->setWordWrap(true);
  strip_ = new WorkStrip(work_, page);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(160, 0, 160, 0);
  column->setSpacing(14);
  column->addStretch(1);
  column->addWidget(title);
  column->addWidget(about);
  column->addWidget(strip_);
  column->addStretch(2);
  return page;
}

void ImportWizard::show_page(QWidget* page) {
  pages_->setCurrentWidget(page);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const bool here = static_cast<int>(i) == pages_->currentIndex();
    theme::dress(*steps_[i],
                 here ? "color: @text@; font-weight: bold; font-size: @12pt@;" : "color: @faint@; font-size: @12pt@;");
  }
}

void ImportWizard::begin(const QString& source) {
  package_.clear();
  show_page(source_);
  source_->begin();
  if (!source.isEmpty()) source_->look_at(source);
}

void ImportWizard::stop() {
  show_page(source_);  // where job_cancelled() then lets go of the scan
  work_.cancel();
  work_.close();
  check_->clear();
}

void ImportWizard::leave() {
  const bool edited = check_->history().stack().count() > 0, built = build_->built();
  if ((edited || built) && package_.isEmpty() &&
      QMessageBox::question(this, tr("Leave the import"),
                            built ? tr("Leave without saving the patient? What was built is lost.")
                                  : tr("Leave without saving the patient? The edits made here are lost.")) !=
          QMessageBox::Yes)
    return;
  const QString package = package_;
  stop();
  package.isEmpty() ? emit left() : emit left_with(package);
}

void ImportWizard::build() {
  if (!work_.build(check_->history().state(), build_->choice())) return;
  show_page(build_);
  build_->show_building();
}

void ImportWizard::begin_segmentation(const ImportChoice& choice) {
  if (!work_.open(choice)) return;
  build_->begin(choice.name);
  strip_->begin(tr("Reading the series"));
  show_page(segment_);
}

void ImportWizard::job_failed(const QString& said) {
  const QString message = window_sentence(said);
  QWidget* page = pages_->currentWidget();
  if (page == build_) {
    build_->show_message(build_->built() ? message
                                         : message + '\n' + tr("Go back to the check and mend there what it names."));
  } else if (page == source_ || work_.import() == nullptr) {
    show_page(source_);
    source_->show_message(message);
  } else {
    // The scan was read: a person sees it, with what could not be found in it.
    show_page(check_);
    check_->show_failure(message);
  }
}

void ImportWizard::job_cancelled() {
  QWidget* page = pages_->currentWidget();
  if (page == segment_ || page == source_) {
    work_.close();
    check_->clear();
    show_page(source_);
    source_->show_message("");
  } else if (page == build_ && build_->built()) {
    build_->show_message(tr("Cancelled; nothing was saved."));
  } else {
    show_page(check_);
    check_->show_message(tr("Cancelled."));
  }
}

QString ImportWizard::step() const {
  const QWidget* page = pages_->currentWidget();
  return page == source_ ? "source" : page == segment_ ? "segment" : page == check_ ? "check" : "build";
}

}  // namespace vallecula::gui
