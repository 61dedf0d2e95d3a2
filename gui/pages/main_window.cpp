#include "gui/pages/main_window.h"

#include <QCloseEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "curricula/records/progress.h"
#include "device/factory.h"
#include "gui/authoring/authoring_page.h"
#include "gui/authoring/kept_draft.h"
#include "gui/import/import_wizard.h"
#include "gui/instructor/station.h"
#include "gui/pages/background.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/home_page.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/open_outside.h"
#include "gui/pages/ready_patient.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_page.h"
#include "gui/pages/self_rating_page.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/curricula_files.h"
#include "gui/session/device_choice.h"
#include "gui/session/past_results.h"
#include "gui/session/patient_fit.h"
#include "gui/session/statement_delivery.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"

namespace vallecula::gui {

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), ready_(std::make_unique<ReadyPatient>()) {
  setWindowTitle("Vallecula");
  pages_ = new QStackedWidget(this);
  home_ = new HomePage(pages_);
  start_ = new StartPage(pages_);
  first_ = home_;
  devices_ = new DevicesPage(pages_);
  records_ = new RecordsPage(pages_);
  import_ = new ImportWizard(pages_);
  authoring_ = new AuthoringPage(pages_);
  prepare_page_ = make_prepare_page();
  trial_ = new TrialPage(pages_);
  rating_ = new SelfRatingPage(pages_);
  result_ = new ResultPage(pages_);
  replay_ = new ReplayPage(pages_);
  for (QWidget* page : {static_cast<QWidget*>(home_), static_cast<QWidget*>(start_), static_cast<QWidget*>(devices_),
                        static_cast<QWidget*>(records_), static_cast<QWidget*>(import_),
                        static_cast<QWidget*>(authoring_), prepare_page_, static_cast<QWidget*>(trial_),
                        static_cast<QWidget*>(rating_), static_cast<QWidget*>(result_), static_cast<QWidget*>(replay_)})
    pages_->addWidget(page);
  who_ = new WhoStrip(records_->desk(), this);
  menu_ = new MainMenu(*this);
  connect(pages_, &QStackedWidget::currentChanged, this, &MainWindow::page_changed);
  page_changed();
  connect_home();
  connect_menu();
  connect_help();
  setAcceptDrops(true);
  auto* whole = new QWidget(this);
  auto* column = new QVBoxLayout(whole);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(who_);
  column->addWidget(pages_, 1);
  setCentralWidget(whole);
  resize(1280, 800);
  connect(start_, &StartPage::chosen, this, [this](const Choice& choice) { prepare_choice(choice); });
  connect(start_, &StartPage::import_wanted, this, [this] { import_series(); });
  connect(start_, &StartPage::devices_wanted, this, [this] { pages_->setCurrentWidget(devices_); });
  connect(who_, &WhoStrip::records_wanted, this, [this] { pages_->setCurrentWidget(records_); });
  connect(records_, &RecordsPage::left, this, &MainWindow::back_to_start);
  connect(records_, &RecordsPage::trial_wanted, this, &MainWindow::show_trial);
  connect(&records_->desk(), &RecordsDesk::changed, this, [this] {
    start_->forget_mode();
    // Of the one before nothing is seen while the records are asked.
    start_->set_past({}, records_->desk().instructor());
    read_past();
  });
  connect(start_, &StartPage::courses_wanted, this, [this] { write_course(); });
  connect(authoring_, &AuthoringPage::left, this, &MainWindow::back_to_start);
  connect(authoring_, &AuthoringPage::try_wanted, this, &MainWindow::try_scenario);
  connect(authoring_, &AuthoringPage::courses_changed, this, [this] {
    if (!has_start_) return;
    run_in_background<FoundCurricula>(
        this, find_curricula,
        [this, asked = ++courses_asked_](FoundCurricula found) {
          if (asked != courses_asked_) return;  // one that was asked for later knows more
          std::vector<curricula::Curriculum>& all = found.curricula;
          all.insert(all.end(), opened_courses_.begin(), opened_courses_.end());
          start_->set_curricula(std::move(all));
        },
        [this](const QString& message) { authoring_->set_message(message); });
  });
  connect(devices_, &DevicesPage::left, this, &MainWindow::back_to_start);
  connect(devices_, &DevicesPage::found, start_, &StartPage::set_found_devices);
  connect(devices_, &DevicesPage::chosen, this, [this](const device::FoundDevice& device) {
    start_->choose_device(QString::fromStdString(device.name), device_label(device));
    user_settings()->setValue("device", QString::fromStdString(device.name));
    back_to_start();
  });
  connect(import_, &ImportWizard::left, this, &MainWindow::back_to_start);
  connect(import_, &ImportWizard::saved, this, [this](const QString& package) {
    start_->add_patient(package.toStdString(), true);
    remember(package.toStdString());
  });
  connect(import_, &ImportWizard::left_with, this, [this](const QString& package) {
    start_->take_patient(package.toStdString());
    back_to_start();
  });
  connect(import_, &ImportWizard::finished, this, [this](const QString& package) {
    if (has_start_) first_ = start_;  // there stands which scenario was chosen for its size
    start_->take_patient(package.toStdString());
    back_to_start();
    start_->offer_start();
  });
  connect(trial_, &TrialPage::left, this, [this] {
    trial_->close_trial();
    back_to_start();
  });
  connect(trial_, &TrialPage::finished, this, [this](const TrialOutcome& outcome) {
    outcome_ = outcome;
    // Whose trial it is, nobody else needs to see on the first page.
    if (has_start_ && !trying_ && !records_->desk().who()) remember(outcome.log.parent_path());
    if (curricula::rules_of(scenario_.attempt.mode).self_rating_before && outcome.by_person) {
      rating_->ask(scenario_);
      pages_->setCurrentWidget(rating_);
    } else {
      show_result();
    }
    emit trial_finished(outcome);
  });
  connect(trial_, &TrialPage::failed, this, &MainWindow::show_failure);
  auto* delivery = new StatementDelivery(this);
  connect(this, &MainWindow::trial_finished, delivery, &StatementDelivery::wake);
  connect(delivery, &StatementDelivery::told, records_, &RecordsPage::tell_of_statements);
  connect(result_, &ResultPage::again, this, [this] {
    if (const auto again = again_) again();  // a copy: preparing puts another in its place, what it holds with it
  });
  connect(result_, &ResultPage::same_again, this, [this] {
    if (const auto again = same_again_) again();
  });
  connect(rating_, &SelfRatingPage::rated, this, &MainWindow::take_self_rating);
  connect(result_, &ResultPage::left, this, &MainWindow::back_to_start);
  connect(result_, &ResultPage::other_wanted, this, [this] {
    if (has_start_ && !trying_) first_ = start_;  // where scenarios are chosen; patient and course are as they were
    back_to_start();
  });
  connect(result_, &ResultPage::replay_wanted, this,
          [this](double at_s) { replay(outcome_.log, at_s, {}, kBeforeReason_s); });
  connect(replay_, &ReplayPage::left, this, &MainWindow::leave_replay);
  connect(replay_, &ReplayPage::failed, this, [this](const QString& message) {
    leave_replay();
    emit replay_failed(message);
  });
  connect_station();
}

