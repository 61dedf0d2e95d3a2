#include "gui/records_pages/records_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/records_pages/account_tab.h"
#include "gui/records_pages/cohort_tab.h"
#include "gui/records_pages/people_tab.h"
#include "gui/records_pages/person_words.h"
#include "gui/records_pages/progress_tab.h"
#include "gui/records_pages/statements_line.h"

namespace vallecula::gui {

RecordsPage::RecordsPage(QWidget* parent) : QWidget(parent) {
  auto* title = new QLabel(tr("Records"), this);
  title->setObjectName("title");
  who_ = new QLabel(this);
  who_->setObjectName("faint");
  waiting_ = new QLabel(tr("Asking the records ..."), this);
  waiting_->setObjectName("faint");
  waiting_->hide();
  trouble_ = new QLabel(this);
  trouble_->setObjectName("records_trouble");
  trouble_->setWordWrap(true);
  trouble_->setProperty("role", "warning");
  trouble_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  trouble_->hide();
  again_ = new QPushButton(tr("Try a&gain"), this);
  again_->hide();
  tabs_ = new QTabWidget(this);
  account_ = new AccountTab(desk_, tabs_);
  progress_ = new ProgressTab(desk_, courses_, tabs_);
  cohort_ = new CohortTab(desk_, courses_, tabs_);
  people_ = new PeopleTab(desk_, tabs_);
  for (QWidget* tab : {static_cast<QWidget*>(cohort_), static_cast<QWidget*>(people_)})
    tab->hide();  // no tab until an instructor signs in: else it would lie over the others
  tabs_->addTab(progress_, tr("Progress"));
  tabs_->addTab(account_, tr("Sign in"));
  auto* back = new QPushButton(tr("Back"), this);
  back->setShortcut(Qt::Key_Escape);

  auto* head = new QHBoxLayout;
  head->addWidget(title);
  head->addSpacing(14);
  head->addWidget(who_);
  head->addStretch(1);
  head->addWidget(waiting_);
  head->addWidget(back);
  auto* bad = new QHBoxLayout;
  bad->addWidget(trouble_, 1);
  bad->addWidget(again_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(20, 14, 20, 14);
  all->addLayout(head);
  all->addLayout(bad);
  all->addWidget(tabs_, 1);
  statements_ = new StatementsLine(desk_, this);
  all->addWidget(statements_);

  connect(back, &QPushButton::clicked, this, &RecordsPage::left);
  connect(again_, &QPushButton::clicked, this, [this] {
    trouble_->setText(tr("Trying again ..."));
    desk_.ask_again();
  });
  connect(tabs_, &QTabWidget::currentChanged, this, &RecordsPage::refresh);
  connect(&desk_, &RecordsDesk::changed, this, &RecordsPage::show_tabs);
  connect(&desk_, &RecordsDesk::trouble, this, &RecordsPage::show_trouble);
  connect(&desk_, &RecordsDesk::answered, this, [this] {
    trouble_->hide();
    again_->hide();
  });
  connect(&desk_, &RecordsDesk::waiting, waiting_, &QLabel::setVisible);
  connect(account_, &AccountTab::people_changed, this, &RecordsPage::refresh);
  connect(people_, &PeopleTab::people_changed, this, &RecordsPage::refresh);
  connect(progress_, &ProgressTab::trial_wanted, this, [this](const QString& log, bool with_replay) {
    left_at_ = focusWidget() == nullptr ? progress_ : focusWidget();
    emit trial_wanted(log, with_replay);
  });
  const auto open_progress = [this](const curricula::CurveKey& key) {
    progress_->show_progress_of(key);
    tabs_->setCurrentWidget(progress_);
  };
  connect(cohort_, &CohortTab::curve_wanted, this, open_progress);
  connect(people_, &PeopleTab::progress_wanted, this, [open_progress](long long id) {
    open_progress({id, {}, {}, {}});
  });
  show_tabs();
}

void RecordsPage::show_tabs() {
  left_at_.clear();  // whoever comes now opened nothing here
  const bool signed_in = desk_.who().has_value();
  who_->setText(signed_in ? words_of(desk_.person()) : tr("nobody is signed in"));
  tabs_->setTabText(tabs_->indexOf(account_), signed_in ? tr("My account") : tr("Sign in"));
  const QSignalBlocker quiet(tabs_);
  for (const auto& [tab, title] : {std::pair<QWidget*, QString>(cohort_, tr("Cohort")), {people_, tr("People")}}) {
    const int index = tabs_->indexOf(tab);
    if (desk_.instructor() && index < 0) tabs_->addTab(tab, title);
    if (!desk_.instructor() && index >= 0) tabs_->removeTab(index);
  }
  if (isVisible()) {
    if (signed_in) tabs_->setCurrentWidget(desk_.instructor() ? static_cast<QWidget*>(cohort_) : progress_);
    refresh();
  }
}

void RecordsPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (left_at_) return take_back();
  if (!desk_.who()) tabs_->setCurrentWidget(account_);
  refresh();
}

/// From a trial that was opened here: the tab, and in it the row, are as they were left.
void RecordsPage::take_back() {
  QWidget* keys = left_at_;
  left_at_.clear();
  refresh();
  QTimer::singleShot(0, keys, [keys] { keys->setFocus(); });
}

void RecordsPage::refresh() {
  if (!isVisible()) return;
  statements_->refresh();
  QWidget* seen = tabs_->currentWidget();
  if (seen == account_) account_->refresh();
  if (seen == progress_) progress_->refresh();
  if (seen == cohort_) cohort_->refresh();
  if (seen == people_) people_->refresh();
}

void RecordsPage::show_trouble(const QString& message) {
  tell(message);
  again_->show();
}

void RecordsPage::tell_of_statements(const QString& line) { statements_->tell(line); }

void RecordsPage::register_trainee() {
  tabs_->setCurrentWidget(account_);
  account_->register_somebody(false);
}

void RecordsPage::tell(const QString& message) {
  trouble_->setText(message);
  trouble_->show();
  again_->hide();
}

WhoStrip::WhoStrip(RecordsDesk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  who_ = new QLabel(this);
  who_->setObjectName("who_is_signed_in");
  who_->setWordWrap(true);  // its longest sentence is not what a window must be wide for
  out_ = new QPushButton(tr("Sign out"), this);
  auto* records = new QPushButton(tr("&Records ..."), this);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(26, 8, 26, 0);
  row->addWidget(who_, 1);
  row->addWidget(out_);
  row->addWidget(records);
  connect(records, &QPushButton::clicked, this, &WhoStrip::records_wanted);
  connect(out_, &QPushButton::clicked, &desk_, &RecordsDesk::sign_out);
  connect(&desk_, &RecordsDesk::changed, this, &WhoStrip::show_who);
  show_who();
}

void WhoStrip::offer(QAction* action) {
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setFocusPolicy(Qt::StrongFocus);
  qobject_cast<QHBoxLayout*>(layout())->insertWidget(1, button);
}

void WhoStrip::show_who() {
  const bool signed_in = desk_.who().has_value();
  who_->setText(signed_in ? tr("Signed in: %1").arg(words_of(desk_.person()))
                          : tr("Nobody is signed in: trials belong to nobody. Records ... is where to sign in."));
  out_->setVisible(signed_in);
}

}  // namespace vallecula::gui
