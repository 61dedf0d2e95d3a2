#include "gui/records_pages/person_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace vallecula::gui {

PersonDialog::PersonDialog(QWidget* parent, const QString& title, const QString& say, int fields) : QDialog(parent) {
  setWindowTitle(title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* heading = new QLabel(title, this);
  heading->setObjectName("heading");
  auto* about = new QLabel(say, this);
  about->setWordWrap(true);
  about->setObjectName("faint");
  auto* form = new QFormLayout;
  if ((fields & kName) != 0) name_ = line(form, tr("&Name or pseudonym"), false);
  if ((fields & kRole) != 0) {
    role_ = new QComboBox(this);
    role_->addItems({tr("Trainee"), tr("Instructor")});
    form->addRow(tr("&Role"), role_);
  }
  if ((fields & kOldPin) != 0) old_pin_ = line(form, tr("&Old PIN"), true);
  if ((fields & kNewPin) != 0) {
    new_pin_ = line(form, (fields & kOldPin) != 0 ? tr("New &PIN") : tr("&PIN"), true);
    new_pin_->setPlaceholderText(tr("4 to 64 characters"));
    again_ = line(form, tr("PIN &again"), true);
  }
  message_ = new QLabel(this);
  message_->setObjectName("dialog_message");
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setAutoDefault(false);
  take_ = new QPushButton(title, this);
  take_->setObjectName("primary");
  take_->setDefault(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(cancel);
  buttons->addStretch(1);
  buttons->addWidget(take_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(22, 18, 22, 16);
  all->setSpacing(10);
  all->addWidget(heading);
  all->addWidget(about);
  all->addLayout(form);
  all->addWidget(message_);
  all->addLayout(buttons);
  setMinimumWidth(440);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(take_, &QPushButton::clicked, this, &PersonDialog::take);
}

QLineEdit* PersonDialog::line(QFormLayout* form, const QString& label, bool secret) {
  auto* edit = new QLineEdit(this);
  edit->setMaxLength(100);
  if (secret) edit->setEchoMode(QLineEdit::Password);
  form->addRow(label, edit);
  return edit;
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
