// Records: who sits here, what was learned, and for instructors who learns.
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

#include "gui/records_pages/known_courses.h"
#include "gui/records_pages/records_desk.h"

class QAction;
class QLabel;
class QPushButton;
class QTabWidget;

namespace vallecula::gui {

class AccountTab;
class CohortTab;
class PeopleTab;
class ProgressTab;
class StatementsLine;

class RecordsPage : public QWidget {
  Q_OBJECT
 public:
  explicit RecordsPage(QWidget* parent = nullptr);
  void set_curricula(std::vector<curricula::Curriculum> curricula) { courses_.set(std::move(curricula)); }
  RecordsDesk& desk() { return desk_; }
  /// What became of the statements for the learning record store; one line, below all tabs.
  void tell_of_statements(const QString& line);
  void register_trainee();            ///< asks for a name and a PIN; whoever gives them is signed in
  void tell(const QString& message);  ///< what went wrong with something that was opened from here

 signals:
  void left();
  void trial_wanted(const QString& log, bool with_replay);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void show_tabs();
  void take_back();
  void refresh();  ///< of the tab that is seen
  void show_trouble(const QString& message);

  KnownCourses courses_;
  RecordsDesk desk_;
  QTabWidget* tabs_;
  AccountTab* account_;
  ProgressTab* progress_;
  CohortTab* cohort_;
  PeopleTab* people_;
  QPointer<QWidget> left_at_;  ///< what had the keys when a trial was opened from here; null: none was
  QLabel *who_, *waiting_, *trouble_;
  QPushButton* again_;
  StatementsLine* statements_;
};

/// Over the first page: who is signed in, and the way to the records.
class WhoStrip : public QWidget {
  Q_OBJECT
 public:
  WhoStrip(RecordsDesk& desk, QWidget* parent);
  /// A button for it, before the way to the records.
  void offer(QAction* action);

 signals:
  void records_wanted();

 private:
  void show_who();
  RecordsDesk& desk_;
  QLabel* who_;
  QPushButton* out_;
};

}  // namespace vallecula::gui
