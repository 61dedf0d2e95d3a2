// How the window prepares a trial or a replay, on a thread of its own, and opens it.
#include "gui/pages/main_window.h"

#include <QDateTime>
#include <QLabel>
#include <QProgressBar>
#include <QRandomGenerator>
#include <QStackedWidget>
#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "gui/authoring/authoring_page.h"
#include "gui/instructor/station.h"
#include "gui/pages/background.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_page.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/patient_fit.h"
#include "gui/session/program_log.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "gui/views/patient_look.h"

namespace vallecula::gui {
namespace {

struct Prepared {
  std::shared_ptr<TrialSession> session;
  std::shared_ptr<PatientLook> look;
};

/// Thrown through a progress report to leave work that nobody waits for any more.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace

void MainWindow::try_scenario(const QString& file, const QString& id) {
  Choice choice = start_->hands();
  choice.curriculum = file.toStdString();
  try {
    const curricula::Curriculum course = curricula::load_curriculum(choice.curriculum);
    choice.scenario = *course.find(id.toStdString());
  } catch (const curricula::CurriculumError& error) {
    authoring_->set_message(QString::fromUtf8(error.what()));
    return;
  }
  if (choice.device == "scripted:novice" && choice.scenario.intubation) choice.device = "scripted:expert";  // no tube
  trying_ = true;
  prepare_choice(choice);
}

void MainWindow::prepare_choice(const Choice& choice, std::uint32_t seed) {
  station_->check_before({choice.device, choice.second}, [=] { prepare_checked(choice, seed); });
}

void MainWindow::prepare_checked(const Choice& choice, std::uint32_t seed) {
  TrialSetup setup;
  setup.curriculum = choice.curriculum;
  setup.scenario = choice.scenario.id;
  setup.device = choice.device.toStdString();
  setup.second = choice.second.toStdString();
  setup.trainee_id = trying_ ? 0 : records_->desk().person().id;
  setup.mode = choice.mode;
  setup.taken = choice.taken;
  if (!trying_) {
    const auto kept = user_settings();
    kept->setValue("scenario", QString::fromStdString(choice.scenario.id));
    kept->setValue("device", choice.device);
    kept->setValue("patient", QString::fromStdString(choice.patient.string()));
    if (!choice.patient.empty()) remember(choice.patient);
  }
  again_ = [this, choice] { prepare_choice(choice); };
  const std::string moment = QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss").toStdString();
  setup.out = user_data_folder() / "trials" / (moment + "-" + choice.scenario.id);
  // No two attempts are the same; the seed stands in the trial's log, and `vallecula trial` repeats it.
  if (choice.scenario.variation && curricula::rules_of(choice.mode).variation)
    setup.attempt_seed = seed != 0 ? seed : QRandomGenerator::global()->bounded(1u, 0xffffffffu);
  same_again_ = [this, choice, drawn = setup.attempt_seed] { prepare_choice(choice, drawn); };
  const auto manikin = curricula::attempt_of(choice.scenario, setup.mode, setup.attempt_seed).manikin;
  const auto chosen = choice.patient;
  prepare(
      setup,
      [this, manikin, chosen] {
        if (!chosen.empty()) return chosen;
        return builtin_patient(
            manikin, [this](const std::string& stage, double fraction) { report_progress(stage, 0.9 * fraction); });
      },
      false);
}

void MainWindow::prepare(const TrialSetup& setup, bool start_at_once) {
  same_again_ = again_ = [this, setup, start_at_once] { prepare(setup, start_at_once); };
  prepare(
      setup, [patient = setup.patient] { return patient; }, start_at_once);
}

void MainWindow::prepare(TrialSetup setup, std::function<std::filesystem::path()> patient, bool start_at_once) {
  if (worker_ && !worker_->isFinished()) return;
  prepare_time_.start();
  prepared_ = setup;
  program_log::hide(setup.patient);
  results_ = setup.final_out.empty() ? setup.out : setup.final_out;
  tell_first("");
  cancelled_ = false;
  prepare_stage_->setText("Looking for the patient ...");
  prepare_bar_->setValue(0);
  pages_->setCurrentWidget(prepare_page_);
  worker_ = run_in_background<Prepared>(
      this,
      [this, setup, patient, gone = trial_->gone()] {
        while (gone.valid() && gone.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
          report_progress(tr("Keeping the trial before").toStdString(), 0.0);  // it has the device
        TrialSetup whole = setup;
        whole.patient = patient();
        program_log::hide(whole.patient);
        report_progress("Building the scene", 0.92);
        Prepared prepared;
        prepared.session = std::make_shared<TrialSession>(whole);
        report_progress("Light and colour", 0.96);
        prepared.look = make_patient_look(prepared.session->package(), {}, Seen::from_the_eye, whole.patient);
        report_progress("Ready", 1.0);
        return prepared;
      },
      [this, start_at_once, device = QString::fromStdString(setup.device)](Prepared ready) {
        if (cancelled_) return back_to_start();  // at the last moment
        scenario_ = ready.session->scenario();
        misfits_ = misfits(ready.session->package(), scenario_);
        pages_->setCurrentWidget(trial_);
        try {
          trial_->open(ready.session, ready.look);
          trial_->set_device_note(station_->checks().words(device));
        } catch (const std::exception& error) {
          show_failure(QString::fromUtf8(error.what()));
          return;
        }
        emit prepared();
        if (start_at_once) trial_->start();
      },
      [this](const QString& message) {
        if (cancelled_)
          back_to_start();
        else
          show_failure(message);
      });
}

void MainWindow::replay(const std::filesystem::path& trial, double at_s, const std::filesystem::path& patient) {
  if (worker_ && !worker_->isFinished()) return;  // its object outlives its work
  prepare_time_.start();
  QWidget* from = pages_->currentWidget();
  replay_from_ = from == result_ || from == records_ ? from : nullptr;
  result_->tell("");
  tell_first("");
  cancelled_ = false;
  prepare_stage_->setText("Reading the trial");
  prepare_bar_->setValue(0);
  pages_->setCurrentWidget(prepare_page_);
  const auto failed = [this](const QString& message) {
    if (replay_from_ == result_)
      result_->tell(message);
    else if (replay_from_ == records_)
      records_->tell(message);
    else
      tell_first(message);
    leave_replay();
    emit replay_failed(message);
  };
  worker_ = run_in_background<std::shared_ptr<ReplayTrial>>(
      this,
      [this, trial, patient, instructor = records_->desk().instructor()] {
        return open_replay(
            trial, patient, [this](const std::string& stage, double done) { report_progress(stage, done); }, instructor);
      },
      [this, at_s, failed](std::shared_ptr<ReplayTrial> opened) {
        pages_->setCurrentWidget(replay_);
        replay_->set_who(records_->desk().who());
        try {
          replay_->open(std::move(opened), std::max(0.0, at_s), at_s >= 0.0);
        } catch (const std::exception& error) {
          return failed(QString::fromUtf8(error.what()));
        }
        emit replay_opened();
      },
      [this, failed](const QString& message) { cancelled_ ? leave_replay() : failed(message); });
}

void MainWindow::leave_replay() {
  replay_->close_replay();
  if (replay_from_ != nullptr)
    pages_->setCurrentWidget(replay_from_);
  else
    back_to_start();
}

void MainWindow::report_progress(const std::string& stage, double fraction) {
  if (cancelled_) throw Cancelled();
  QMetaObject::invokeMethod(
      this,
      [this, text = QString::fromStdString(stage), value = static_cast<int>(1000.0 * fraction)] {
        if (cancelled_) return;
        prepare_stage_->setText(text);
        prepare_bar_->setValue(value);
      },
      Qt::QueuedConnection);
}

}  // namespace vallecula::gui
