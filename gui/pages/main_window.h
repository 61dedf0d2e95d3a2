// The trainer's window: choose, prepare, try, look at what came of it.
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <QThread>
#include <atomic>
#include <functional>
#include <memory>

#include "gui/pages/start_page.h"
#include "gui/session/trial_session.h"

class QLabel;
class QProgressBar;
class QStackedWidget;

namespace vallecula::gui {

class AuthoringPage;
class DevicesPage;
class ImportWizard;
class InstructorStation;
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

  /// First page, with curricula to choose from; what was chosen last time is chosen again.
  void show_start(std::vector<curricula::Curriculum> curricula);
  /// Prepares this trial (on a thread of its own) and opens it; `start_at_once` for a scripted hand.
  void prepare(const TrialSetup& setup, bool start_at_once);
  /// Opens the import of a CT; `source` (may be empty) is looked at at once.
  void import_series(const QString& source = {});
  /// Opens a trial's log (its folder or file) to be looked at, at a second; negative: from its beginning. `patient`:
  /// where its package is now, if it was moved.
  void replay(const std::filesystem::path& trial, double at_s = -1.0, const std::filesystem::path& patient = {});
  ReplayPage& replay_page() { return *replay_; }
  /// Opens the page where courses are written; `file` (may be empty) is opened in it.
  void write_course(const std::filesystem::path& file = {});
  AuthoringPage& authoring_page() { return *authoring_; }
  TrialPage& trial_page() { return *trial_; }
  StartPage& start_page() { return *start_; }
  ImportWizard& import_wizard() { return *import_; }
  DevicesPage& devices_page() { return *devices_; }
  RecordsPage& records_page() { return *records_; }
  InstructorStation& station() { return *station_; }
  /// "start", "records", "devices", "import", "authoring", "prepare", "trial", "rating", "result", "replay"
  QString page_name() const;

 signals:
  void prepared();
  void trial_finished(const vallecula::gui::TrialOutcome& outcome);
  void trial_failed(const QString& message);
  void replay_opened();
  void replay_failed(const QString& message);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  /// `seed`: of an attempt to be repeated; 0: a new one is drawn.
  void prepare_choice(const Choice& choice, std::uint32_t seed = 0);
  /// Once the devices of the choice were checked in this session, or their check was closed.
  void prepare_checked(const Choice& choice, std::uint32_t seed);
  void connect_station();
  /// `patient`: gives the package's folder; runs on the preparing thread.
  void prepare(TrialSetup setup, std::function<std::filesystem::path()> patient, bool start_at_once);
  void report_progress(const std::string& stage, double fraction);
  void show_result();
  void take_self_rating(const SelfRating& rating);
  /// What is open and mastered for whoever is signed in.
  void read_past();
  void show_failure(const QString& message);
  void back_to_start();
  /// In the replay, or where that stays locked as its report.
  void show_trial(const QString& log, bool with_replay);
  void leave_replay();
  void add_imported_patients();
  void try_scenario(const QString& file, const QString& id);
  void choose_last_device(const QString& name);
  QWidget* make_prepare_page();

  QStackedWidget* pages_;
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
  QPointer<QThread> worker_;
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
