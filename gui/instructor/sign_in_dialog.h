// Somebody signs in quickly: a name, a PIN, Enter.
#pragma once

#include <functional>
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
  /// Whether whoever is signed in may be signed out now; asked once somebody else is to come, false: nobody is changed.
  using MayChange = std::function<bool()>;
  enum class Whom { anybody, instructors };
  /// `after`: who was signed in; the one after them in the list is chosen first. 0: nobody was.
  SignInDialog(RecordsDesk& desk, Whom whom, const QString& title, const QString& say, long long after, QWidget* parent,
               MayChange may_change = {});

 signals:
  void changes();             ///< somebody else comes, or nobody, and may: whoever was signed in goes now
  void new_trainee_wanted();  ///< accepted with nobody signed in: somebody is to be registered

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void ask_names();
  void tell(const QString& message);  ///< all of it
  void take();
  bool begins_change();  ///< false: it may not be made, and the dialog is gone as by Cancel

  RecordsDesk& desk_;
  const Whom whom_;
  const long long after_;
  const MayChange may_change_;
  std::vector<curricula::Person> people_;
  QComboBox* name_;
  QLineEdit* pin_;
};

}  // namespace vallecula::gui
