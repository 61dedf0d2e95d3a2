#include "gui/records_pages/person_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace vallecula::gui {

PersonDialog::PersonDialog(QWidget* parent, const QString& title, const QString& say, int fields)
    : AskPerson(parent, title, say, title) {
  if ((fields & kName) != 0) name_ = line(tr("&Name or pseudonym"), false);
  if ((fields & kRole) != 0) {
    role_ = new QComboBox(this);
    role_->addItems({tr("Trainee"), tr("Instructor")});
    form_->addRow(tr("&Role"), role_);
  }
  if ((fields & kOldPin) != 0) old_pin_ = line(tr("&Old PIN"), true);
  if ((fields & kNewPin) != 0) {
    new_pin_ = line((fields & kOldPin) != 0 ? tr("New &PIN") : tr("&PIN"), true);
    new_pin_->setPlaceholderText(tr("4 to 64 characters"));
    again_ = line(tr("PIN &again"), true);
  }
  connect(take_, &QPushButton::clicked, this, &PersonDialog::take);
}

void PersonDialog::take() {
  const bool named = name_ == nullptr || !name_->text().trimmed().isEmpty();
  if (!named) {
    refuse(tr("Give a name or a pseudonym."));
  } else if (new_pin_ != nullptr && new_pin_->text().size() < 4) {
    refuse(tr("A PIN has at least 4 characters."));
  } else if (new_pin_ != nullptr && new_pin_->text() != again_->text()) {
    refuse(tr("The two PINs are not the same."));
  } else {
    message_->clear();
    take_->setEnabled(false);
    emit given();
  }
}

void PersonDialog::refuse(const QString& message) {
  message_->setText(message);
  take_->setEnabled(true);
}

void PersonDialog::set_name(const QString& name) { name_->setText(name); }
std::string PersonDialog::name() const { return name_->text().toStdString(); }
bool PersonDialog::wants_instructor() const { return role_->currentIndex() == 1; }
std::string PersonDialog::old_pin() const { return old_pin_->text().toStdString(); }
std::string PersonDialog::new_pin() const { return new_pin_->text().toStdString(); }

}  // namespace vallecula::gui
