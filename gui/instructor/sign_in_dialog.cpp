#include "gui/instructor/sign_in_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "gui/records_pages/person_words.h"
#include "gui/records_pages/pin_try.h"

namespace vallecula::gui {

using curricula::Person;

SignInDialog::SignInDialog(RecordsDesk& desk, Whom whom, const QString& title, const QString& say, long long after,
                           QWidget* parent, MayChange may_change)
    : AskPerson(parent, title, say, tr("Sign in")),
      desk_(desk),
      whom_(whom),
      after_(after),
      may_change_(std::move(may_change)) {
  name_ = new QComboBox(this);
  name_->setAccessibleName(tr("Name"));
  name_->setToolTip(tr("Up and Down change it from the PIN's field too"));
  form_->addRow(tr("&Name"), name_);
  pin_ = line(tr("&PIN"), true);
  pin_->setAccessibleName(tr("PIN"));
  pin_->installEventFilter(this);
  take_->setEnabled(false);
  if (whom == Whom::anybody) {
    QPushButton* nobody = other_button(tr("Go on as nob&ody"));
    nobody->setToolTip(tr("Trials then belong to nobody"));
    connect(nobody, &QPushButton::clicked, this, [this] {
      if (begins_change()) accept();
    });
    QPushButton* somebody = other_button(tr("Somebody ne&w ..."));
    somebody->setToolTip(tr("Registers a trainee, who is signed in then"));
    connect(somebody, &QPushButton::clicked, this, [this] {
      if (!begins_change()) return;
      accept();
      emit new_trainee_wanted();
    });
  }
  connect(take_, &QPushButton::clicked, this, &SignInDialog::take);
  pin_->setFocus();
  ask_names();
}

void SignInDialog::tell(const QString& message) {
  message_->setText(message);
  const int high = layout()->totalHeightForWidth(width());
  if (isVisible() && high > height()) resize(width(), high);  // it came up with a shorter one
}

void SignInDialog::ask_names() {
  tell(tr("Asking the records ..."));
  desk_.ask<std::vector<Person>>(
      this, [](curricula::Records& records) { return curricula::People(records).list(); },
      [this](std::vector<Person> people) {
        const auto unwanted = [this](const Person& person) {
          return whom_ == Whom::instructors && person.role != curricula::Role::instructor;
        };
        people.erase(std::remove_if(people.begin(), people.end(), unwanted), people.end());
        people_ = std::move(people);
        int next = 0, trainee = -1;
        for (std::size_t i = 0; i < people_.size(); ++i) {
          name_->addItem(words_of(people_[i]));
          if (people_[i].role == curricula::Role::trainee && trainee < 0) trainee = static_cast<int>(i);
          if (people_[i].id == after_) next = static_cast<int>(i + 1);
        }
        // After the last one, and after nobody, the first of the trainees.
        if (next == 0 || next >= static_cast<int>(people_.size())) next = std::max(0, trainee);
        name_->setCurrentIndex(people_.empty() ? -1 : next);
        tell(!people_.empty() ? QString()
             : whom_ == Whom::instructors
                 ? tr("No instructor is registered here yet: Records in the first window sets up the "
                      "first one.")
                 : tr("Nobody is registered here yet."));
        take_->setEnabled(!people_.empty());
      },
      [this](const QString& message) { tell(message); });
}

bool SignInDialog::eventFilter(QObject* watched, QEvent* event) {
  if (watched == pin_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
      name_->setCurrentIndex(
          std::clamp(name_->currentIndex() + (key == Qt::Key_Down ? 1 : -1), 0, std::max(0, name_->count() - 1)));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

bool SignInDialog::begins_change() {
  if (may_change_ && !may_change_()) {
    reject();
    return false;
  }
  emit changes();
  return true;
}

void SignInDialog::take() {
  const auto chosen = static_cast<std::size_t>(name_->currentIndex());
  if (chosen >= people_.size()) return;
  const Person person = people_[chosen];
  take_->setEnabled(false);
  tell(tr("Looking at the PIN ..."));
  desk_.ask<PinTry>(
      this,
      [id = person.id, pin = pin_->text().toStdString()](curricula::Records& records) {
        return try_pin(records, id, pin);
      },
      [this, person](PinTry answer) {
        take_->setEnabled(true);
        pin_->clear();
        pin_->setFocus();
        if (answer.who) {
          if (!begins_change()) return;
          desk_.sign_in(*answer.who, person);
          accept();
        } else if (answer.wait_s > 0.0) {
          tell(tr("Too many wrong PINs: wait %1 s, or ask an instructor for a new PIN.")
                   .arg(static_cast<int>(std::ceil(answer.wait_s))));
        } else {
          tell(answer.refused);
        }
      },
      [this](const QString& message) {
        take_->setEnabled(true);
        tell(message);
      });
  pin_->clear();
}

}  // namespace vallecula::gui
