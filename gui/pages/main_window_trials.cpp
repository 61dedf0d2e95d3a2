// How the window prepares a trial or a replay, on a thread of its own, and opens it.
#include <QDateTime>
#include <QLabel>
#include <QProgressBar>
#include <QRandomGenerator>
#include <QStackedWidget>
#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "gui/authoring/authoring_page.h"
#include "gui/import/import_work.h"
#include "gui/instructor/station.h"
#include "gui/pages/background.h"
#include "gui/pages/main_window.h"
#include "gui/pages/ready_patient.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_page.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/failure_kind.h"
#include "gui/session/patient_fit.h"
#include "gui/session/program_log.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"

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

QString stage_words(const std::string& stage) {
  static const std::string import = "import: ";  // of the manikin
  return stage.rfind(import, 0) == 0 ? stage_text(stage.substr(import.size())) : in_words(stage);
}

/// Does the work; where that throws, its kind is put into `kind` on the way.
template <class Work>
auto noting_kind(std::string& kind, const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    kind = failure_kind(error);
    throw;
  }
}

}  // namespace

void MainWindow::try_scenario(const QString& file, const QString& id) {
  run_in_background<curricula::Curriculum>(
      this, [file = file.toStdString()] { return curricula::load_curriculum(file); },
      [this, file, id](const curricula::Curriculum& course) {
        if (pages_->currentWidget() != authoring_) return;  // left in the meantime
        Choice choice = start_->hands();
        choice.curriculum = file.toStdString();
        choice.scenario = *course.find(id.toStdString());
        if (choice.device == "scripted:novice" && choice.scenario.intubation) choice.device = "scripted:expert";  // no tube
        trying_ = true;
        prepare_choice(choice);
      },
      [this](const QString& message) { authoring_->set_message(message); });
}

void MainWindow::prepare_choice(const Choice& choice, std::uint32_t seed) {
  station_->check_before({choice.device, choice.second}, [=] { prepare_checked(choice, seed); });
}

void MainWindow::prepare_checked(const Choice& choice, std::uint32_t seed) {
  leave_unwanted(choice);
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
        const auto progress = [this](const std::string& stage, double done) { report_progress(stage, 0.7 * done); };
        const auto kept = builtin_patients_folder() / (builtin_patient_name(manikin) + ".patient");
        return ready_->has(kept, progress) ? kept : builtin_patient(manikin, progress);
      },
      false);
}

void MainWindow::prepare(const TrialSetup& setup, bool start_at_once) {
  same_again_ = again_ = [this, setup, start_at_once] { prepare(setup, start_at_once); };
  prepare(
      setup, [patient = setup.patient] { return patient; }, start_at_once);
}

void MainWindow::prepare(TrialSetup setup, std::function<std::filesystem::path()> patient, bool start_at_once) {
  if (working_) return instead_of_work([=] { prepare(setup, patient, start_at_once); });
  working_ = true;
  failure_.clear();
  prepare_time_.start();
  prepared_ = setup;
  program_log::hide(setup.patient);
  results_ = setup.final_out.empty() ? setup.out : setup.final_out;
  tell_first("");
  cancelled_ = false;
  prepare_stage_->setText(tr("Looking for the patient ..."));
  prepare_bar_->setValue(0);
  pages_->setCurrentWidget(prepare_page_);
  worker_ = run_in_background<Prepared>(
      this,
      [this, setup, patient, gone = trial_->gone()] {
        return noting_kind(failure_, [&] {
          while (gone.valid() && gone.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
            report_progress("Keeping the trial before", 0.0);  // it has the device
          TrialSetup whole = setup;
          whole.patient = patient();
          program_log::hide(whole.patient);
          Prepared prepared;
          prepared.look = ready_->look(whole.patient, [this](const std::string& stage, double done) {
            report_progress(stage, 0.7 + 0.2 * done);
          });
          whole.package = {prepared.look, &prepared.look->package};
          report_progress("Building the scene", 0.92);
          whole.build_scene = [this](const engine::SceneDescription& description) {
            return ready_->scene(description, [this](const std::string& stage, double done) {
              report_progress(stage, 0.92 + 0.07 * done);
            });
          };
          prepared.session = std::make_shared<TrialSession>(whole);
          report_progress("Ready", 1.0);
          return prepared;
        });
      },
      [this, start_at_once, device = QString::fromStdString(setup.device)](Prepared ready) {
        if (cancelled_) ready = {};  // at the last moment
        if (!work_ended([this] { back_to_start(); })) return;
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
        if (work_ended([this] { back_to_start(); })) show_failure(message);
      });
}

void MainWindow::instead_of_work(std::function<void()> next) {
  give_up_work();
  next_work_ = std::move(next);
  prepare_stage_->setText(tr("Stopping what was being prepared"));
  pages_->setCurrentWidget(prepare_page_);
}

void MainWindow::give_up_work() {
  cancelled_ = true;
  next_work_ = nullptr;
}

bool MainWindow::work_ended(const std::function<void()>& leave) {
  working_ = false;
  if (!cancelled_) return true;
  if (const auto next = std::exchange(next_work_, nullptr))
    next();
  else if (pages_->currentWidget() == prepare_page_)
    leave();
  return false;
}

void MainWindow::replay(const std::filesystem::path& trial, double at_s, const std::filesystem::path& patient,
                        double before_s) {
  QWidget* from = pages_->currentWidget();
  if (from != prepare_page_) replay_from_ = from == result_ || from == records_ ? from : nullptr;
  if (working_) return instead_of_work([=] { replay(trial, at_s, patient, before_s); });
  working_ = true;
  failure_.clear();
  prepare_time_.start();
  result_->tell("");
  tell_first("");
  cancelled_ = false;
  prepare_stage_->setText(tr("Reading the trial"));
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
        return noting_kind(failure_, [&] {
          return open_replay(
              trial, patient, [this](const std::string& stage, double done) { report_progress(stage, done); },
              instructor);
        });
      },
      [this, at_s, before_s, failed](std::shared_ptr<ReplayTrial> opened) {
        if (!work_ended([this] { leave_replay(); })) return;
        pages_->setCurrentWidget(replay_);
        replay_->set_who(records_->desk().who());
        try {
          replay_->open(std::move(opened), at_s, before_s);
        } catch (const std::exception& error) {
          return failed(QString::fromUtf8(error.what()));
        }
        emit replay_opened();
      },
      [this, failed](const QString& message) {
        if (work_ended([this] { leave_replay(); })) failed(message);
      });
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
      [this, text = stage_words(stage), value = static_cast<int>(1000.0 * fraction)] {
        if (cancelled_) return;
        prepare_stage_->setText(text);
        prepare_bar_->setValue(value);
      },
      Qt::QueuedConnection);
}

}  // namespace vallecula::gui
