#include "gui/pages/home_page.h"

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShowEvent>
#include <QVBoxLayout>
#include <utility>

#include "gui/pages/big_choice.h"
#include "gui/pages/start_page.h"

namespace vallecula::gui {
namespace {

constexpr int kPictureHeight = 150;

}  // namespace

HomePage::HomePage(QWidget* parent) : QWidget(parent) {
  auto* title = new QLabel("Vallecula", this);
  title->setObjectName("title");
  auto* sub = new QLabel(
      tr("Practise neonatal intubation, and see what your hands did. A training tool, not a medical device."), this);
  sub->setProperty("role", "faint");
  sub->setWordWrap(true);
  const auto choice = [this](const char* name, const QString& what, const QString& about, const QString& tip) {
    auto* made = new BigChoice(this);
    made->setObjectName(name);
    made->setProperty("role", "choice");
    made->say(what, about);
    made->setToolTip(tip);
    return made;
  };
  practise_ = choice("practise", tr("Practise"), {}, tr("Opens this trial (Enter); it begins with Start, once your hands are in place"));
  practise_->setProperty("role", "first-choice");
  course_ = choice("course", tr("Course"), tr("Choose a scenario, a patient and a device; see what is open and mastered"),
                   tr("All courses, module by module (Ctrl+2)"));
  import_ = choice("new_patient", tr("New patient from a CT"), tr("From a CT scan to a patient to practise on"),
                   tr("Opens the import of a CT; its folder can be dropped on the window as well (Ctrl+N)"));
  records_ = choice("records", tr("Records"), tr("Your trials and progress; for instructors the cohort"),
                    tr("Signing in, learning curves, trials to look at again (Ctrl+3)"));
  devices_ = choice("devices", tr("Devices"), tr("What is plugged in, and whether it is ready"),
                    tr("Haptic devices, SpaceMouse and mouse (Ctrl+4)"));
  connect(practise_, &QPushButton::clicked, this, &HomePage::practise_wanted);
  connect(course_, &QPushButton::clicked, this, &HomePage::course_wanted);
  connect(import_, &QPushButton::clicked, this, &HomePage::import_wanted);
  connect(records_, &QPushButton::clicked, this, &HomePage::records_wanted);
  connect(devices_, &QPushButton::clicked, this, &HomePage::devices_wanted);
  auto* choices = new QGridLayout;
  choices->setSpacing(12);
  choices->addWidget(practise_, 0, 0, 1, 2);
  choices->addWidget(course_, 1, 0);
  choices->addWidget(import_, 1, 1);
  choices->addWidget(records_, 2, 0);
  choices->addWidget(devices_, 2, 1);
  choices->setRowStretch(0, 3);
  for (const int row : {1, 2}) choices->setRowStretch(row, 2);
  for (const int column : {0, 1}) choices->setColumnStretch(column, 1);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addLayout(choices, 17);
  columns->addWidget(make_recent(), 8);
  notice_ = new QLabel(this);
  notice_->setObjectName("notice");
  notice_->setWordWrap(true);
  notice_->setTextFormat(Qt::RichText);
  notice_->setTextInteractionFlags(Qt::TextBrowserInteraction);  // links by mouse and keyboard
  notice_->hide();
  connect(notice_, &QLabel::linkActivated, this, &HomePage::link_followed);
  message_ = new QLabel(this);
  message_->setObjectName("message");
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  message_->hide();
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(26, 20, 26, 18);
  all->addWidget(title);
  all->addWidget(sub);
  all->addSpacing(10);
  all->addLayout(columns, 1);
  all->addWidget(notice_);
  all->addWidget(message_);
}

QWidget* HomePage::make_recent() {
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  auto* heading = new QLabel(tr("Recent"), panel);
  heading->setObjectName("heading");
  recent_ = new QListWidget(panel);
  recent_->setObjectName("recent");
  recent_->setAccessibleName(tr("Recent patients, courses and trials"));
  recent_->setToolTip(tr("Enter or double click opens it"));
  recent_->setWordWrap(true);
  recent_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(recent_, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { emit recent_wanted(item->data(Qt::UserRole).toString()); });
  no_recent_ = new QLabel(tr("Patients, courses and trials that you open are kept here. You can also drop a CT's folder, a "
                             "patient, a course or a trial on this window."),
                          panel);
  no_recent_->setWordWrap(true);
  no_recent_->setProperty("role", "faint");
  no_recent_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* write = new QPushButton(tr("&Write a course ..."), panel);
  write->setObjectName("write_course");
  write->setToolTip(tr("Create, change, try, compare and share courses"));
  connect(write, &QPushButton::clicked, this, &HomePage::writing_wanted);
  auto* help = new QPushButton(tr("Hel&p"), panel);
  help->setObjectName("help");
  help->setToolTip(tr("How to use each page, with pictures (F1)"));
  connect(help, &QPushButton::clicked, this, &HomePage::help_wanted);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(16, 14, 16, 14);
  column->setSpacing(10);
  column->addWidget(heading);
  column->addWidget(recent_, 1);
  column->addWidget(no_recent_, 1);
  column->addWidget(write);
  column->addWidget(help);
  set_recent({});
  return panel;
}

void HomePage::set_next(const NextTrial& next) {
  QString about = next.scenario.isEmpty()
                      ? tr("No scenario is chosen yet")
                      : tr("%1\nPatient: %2\nDevice: %3").arg(next.scenario, next.patient, next.device);
  if (!next.hindrance.isEmpty()) about += "\n\n" + next.hindrance;
  practise_->say(tr("Practise"), about);
  practise_->setToolTip(next.hindrance.isEmpty() ? tr("Opens this trial (Enter); it begins with Start, once your hands are in place")
                                                 : tr("Opens the course, where what is missing can be chosen (Enter)"));
}

void HomePage::set_picture(const QImage& picture) { practise_->show_picture(picture, kPictureHeight); }

void HomePage::set_recent(const std::vector<RecentEntry>& recent) {
  recent_->clear();
  for (const RecentEntry& entry : recent) {
    auto* item = new QListWidgetItem(entry.words, recent_);
    item->setData(Qt::UserRole, QString::fromStdString(entry.file.path.string()));
  }
  recent_->setVisible(!recent.empty());
  no_recent_->setVisible(recent.empty());
}

void HomePage::set_message(const QString& message) {
  message_->setText(message);
  message_->setVisible(!message.isEmpty());
}

void HomePage::set_notice(const QString& html) {
  notice_->setText(html);
  notice_->setVisible(!html.isEmpty());
}

void HomePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!event->spontaneous()) practise_->setFocus();
}

}  // namespace vallecula::gui