void MainWindow::connect_station() {
  station_ = new InstructorStation(*this, records_->desk(), *trial_);
  menu_->view().addSeparator();
  menu_->view().addActions({station_->open_action(), station_->next_trainee_action()});
  who_->offer(station_->next_trainee_action());
  station_->set_may_change([this] { return may_put_aside(); });
  connect(station_, &InstructorStation::next_trainee_begins, this, [this] {
    give_up_work();  // what is being prepared was for the one before
    trying_ = false;
    if (trial_->session()) trial_->close_trial();
    if (pages_->currentWidget() == replay_) leave_replay();
    back_to_start();
  });
  connect(station_, &InstructorStation::new_trainee_wanted, this, [this] {
    show_page(records_);
    records_->register_trainee();
  });
  connect(station_, &InstructorStation::told, this, &MainWindow::tell);
  connect(devices_, &DevicesPage::check_wanted, station_,
          [this](const device::FoundDevice& device) { station_->check_device(QString::fromStdString(device.name)); });
}

MainWindow::~MainWindow() {
  give_up_work();
  ready_->stop();
  for (const auto& thread : {worker_, looker_, readier_})
    if (thread) thread->wait();
}

QWidget* MainWindow::make_prepare_page() {
  auto* page = new QWidget(pages_);
  auto* title = new QLabel(tr("Preparing the patient"), page);
  title->setObjectName("title");
  prepare_stage_ = new QLabel(page);
  prepare_stage_->setObjectName("stage");
  prepare_bar_ = new QProgressBar(page);
  prepare_bar_->setRange(0, 1000);
  prepare_bar_->setTextVisible(false);
  auto* cancel = new QPushButton(tr("Cancel"), page);
  connect(cancel, &QPushButton::clicked, this, [this] {
    give_up_work();
    prepare_stage_->setText(tr("Stopping ..."));
  });
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(220, 0, 220, 0);
  column->setSpacing(14);
  column->addStretch(1);
  column->addWidget(title);
  column->addWidget(prepare_stage_);
  column->addWidget(prepare_bar_);
  column->addWidget(cancel, 0, Qt::AlignRight);
  column->addStretch(2);
  return page;
}

void MainWindow::show_start(std::vector<curricula::Curriculum> curricula) {
  has_start_ = true;
  restore_place();
  records_->set_curricula(curricula);
  start_->set_curricula(std::move(curricula));
  const auto kept = user_settings();
  const QString device = kept->value("device", "mouse").toString();
  choose_last_device(device);
  start_->select(kept->value("scenario").toString(), device);
  devices_->refresh();
  add_imported_patients(kept->value("patient").toString().toStdString());
  back_to_start();
  page_changed();
}

