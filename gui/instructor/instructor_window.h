// The instructor's second window: what the trainee does, live, and what the instructor may do to it.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>

#include "gui/instructor/live_watch.h"
#include "gui/records_pages/records_desk.h"
#include "gui/session/trial_session.h"

class QLabel;
class QListWidget;
class QPushButton;
class QTabWidget;

namespace vallecula::gui {

class ForceBars;
class InstructorControls;
class MonitorPanel;
class OperatorView;
class RunChecklist;
class TrialPage;
class TrialReadings;

/// Shares no state of the simulation: it takes the trial page's snapshots, and asks by HandActions and the session's
/// freeze(). Who sits here signs in here (desk()); the trainee's own sign-in is the other window's.
class InstructorWindow : public QWidget {
  Q_OBJECT
 public:
  /// `watch`: of the trial page, from before this was opened. `trainee`: who is signed in at the trial page's window.
  /// All must outlive this.
  InstructorWindow(TrialPage& trial, LiveWatch& watch, RecordsDesk& trainee);
  RecordsDesk& desk() { return desk_; }
  /// On the second screen, whole, where there is one.
  void show_beside(QWidget* first);
  /// Pictures drawn of the trial that is open.
  int drawn() const { return drawn_; }

 signals:
  void next_trainee_wanted();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* make_left();
  void add_keys();
  QWidget* make_right();
  void sign_in();
  void take_session();
  void let_go();
  void frame(const engine::Snapshot& snapshot);
  void wait();
  /// Of the trial that is open what was before this window was: its events, peaks, clock and the monitor's minute.
  void catch_up();
  void begin_anew();
  bool shows_figures() const;
  void show_state();
  void add_events(const std::vector<LiveEvent>& events);
  void freeze(bool on);
  void drive(std::uint32_t action, bool down);
  void say(const QString& line);
  void recorded(const TrialOutcome& outcome);
  void keep_ratings_given();

  TrialPage& trial_;
  LiveWatch& live_;
  RecordsDesk& trainee_;
  RecordsDesk desk_;
  std::shared_ptr<TrialSession> session_;
  OperatorView* view_;
  MonitorPanel* monitor_;
  ForceBars* bars_;
  TrialReadings* readings_;
  InstructorControls* controls_;
  RunChecklist* checklist_;
  QListWidget* events_;
  QTabWidget* tabs_;
  QLabel *title_, *who_, *state_;
  QPushButton *next_, *sign_in_;
  QWidget* forces_;
  QElapsedTimer since_drawn_;
  int drawn_ = 0;
  long long record_ = 0;      ///< of the trial that was recorded last; 0: none
  std::uint32_t driven_ = 0;  ///< vital signs held now
};

}  // namespace vallecula::gui
