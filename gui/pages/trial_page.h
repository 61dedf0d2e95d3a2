// One trial on the screen: the views, the bars, the figures, and the buttons. The session does the work; this shows it.
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <QThread>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <future>
#include <memory>
#include <vector>

#include "gui/pages/hints.h"
#include "gui/pages/key_list.h"
#include "gui/pages/picture_flow.h"
#include "gui/session/trial_session.h"
#include "gui/views/patient_look.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace vallecula::gui {

class BladeControl;
class ExpertLoop;
class HandPanel;
class HelpPanel;
class MouseIntroduction;
class OperatorView;
class PartsLabel;
class SagittalView;
class SoundButton;
class TrialPanels;

class TrialPage : public QWidget {
  Q_OBJECT
 public:
  explicit TrialPage(QWidget* parent = nullptr);
  ~TrialPage() override;

  /// Shows the patient of a session that was built and not started.
  void open(std::shared_ptr<TrialSession> session, std::shared_ptr<PatientLook> look);
  void start();
  /// Stops and scores off the window's thread; finished() or failed() follows.
  void end(const QString& how);
  void reset();
  /// Likewise, with the blade led to the vallecula first; only practice.
  void begin_at_vallecula();
  /// An expert's hands at this patient, over and over, while the trial waits; until ended, then the hand goes on.
  void show_expert();
  void end_expert();
  bool expert_shown() const { return expert_wanted_; }
  /// Lets the session go without a result (its log stays as interrupted when it was running). Returns at once: disk,
  /// records and device are left on another thread, which the page's destructor waits for.
  void close_trial();
  /// Ready once the session that was let go last has left its device; not valid: there was none. Any thread may wait.
  std::shared_future<void> gone() const { return gone_; }
  /// What is known of the device's check, beside the help; empty: nothing.
  void set_device_note(const QString& note);
  bool running() const { return running_; }
  bool held_by_instructor() const;  ///< a running trial: nobody ends or leaves it at this window
  void refuse_to_end();             ///< says so, until it is let go
  /// The open trial, for whoever looks at it from another window; null: none is open.
  std::shared_ptr<TrialSession> session() const { return session_; }
  /// What it is drawn from: moved once a frame, before frame().
  std::shared_ptr<PatientLook> look() const { return look_; }
  /// An assessment is under way or being scored: it cannot be left without its result.
  bool assessing() const { return assessed() && (running_ || ending_); }

  /// Of the open session. Throws std::logic_error when none is.
  const curricula::Scenario& scenario() const;
  const pipeline::PatientPackage& patient() const;
  OperatorView& operator_view() { return *operator_view_; }
  SagittalView& sagittal_view();
  TrialPanels& panels() { return *panels_; }
  /// What an instructor has the team say: shown for a while among the team's messages, with the sign of its sender.
  void say(const QString& line);
  /// All keys of the page as it is now, from the tables by which they are taken.
  std::vector<KeyGroup> keys() const;
  /// Called after each frame of a running trial with the snapshot that was drawn.
  void set_frame_hook(const std::function<void(const engine::Snapshot&)>& hook);
  /// Frames drawn since start(), a second.
  double frames_per_second() const;

 signals:
  /// A session is open and not started; it runs; a frame of it was drawn (the snapshot that was); it is let go.
  void opened();
  void started();
  void frame(const vallecula::engine::Snapshot& snapshot);
  /// A picture of the expert was drawn instead: the trial waits.
  void waited();
  void closed();
  void finished(const vallecula::gui::TrialOutcome& outcome);
  void failed(const QString& message);
  void left();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void showEvent(QShowEvent* event) override;

 private:
  bool assessed() const;
  void let_go();
  void put_away(std::shared_ptr<TrialSession> session);
  void draw_frame();
  void draw_at_rest();
  void show_buttons();
  /// What ends or leaves the trial, which nobody does at this window while an instructor holds it.
  void show_ways_out();
  void show_help();
  /// The scenario's helps in the operator's view; all are off in an assessment.
  void show_helps();
  /// Gives the mouse, where there is one, to the device it is.
  void steer();
  /// Whose hand the one device drives: on the view, in the help, and where keys and mouse go.
  void show_steered();
  bool takes_key(QKeyEvent* event, bool pressed);
  struct PageKey;
  static const std::vector<PageKey>& page_keys();
  const PageKey* page_key(const QKeyEvent& event) const;
  void enter_pressed();
  void escape_pressed();
  void reset_pressed();
  void change_zoom();
  void change_sound();
  void eye_left();
  void eye_right();
  void eye_up();
  void eye_down();
  void extend_head();
  void keys_pressed();
  void list_keys();
  void end_reading();
  void expert_pressed();
  void vallecula_pressed();
  void show_banner(const Banner& banner);
  QWidget* make_centre();
  QLayout* make_head();
  QWidget* make_foot();
  void begin_anew(bool at_vallecula);
  void hand_to_blade();
  void offer_helps();
  void take_expert(std::shared_ptr<ExpertLoop> loop);
  void draw_expert();
  void show_running(const engine::Snapshot& snapshot);
  void show_words(const engine::Snapshot& snapshot, const QString& pause);
  double run_s() const;
  void picture_came();
  void let_go_of_what_is_seen_again();
  QString waited_words();
  void watch_window();

  std::shared_ptr<TrialSession> session_;
  std::shared_ptr<PatientLook> look_;
  OperatorView* operator_view_;
  TrialPanels* panels_;
  HandPanel* hands_;
  HelpPanel* helps_;
  SoundButton* sound_;
  QToolButton* panels_button_;
  BladeControl* control_;
  MouseIntroduction* introduction_;
  PartsLabel* help_;
  QLabel *title_, *banner_, *steered_, *expert_sign_, *device_note_;
  QPushButton *start_, *end_, *reset_, *leave_, *zoom_;
  QTimer timer_;
  QElapsedTimer since_frame_, since_start_, since_shown_, since_rest_;
  QPointer<QThread> scoring_, leaving_;
  std::shared_future<void> gone_;
  QMetaObject::Connection frame_hook_;
  std::shared_ptr<ExpertLoop> expert_;  ///< of this trial's patient, once it was asked for
  QElapsedTimer since_expert_;
  bool expert_wanted_ = false, expert_coming_ = false;
  Tool shown_in_hand_ = Tool::blade;
  bool running_ = false, ending_ = false;
  bool end_refused_ = false;  ///< somebody wanted to end it while an instructor holds it
  int frames_ = 0;
  PictureFlow flow_;
  double seen_again_s_ = -1.0;  ///< until when the trial waited for its picture; < 0: it has not, or it was told
  QString levers_;              ///< what is said of a blade that levers
  double levers_until_s_ = -1.0;
  bool put_away_ = false;  ///< the window was, in the last gap
};

}  // namespace vallecula::gui
