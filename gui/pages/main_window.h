// The trainer's window: choose, prepare, try, look at what came of it.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QPointer>
#include <QThread>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "gui/pages/start_page.h"
#include "gui/session/dropped_files.h"
#include "gui/session/trial_session.h"

class QLabel;
class QProgressBar;
class QStackedWidget;

namespace vallecula::gui {

class AuthoringPage;
class DevicesPage;
class HelpDialog;
class HomePage;
class KeptDraft;
struct FoundAtStart;
class MainMenu;
class ImportWizard;
class InstructorStation;
class ReadyPatient;
class RecordsPage;
class ReplayPage;
class ResultPage;
class SelfRatingPage;
struct SelfRating;
class TrialPage;
class WhoStrip;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Home, with curricula to choose from; what was chosen last time is chosen again.
  void show_start(std::vector<curricula::Curriculum> curricula);
  /// Prepares this trial (on a thread of its own) and opens it; `start_at_once` for a scripted hand.
  void prepare(const TrialSetup& setup, bool start_at_once);
  /// Opens the import of a CT; `source` (may be empty) is looked at at once.
  void import_series(const QString& source = {});
  /// Opens a trial's log (its folder or file) to be looked at, at a second; negative: from its beginning. `patient`:
  /// where its package is now, if it was moved. `before_s`: it begins so long before that second, to see it coming.
  void replay(const std::filesystem::path& trial, double at_s = -1.0, const std::filesystem::path& patient = {},
              double before_s = 0.0);
  ReplayPage& replay_page() { return *replay_; }
  /// Opens the page where courses are written; `file` (may be empty) is opened in it.
  void write_course(const std::filesystem::path& file = {});
  AuthoringPage& authoring_page() { return *authoring_; }
  TrialPage& trial_page() { return *trial_; }
  /// Opens whatever it is: a CT, a patient, a course, a trial. What cannot be opened is told in one message.
  void open_files(const std::vector<std::filesystem::path>& paths);
  /// On the very first start: with what one steers, how the window looks, the first laryngoscopy.
  void welcome();
  /// `very_first`: nobody has worked in this window, so another language is followed at once.
  void show_first_steps(bool very_first);
  /// Tells of what an earlier program that ended too early left: trials, a course that was being written.
  void look_back();
  bool looking_back() const { return looking_back_; }  ///< until looked_back()
  /// Nothing would be lost with it: nobody is signed in, nothing is under way or unsaved, no instructor's window is
  /// open.
  bool may_be_made_anew() const;
  /// This window takes the other's place: as large, maximised where it is, with what it has told of.
  void take_over(MainWindow& before);
  /// Writes what the program did, and on what, into one text file; it names nobody.
  void save_log(const std::filesystem::path& to);
  KeptDraft& draft() { return *draft_; }
  HomePage& home_page() { return *home_; }
  ReadyPatient& ready_patient() { return *ready_; }
  MainMenu& menu() { return *menu_; }
  StartPage& start_page() { return *start_; }
  ImportWizard& import_wizard() { return *import_; }
  DevicesPage& devices_page() { return *devices_; }
  RecordsPage& records_page() { return *records_; }
  InstructorStation& station() { return *station_; }
  /// "home", "start", "records", "devices", "import", "authoring", "prepare", "trial", "rating", "result", "replay"
  QString page_name() const;

