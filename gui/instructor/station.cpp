#include "gui/instructor/station.h"

#include <QEvent>
#include <QMainWindow>

#include "device/factory.h"
#include "gui/instructor/instructor_window.h"
#include "gui/instructor/sign_in_dialog.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/person_words.h"

namespace vallecula::gui {

InstructorStation::InstructorStation(QMainWindow& window, RecordsDesk& trainee, TrialPage& trial)
    : QObject(&window), window_(window), trainee_(trainee), trial_(trial), watch_(trial) {
  open_ = new QAction(tr("&Instructor's window"), this);
  open_->setShortcut(Qt::CTRL | Qt::Key_I);
  open_->setToolTip(tr("Watch the trial, freeze it, change vital signs, tick the checklist (Ctrl+I)"));
  next_ = new QAction(tr("&Next trainee ..."), this);
  next_->setShortcut(Qt::CTRL | Qt::Key_T);
  next_->setToolTip(
      tr("Signs the present trainee out and the next one in; scenario, patient and device stay (Ctrl+T)"));
  window_.addActions({open_, next_});
  window_.installEventFilter(this);
  connect(open_, &QAction::triggered, this, &InstructorStation::open);
  connect(next_, &QAction::triggered, this, &InstructorStation::change_trainee);
  // A trial belongs to whoever began it.
  connect(&trial_, &TrialPage::started, next_, [this] { next_->setEnabled(false); });
  connect(&trial_, &TrialPage::closed, next_, [this] { next_->setEnabled(true); });
  // What was told of it is not the next trainee's; an instructor who signs in may look back at it.
  connect(&trial_, &TrialPage::opened, this, [this] { watched_ = trainee_.person().id; });
  connect(&trainee_, &RecordsDesk::changed, this, [this] {
    const bool another = trainee_.who() && !trainee_.instructor() && trainee_.person().id != watched_;
    if (another && !trial_.running()) watch_.forget();
  });
}

InstructorStation::~InstructorStation() = default;

/// The second window does not outlive the first.
bool InstructorStation::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && event->type() == QEvent::Hide && !event->spontaneous() && second_) second_->close();
  return QObject::eventFilter(watched, event);
}

void InstructorStation::open() {
  if (second_ && second_->isVisible()) {
    if (second_->isActiveWindow()) return void(second_->close());  // by the key that opened it
    second_->raise();
    second_->activateWindow();
    return;
  }
  if (trainee_.instructor()) return show_second(trainee_.who(), trainee_.person());
  trainee_.ask<bool>(
      this, [](curricula::Records& records) { return curricula::People(records).has_instructor(); },
      [this](bool has_instructor) {
        if (!has_instructor) return show_second({}, {});
        if (!second_) second_ = std::make_unique<InstructorWindow>(trial_, watch_, trainee_);
        auto* dialog = new SignInDialog(
            second_->desk(), SignInDialog::Whom::instructors, tr("Instructor's window"),
            tr("An instructor signs in here; whoever is at the blade stays signed in there."), 0, &window_);
        connect(dialog, &QDialog::accepted, this,
                [this] { show_second(second_->desk().who(), second_->desk().person()); });
        dialog->open();
      },
      [this](const QString& message) { emit told(message); });
}

void InstructorStation::show_second(const curricula::Who& who, const curricula::Person& person) {
  if (!second_) second_ = std::make_unique<InstructorWindow>(trial_, watch_, trainee_);
  if (second_->actions().isEmpty()) {
    second_->addActions({open_, next_});
    connect(second_.get(), &InstructorWindow::next_trainee_wanted, next_, &QAction::trigger);
  }
  if (who) second_->desk().sign_in(*who, person);
  second_->show_beside(&window_);
}

/// Asked when the change is made, not before: who cancels has lost nothing, and a trial may have begun meanwhile.
bool InstructorStation::may_change() {
  if (!next_->isEnabled()) {
    emit told(tr("A trial runs: whoever began it stays signed in until it is over."));
    return false;
  }
  return !may_change_ || may_change_();
}

void InstructorStation::change_trainee() {
  window_.activateWindow();  // where it is asked
  const QString before =
      trainee_.who() ? tr("%1 is signed out then.").arg(words_of(trainee_.person())) + " " : QString();
  auto* dialog = new SignInDialog(
      trainee_, SignInDialog::Whom::anybody, tr("Next trainee"),
      before + tr("Scenario, patient and device stay; the mode is practice again. Nobody signs in for somebody else."),
      trainee_.person().id, &window_, [this] { return may_change(); });
  connect(dialog, &SignInDialog::changes, this, [this] {
    trainee_.sign_out();
    emit next_trainee_begins();
    watch_.forget();
  });
  connect(dialog, &SignInDialog::new_trainee_wanted, this, &InstructorStation::new_trainee_wanted);
  dialog->open();
}

void InstructorStation::check_before(QStringList devices, const std::function<void()>& then) {
  while (!devices.isEmpty() && !checks_.due(devices.front())) devices.removeFirst();
  if (devices.isEmpty()) return then();
  const QString first = devices.takeFirst();
  check_device(first, [this, devices, then] { check_before(devices, then); });
}

void InstructorStation::check_device(const QString& name, const std::function<void()>& then) {
  if (trial_.session()) return;  // it has the device
  const DeviceCheck::Maker make = [name, own = maker_, gone = trial_.gone()] {
    if (gone.valid()) gone.wait();  // the trial before may still have it
    if (own) return own();
    const std::string whole = name.toStdString();
    const std::size_t colon = whole.find(':');
    return device::make_device(whole.substr(0, colon), colon == std::string::npos ? "" : whole.substr(colon + 1));
  };
  auto* check = new DeviceCheck(name, make, &window_);
  check->setAttribute(Qt::WA_DeleteOnClose);
  connect(check, &DeviceCheck::checked, this, [this](const CheckResult& result) { checks_.keep(result); });
  if (then) connect(check, &QDialog::finished, this, then);
  check->open();
}

}  // namespace vallecula::gui
