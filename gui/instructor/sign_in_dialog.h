// Somebody signs in quickly: a name, a PIN, Enter.
#pragma once

#include <QDialog>
#include <vector>

#include "gui/records_pages/records_desk.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace vallecula::gui {

/// Signs in at `desk` and is accepted, or is closed with nobody signed in. Up and Down in the PIN's field change the
/// name, so that the hands stay there.
class SignInDialog : public QDialog {
  Q_OBJECT
 public:
  enum class Whom { anybody, instructors };
  /// `after`: who was signed in; the one after them in the list is chosen first. 0: nobody was.
  SignInDialog(RecordsDesk& desk, Whom whom, const QString& title, const QString& say, long long after,
               QWidget* parent);

 signals:
  void records_wanted();  ///< somebody new: the records' page registers

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void ask_names();
  void take();

  RecordsDesk& desk_;
  const Whom whom_;
  const long long after_;
  std::vector<curricula::Person> people_;
  QComboBox* name_;
  QLineEdit* pin_;
  QLabel* message_;
  QPushButton* take_;
};

}  // namespace vallecula::gui
