// What the dialogs about a person are made of: a heading, a sentence, fields, a message, Cancel and what is to be done.
#pragma once

#include <QDialog>

class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace vallecula::gui {

/// One line for a name or, unseen, for a PIN; both as long as the records take them.
QLineEdit* person_line(QWidget* parent, bool secret);

/// Closed by Cancel or Esc it is rejected, and nothing has happened.
class AskPerson : public QDialog {
  Q_OBJECT
 public:
  AskPerson(QWidget* parent, const QString& title, const QString& say, const QString& take);

 protected:
  QLineEdit* line(const QString& label, bool secret);
  /// Beside Cancel; Enter never presses it.
  QPushButton* other_button(const QString& text);

  QFormLayout* form_;
  QLabel* message_;
  QPushButton* take_;

 private:
  QHBoxLayout* buttons_;
};

}  // namespace vallecula::gui