 signals:
  /// Another language is installed: what is open keeps its words until it is made anew. `first_steps`: from there it
  /// was chosen, and there it goes on.
  void words_changed(bool first_steps);
  void looked_back();
  void prepared();
  void trial_finished(const vallecula::gui::TrialOutcome& outcome);
  void trial_failed(const QString& message);
  void replay_opened();
  void replay_failed(const QString& message);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void connect_home();
  void connect_menu();
  void connect_help();
  void show_help();
  /// Puts on the language that was chosen in the settings, at once where nothing would be lost with this window.
  void follow_language();
  void follow(const QString& link);
  void show_found();
  void restore_place();
  void keep_place();
  void show_page(QWidget* page);
  void page_changed();
  /// Begins the next trial by one click; where something is missing, the course is shown.
  void practise();
  void fit_scenario(const QString& package);  ///< to the size of a patient that was just chosen
  /// What the first page says of patient and recent files is asked of the disk on a thread of its own.
  void look_around();
  void remember(const std::filesystem::path& path);
  void open_course(const std::filesystem::path& file);
  void open_found(const Dropped& found);
  bool may_put_aside();   ///< asks what still waits for an answer: an unsaved course, an assessment's own rating
  bool may_open() const;  ///< nothing is under way that would be lost
  void tell(const QString& message);        ///< on the page that is seen, or before it
  bool told_of_fit_ = false;                ///< what stands on the page one goes back to is fit_scenario()'s
  void tell_first(const QString& message);  ///< on the page one goes back to; empty: nothing is wrong any more
  /// `seed`: of an attempt to be repeated; 0: a new one is drawn.
  void prepare_choice(const Choice& choice, std::uint32_t seed = 0);
  /// Once the devices of the choice were checked in this session, or their check was closed.
  void prepare_checked(const Choice& choice, std::uint32_t seed);
  void connect_station();
  /// `patient`: gives the package's folder; runs on the preparing thread.
  void prepare(TrialSetup setup, std::function<std::filesystem::path()> patient, bool start_at_once);
  void report_progress(const std::string& stage, double fraction);
  /// A trial or a replay is being prepared: that is given up, and once it has ended (it has the device) `next` begins.
  void instead_of_work(std::function<void()> next);
  void give_up_work();
  /// To be called first when it ended, nothing of it being left when it was given up. False: it was, and what was
  /// wanted instead has begun, or `leave` was called where its page is still seen.
  bool work_ended(const std::function<void()>& leave);
  /// The next trial's patient is read and made ready, its scene with it, while one looks at the first page.
  void make_ready();
  /// Where something else is made ready than this is, that is left: nobody waits for it.
  void leave_unwanted(const Choice& wanted);
  void show_result();
  void take_self_rating(const SelfRating& rating);
  /// What is open and mastered for whoever is signed in.
  void read_past();
  void show_failure(const QString& message);
  void back_to_start();
  /// In the replay, or where that stays locked as its report.
  void show_trial(const QString& log, bool with_replay);
  void leave_replay();
  /// Those of the user's data folder, and the one that was chosen last: looked for on a thread of its own.
  void add_imported_patients(const std::filesystem::path& last);
  void try_scenario(const QString& file, const QString& id);
  void choose_last_device(const QString& name);
  QWidget* make_prepare_page();

  QStackedWidget* pages_;
  HomePage* home_;
  MainMenu* menu_;
  KeptDraft* draft_;
  HelpDialog* help_ = nullptr;
  std::shared_ptr<FoundAtStart> found_;  ///< what is told of an earlier program; null: nothing
  bool looking_back_ = false;
  QElapsedTimer prepare_time_, trial_time_;
  TrialSetup prepared_;  ///< of the trial that is prepared or runs
  StartPage* start_;
  DevicesPage* devices_;
  RecordsPage* records_;
  WhoStrip* who_;
  ImportWizard* import_;
  AuthoringPage* authoring_;
  QWidget* prepare_page_;
  QLabel* prepare_stage_;
  QProgressBar* prepare_bar_;
  TrialPage* trial_;
  SelfRatingPage* rating_;
  ResultPage* result_;
  ReplayPage* replay_;
  InstructorStation* station_;
  QPointer<QThread> worker_, looker_, readier_;
  bool look_again_ = false, working_ = false, patients_known_ = false;
  std::function<void()> next_work_;
  std::string failure_;  ///< kind of what ended the work that was prepared; empty: it failed later, on its page
  std::unique_ptr<ReadyPatient> ready_;
  std::filesystem::path ready_package_;   ///< to be made ready; empty: there is none yet
  std::optional<Choice> ready_wanted_;    ///< for it; none: no scenario is chosen
  std::string ready_asked_;               ///< what is made ready, or was last
  std::filesystem::path ready_asked_of_;  ///< the patient that was chosen for it; empty: the scenario's own
  std::atomic<bool> ready_left_{false}, ready_patient_left_{false};  ///< something else is wanted; of another patient
  int courses_asked_ = 0;
  QWidget* first_;                                     ///< home or the course: where one goes back to
  std::vector<curricula::Curriculum> opened_courses_;  ///< from elsewhere than the folders of courses
  std::atomic<bool> cancelled_{false};
  curricula::Scenario scenario_;
  std::vector<std::string> misfits_;  ///< of the patient and this scenario
  std::filesystem::path results_;
  QWidget* replay_from_ = nullptr;  ///< the page to go back to; null: the first
  TrialOutcome outcome_;
  std::function<void()> again_, same_again_;
  bool has_start_ = false;
  bool trying_ = false;  ///< a scenario out of the authoring page, to which the window returns
};

}  // namespace vallecula::gui
