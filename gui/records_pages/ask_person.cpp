#include "gui/records_pages/ask_person.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace vallecula::gui {

QLineEdit* person_line(QWidget* parent, bool secret) {
  auto* edit = new QLineEdit(parent);
  edit->setMaxLength(100);
  if (secret) edit->setEchoMode(QLineEdit::Password);
  return edit;
}

AskPerson::AskPerson(QWidget* parent, const QString& title, const QString& say, const QString& take)
    : QDialog(parent) {
  setWindowTitle(title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* heading = new QLabel(title, this);
  heading->setObjectName("heading");
  auto* about = new QLabel(say, this);
  about->setWordWrap(true);
  about->setObjectName("faint");
  form_ = new QFormLayout;
  message_ = new QLabel(this);
  message_->setObjectName("dialog_message");
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  buttons_ = new QHBoxLayout;
  connect(other_button(tr("Cancel")), &QPushButton::clicked, this, &QDialog::reject);
  take_ = new QPushButton(take, this);
  take_->setObjectName("primary");
  take_->setDefault(true);
  buttons_->addStretch(1);
  buttons_->addWidget(take_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(22, 18, 22, 16);
  all->setSpacing(10);
  all->addWidget(heading);
  all->addWidget(about);
  all->addLayout(form_);
  all->addWidget(message_);
  all->addLayout(buttons_);
  setMinimumWidth(460);
}

QLineEdit* AskPerson::line(const QString& label, bool secret) {
  QLineEdit* edit = person_line(this, secret);
  form_->addRow(label, edit);
  return edit;
}

QPushButton* AskPerson::other_button(const QString& text) {
  auto* button = new QPushButton(text, this);
  button->setAutoDefault(false);
  const int stretch = buttons_->count() - 2;  // before it and the last one
  buttons_->insertWidget(std::max(0, stretch), button);
  return button;
}

}  // namespace vallecula::gui
