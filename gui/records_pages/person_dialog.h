// Asks for a name, a PIN, or both: registering, renaming, changing a PIN.
#pragma once

#include <string>

#include "gui/records_pages/ask_person.h"

class QComboBox;

namespace vallecula::gui {

class PersonDialog : public AskPerson {
  Q_OBJECT
 public:
  enum Field { kName = 1, kRole = 2, kOldPin = 4, kNewPin = 8 };
  /// `fields`: which of them are asked for; `say` stands above them.
  PersonDialog(QWidget* parent, const QString& title, const QString& say, int fields);

  void set_name(const QString& name);
  std::string name() const;
  bool wants_instructor() const;
  std::string old_pin() const;
  std::string new_pin() const;

  /// Said below the fields, which can be tried again: what was typed is refused elsewhere only.
  void refuse(const QString& message);

 signals:
  void given();  ///< all is filled in, both PINs are the same; closed by whoever takes it

 private:
  void take();

  QLineEdit* name_ = nullptr;
  QComboBox* role_ = nullptr;
  QLineEdit *old_pin_ = nullptr, *new_pin_ = nullptr, *again_ = nullptr;
};

}  // namespace vallecula::gui
