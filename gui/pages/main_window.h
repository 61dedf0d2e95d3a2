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
class ResultPage;
class TrialPage;

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
  /// Opens the page where courses are written; `file` (may be empty) is opened in it.
  void write_course(const std::filesystem::path& file = {});
  AuthoringPage& authoring_page() { return *authoring_; }
  TrialPage& trial_page() { return *trial_; }
  StartPage& start_page() { return *start_; }
  ImportWizard& import_wizard() { return *import_; }
  DevicesPage& devices_page() { return *devices_; }
  QString page_name() const;  ///< "start", "devices", "import", "authoring", "prepare", "trial", "result"

 signals:
  void prepared();
  void trial_finished(const vallecula::gui::TrialOutcome& outcome);
  void trial_failed(const QString& message);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void prepare_choice(const Choice& choice);
  /// `patient`: gives the package's folder; runs on the preparing thread.
  void prepare(TrialSetup setup, std::function<std::filesystem::path()> patient, bool start_at_once);
  void report_progress(const std::string& stage, double fraction);
  void show_failure(const QString& message);
  void back_to_start();
  void add_imported_patients();
  void try_scenario(const QString& file, const QString& id);
  void choose_last_device(const QString& name);
  QWidget* make_prepare_page();

  QStackedWidget* pages_;
  StartPage* start_;
  DevicesPage* devices_;
  ImportWizard* import_;
  AuthoringPage* authoring_;
  QWidget* prepare_page_;
  QLabel* prepare_stage_;
  QProgressBar* prepare_bar_;
  TrialPage* trial_;
  ResultPage* result_;
  QPointer<QThread> worker_;
  std::atomic<bool> cancelled_{false};
  curricula::Scenario scenario_;
  std::vector<std::string> misfits_;  ///< of the patient and this scenario
  std::filesystem::path results_;
  std::function<void()> again_;
  bool has_start_ = false;
  bool trying_ = false;  ///< a scenario out of the authoring page, to which the window returns
};

}  // namespace vallecula::gui
