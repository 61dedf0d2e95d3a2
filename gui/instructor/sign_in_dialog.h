// Somebody signs in quickly: a name, a PIN, Enter.
#pragma once

#include <vector>

#include "gui/records_pages/ask_person.h"
#include "gui/records_pages/records_desk.h"

class QComboBox;

namespace vallecula::gui {

/// Signs in at `desk` and is accepted; cancelled, whoever was signed in stays so. Up and Down in the PIN's field change
/// the name, so that the hands stay there.
class SignInDialog : public AskPerson {
  Q_OBJECT
 public:
  enum class Whom { anybody, instructors };
  /// `after`: who was signed in; the one after them in the list is chosen first. 0: nobody was.
  SignInDialog(RecordsDesk& desk, Whom whom, const QString& title, const QString& say, long long after,
               QWidget* parent);

 signals:
  void changes();             ///< the PIN is right, or nobody wants to sign in: whoever was signed in goes now
  void new_trainee_wanted();  ///< accepted with nobody signed in: somebody is to be registered

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
};

}  // namespace vallecula::gui
