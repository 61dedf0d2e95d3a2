// For instructors: who is registered here, and the audit trail.
#pragma once

#include <QWidget>
#include <vector>

#include "curricula/records/people.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace vallecula::gui {

class RecordsDesk;

class PeopleTab : public QWidget {
  Q_OBJECT
 public:
  PeopleTab(RecordsDesk& desk, QWidget* parent);
  void refresh();  ///< nothing where no instructor is signed in
  /// Everything kept of the person chosen, into a new folder in `folder`.
  void export_chosen(const QString& folder);

 signals:
  void people_changed();
  void progress_wanted(long long person_id);

 private:
  void show_people(std::vector<curricula::Person> people, const std::vector<curricula::AuditEntry>& audit);
  const curricula::Person* chosen() const;  ///< null: none
  void add();
  void rename();
  void reset_pin();
  void delete_chosen();
  void done(const QString& message);

  RecordsDesk& desk_;
  std::vector<curricula::Person> people_;
  QTableWidget *table_, *audit_;
  std::vector<QPushButton*> for_one_;  ///< need somebody chosen
  QLabel* message_;
};

}  // namespace vallecula::gui