void MainWindow::choose_last_device(const QString& name) {
  for (const device::DeviceKind& kind : device::device_kinds()) {
    if (!kind.hardware || name.section(':', 0, 0).toStdString() != kind.kind) continue;
    try {
      check_device_name(name.toStdString());
      start_->choose_device(name, tr("%1 (used last)").arg(name));  // until it is found, and is told by its model
    } catch (const UnknownDevice&) {
      return;  // what an older version kept
    }
  }
}

void MainWindow::add_imported_patients(const std::filesystem::path& last) {
  using Packages = std::vector<std::filesystem::path>;
  run_in_background<Packages>(
      this,
      [last, folder = patients_folder()] {
        std::error_code none;
        Packages found;
        const auto add = [&](const std::filesystem::path& package) {
          if (package.extension() == ".patient" && std::filesystem::exists(package / "patient.yaml", none))
            found.push_back(package);
        };
        for (const auto& entry : std::filesystem::directory_iterator(folder, none)) add(entry.path());
        std::sort(found.begin(), found.end());
        if (std::find(found.begin(), found.end(), last) == found.end()) add(last);
        return found;
      },
      [this, last](const Packages& found) {
        const bool untouched = start_->hands().patient.empty();  // nobody was quicker and chose another
        for (const auto& package : found) start_->add_patient(package, untouched && package == last);
        patients_known_ = true;
        if (pages_->currentWidget() == home_) look_around();
      },
      [this](const QString& message) { tell_first(message); });
}

void MainWindow::import_series(const QString& source) {
  pages_->setCurrentWidget(import_);
  import_->begin(source);
}

void MainWindow::write_course(const std::filesystem::path& file) {
  pages_->setCurrentWidget(authoring_);
  if (file.empty())
    authoring_->begin();
  else
    authoring_->open_file(file);
}

void MainWindow::show_failure(const QString& message) {
  if (trying_)
    authoring_->set_message(message);
  else
    tell_first(message);
  back_to_start();
  emit trial_failed(message);
}

void MainWindow::show_result() {
  result_->show_outcome(outcome_, scenario_, results_, misfits_);
  pages_->setCurrentWidget(result_);
}

void MainWindow::take_self_rating(const SelfRating& rating) {
  const curricula::Who who = records_->desk().who();
  records_->desk().ask<bool>(
      this,
      [who, trial = outcome_.record_id, rating](curricula::Records& records) {
        keep_self_rating(records, who, trial, rating);  // before anything of the score is seen
        return true;
      },
      [this](bool) { show_result(); }, [this](const QString& message) { rating_->set_message(message); });
}

void MainWindow::read_past() {
  const curricula::Who who = records_->desk().who();
  records_->desk().ask<PastResults>(
      this,
      [who](curricula::Records& records) { return curricula::Progress(records).results(who, who ? who->id() : 0); },
      [this, person = records_->desk().person().id](PastResults past) {
        if (person == records_->desk().person().id) start_->set_past(std::move(past), records_->desk().instructor());
      },
      [this](const QString& message) { tell_first(message); });
}

void MainWindow::back_to_start() {
  if (trying_) {
    trying_ = false;
    pages_->setCurrentWidget(authoring_);
  } else if (has_start_) {
    pages_->setCurrentWidget(first_);
    read_past();
  } else {
    close();  // opened for one trial only
  }
}

void MainWindow::show_trial(const QString& log, bool with_replay) {
  if (with_replay) return replay(log.toStdString());
  const std::filesystem::path folder = std::filesystem::path(log.toStdString()).parent_path();
  std::error_code error;
  const auto report = folder / "report.html";
  const QString trouble = open_outside(std::filesystem::exists(report, error) ? report : folder);
  if (!trouble.isEmpty()) records_->tell(trouble);
}

QString MainWindow::page_name() const {
  const QWidget* page = pages_->currentWidget();
  return page == home_           ? "home"
         : page == start_        ? "start"
         : page == devices_      ? "devices"
         : page == records_      ? "records"
         : page == import_       ? "import"
         : page == authoring_    ? "authoring"
         : page == prepare_page_ ? "prepare"
         : page == trial_        ? "trial"
         : page == replay_       ? "replay"
         : page == rating_       ? "rating"
                                 : "result";
}

bool MainWindow::may_put_aside() {
  return authoring_->may_leave() && (pages_->currentWidget() != rating_ || rating_->may_close());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_put_aside()) {
    event->ignore();
    return;
  }
  if (trial_->held_by_instructor()) {
    trial_->refuse_to_end();
    event->ignore();
    return;
  }
  if (trial_->assessing()) {  // it counts as ended by the End button does, and is rated before the window goes
    trial_->end(curricula::kEndedByTrainee);
    event->ignore();
    return;
  }
  keep_place();
  draft_->forget();
  give_up_work();
  import_->stop();
  trial_->close_trial();
  replay_->close_replay();
  QMainWindow::closeEvent(event);
}

}  // namespace vallecula::gui
