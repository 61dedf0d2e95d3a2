// Signing in and out, registering, and what one may do with one's own data.
#pragma once

#include <QDeadlineTimer>
#include <QTimer>
#include <QWidget>
#include <map>
#include <vector>

#include "curricula/records/people.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace vallecula::gui {

class PersonDialog;
class RecordsDesk;

class AccountTab : public QWidget {
  Q_OBJECT
 public:
  AccountTab(RecordsDesk& desk, QWidget* parent);
  void refresh();  ///< the names to choose from
  void register_somebody(bool first_instructor);
  /// Everything kept of whoever is signed in, into a new folder in `folder`.
  void export_own(const QString& folder);

 signals:
  void people_changed();

 private:
  QWidget* make_sign_in();
  QWidget* make_account();
  void show_who();
  void show_wait();
  void sign_in();
  void sign_in_as(long long id, const std::string& pin);
  void change_pin();
  void delete_own();
  long long chosen() const;

  RecordsDesk& desk_;
  std::vector<curricula::Person> people_;
  std::map<long long, QDeadlineTimer> waits_;  ///< whose PIN is not looked at until then
  QTimer clock_;
  QStackedWidget* halves_;
  QComboBox* name_;
  QLineEdit* pin_;
  QPushButton *sign_in_button_, *first_instructor_;
  QLabel *message_, *who_, *done_;
};

}  // namespace vallecula::gui
