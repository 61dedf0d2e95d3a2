// What frames the window's pages: home, menu, files that are dropped or opened, the look.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QStackedWidget>
#include <QUrl>
#include <algorithm>
#include <stdexcept>

#include "gui/authoring/authoring_page.h"
#include "gui/import/import_wizard.h"
#include "gui/pages/background.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/home_page.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/main_window.h"
#include "gui/pages/open_dialog.h"
#include "gui/pages/ready_patient.h"
#include "gui/pages/recent_entry.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/self_rating_page.h"
#include "gui/pages/settings_dialog.h"
#include "gui/pages/trial_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/low_priority.h"
#include "gui/session/patient_fit.h"
#include "gui/session/program_log.h"
#include "gui/session/recent_files.h"
#include "gui/session/scene_from_package.h"

namespace vallecula::gui {
namespace {

constexpr double kTextStep = 0.1;

std::vector<std::filesystem::path> local_files(const QMimeData& data) {
  std::vector<std::filesystem::path> paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths.emplace_back(url.toLocalFile().toStdString());
  return paths;
}

// Of what is made ready before it is asked for: the window goes first. Not less, for whoever then asks waits for it,
// and no thread may raise itself again: with 10, on a machine with ten other jobs, the wait was three times a trial's
// making.
constexpr int kReadyNice = 2;

/// All that a scene is made of, as it is chosen; whatever is drawn for the attempt comes later.
std::string made_of(const Choice& choice) {
  return choice.patient.string() + '\n' + choice.taken.blade + '\n' + choice.taken.tube + '\n' + choice.scenario.yaml;
}

curricula::Scenario scenario_as_chosen(const Choice& choice) {
  const bool chosen = !choice.taken.blade.empty() || !choice.taken.tube.empty();
  return chosen ? curricula::attempt_of(choice.scenario, choice.mode, 0, choice.taken) : choice.scenario;
}

/// What the first page shows of the disk.
struct Around {
  QImage patient;
  std::vector<RecentEntry> recent;
  std::filesystem::path package;  ///< of the next trial's patient; empty: it is not made yet
};

}  // namespace

void MainWindow::show_page(QWidget* page) {
  if (page == home_ || page == start_) first_ = page;
  if (pages_->currentWidget() == replay_) replay_->close_replay();
  pages_->setCurrentWidget(page);
}

void MainWindow::page_changed() {
  const QWidget* page = pages_->currentWidget();
  // The page that is seen says how small the window may be, not the largest of them all.
  for (int i = 0; i < pages_->count(); ++i) {
    const auto policy = pages_->widget(i) == page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    pages_->widget(i)->setSizePolicy(policy, policy);
  }
  program_log::note("page " + page_name().toStdString());
  who_->setVisible(page == home_ || page == start_);
  menu_->set_state(!has_start_ || page == trial_ || page == rating_ || page == prepare_page_, may_open());
  if (page == home_) look_around();
}

void MainWindow::connect_home() {
  connect(home_, &HomePage::practise_wanted, this, &MainWindow::practise);
  connect(home_, &HomePage::course_wanted, this, [this] { show_page(start_); });
  connect(home_, &HomePage::import_wanted, this, [this] { import_series(); });
  connect(home_, &HomePage::records_wanted, this, [this] { show_page(records_); });
  connect(home_, &HomePage::devices_wanted, this, [this] { show_page(devices_); });
  connect(home_, &HomePage::writing_wanted, this, [this] { write_course(); });
  connect(home_, &HomePage::recent_wanted, this, [this](const QString& path) { open_files({path.toStdString()}); });
  connect(start_, &StartPage::home_wanted, this, [this] { show_page(home_); });
  connect(start_, &StartPage::changed, this, [this] {
    home_->set_next(start_->next_trial());
    if (pages_->currentWidget() == home_) look_around();
    if (told_of_fit_) tell_first("");  // of another choice
  });
  connect(start_, &StartPage::patient_taken, this, &MainWindow::fit_scenario);
  home_->set_next(start_->next_trial());
}

void MainWindow::fit_scenario(const QString& package) {
  const std::filesystem::path path = package.toStdString();
  const std::string before = start_->chosen_scenario();
  run_in_background<double>(
      this, [path] { return weight_as_large(pipeline::read_package(path)); },
      [this, path, before](double weight_kg) {
        if (start_->chosen_scenario() != before) return;  // chosen meanwhile, by a person: stays
        const QString told = start_->fit_scenario(path, weight_kg);
        if (told.isEmpty()) return;
        tell_first(told);
        told_of_fit_ = true;
      },
      [](const QString&) {});  // one that cannot be read is told when a trial with it is asked for
}

void MainWindow::connect_menu() {
  connect(menu_, &MainMenu::home_wanted, this, [this] { show_page(home_); });
  connect(menu_, &MainMenu::course_wanted, this, [this] { show_page(start_); });
  connect(menu_, &MainMenu::records_wanted, this, [this] { show_page(records_); });
  connect(menu_, &MainMenu::devices_wanted, this, [this] { show_page(devices_); });
  connect(menu_, &MainMenu::import_wanted, this, [this] { import_series(); });
  connect(menu_, &MainMenu::writing_wanted, this, [this] { write_course(); });
  connect(menu_, &MainMenu::recent_wanted, this, [this](const QString& path) { open_files({path.toStdString()}); });
  connect(menu_, &MainMenu::open_wanted, this, [this] {
    auto* dialog = new OpenDialog(folder_to_open(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &OpenDialog::chosen, this, [this](const QString& path) {
      keep_opened(path);
      open_files({path.toStdString()});
    });
    dialog->open();
  });
  connect(menu_, &MainMenu::quit_wanted, this, &QWidget::close);
  connect(menu_, &MainMenu::settings_wanted, this, [this] {
    auto* dialog = new SettingsDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &SettingsDialog::language_chosen, this, &MainWindow::follow_language);
    dialog->open();
  });
  connect(menu_, &MainMenu::ground_wanted, this, [](const QString& ground) {
    LookSettings look = look_settings();
    look.ground = ground;
    keep_look(look);
    apply_look(look);
  });
  connect(menu_, &MainMenu::text_wanted, this, [](int steps) {
    LookSettings look = look_settings();
    look.text_scale =
        steps == 0 ? 1.0
                   : std::clamp(look.text_scale + kTextStep * steps, theme::kLeastTextScale, theme::kMostTextScale);
    keep_look(look);
    apply_look(look);
  });
}

void MainWindow::practise() {
  if (!start_->next_trial().hindrance.isEmpty()) return show_page(start_);
  Choice choice = start_->choice();
  choice.mode = curricula::Mode::practice;
  prepare_choice(choice);
}

void MainWindow::look_around() {
  if (looker_ && !looker_->isFinished()) {
    look_again_ = true;
    return;
  }
  look_again_ = false;
  std::optional<Choice> next;
  if (!start_->next_trial().scenario.isEmpty()) next = start_->choice();
  std::filesystem::path patient = start_->hands().patient;
  const curricula::ManikinSpec manikin = next ? next->scenario.manikin : curricula::ManikinSpec();
  looker_ = run_in_background<Around>(
      this,
      [patient, manikin, files = kept_recent()]() mutable {
        if (patient.empty()) patient = builtin_patients_folder() / (builtin_patient_name(manikin) + ".patient");
        std::error_code none;
        return Around{QImage(QString::fromStdString((patient / "thumbnail.png").string())),
                      with_words(still_there(files)),
                      std::filesystem::exists(patient / "patient.yaml", none) ? patient : std::filesystem::path()};
      },
      [this, next](const Around& around) {
        home_->set_picture(around.patient);
        home_->set_recent(around.recent);
        menu_->set_recent(around.recent);
        ready_package_ = around.package;
        ready_wanted_ = next;
        look_again_ ? look_around() : make_ready();
      },
      [this](const QString& message) { home_->set_message(message); });
}

void MainWindow::make_ready() {
  const QWidget* page = pages_->currentWidget();
  if (!patients_known_ || working_ || ready_package_.empty() || (page != home_ && page != start_)) return;
  if (readier_ && !readier_->isFinished()) {  // once it is done
    if (ready_wanted_) leave_unwanted(*ready_wanted_);
    return;
  }
  const std::string asked = ready_asked_ = ready_wanted_ ? made_of(*ready_wanted_) : std::string();
  ready_asked_of_ = ready_wanted_ ? ready_wanted_->patient : std::filesystem::path();
  ready_left_ = ready_patient_left_ = false;
  const auto done = [this, asked, package = ready_package_] {
    if (ready_left_ || package != ready_package_ || (ready_wanted_ && made_of(*ready_wanted_) != asked)) make_ready();
  };
  readier_ = run_in_background<std::shared_ptr<PatientLook>>(
      this,
      [this, package = ready_package_, next = ready_wanted_] {
        take_low_priority(kReadyNice);
        const auto unless = [](const std::atomic<bool>& left) {
          return [&left](const std::string&, double) {
            if (left) throw std::runtime_error("something else was chosen");
          };
        };
        auto look = ready_->look(package, unless(ready_patient_left_));
        if (next) ready_->scene(scene_from_package(look->package, scenario_as_chosen(*next)), unless(ready_left_));
        return look;
      },
      [done](const std::shared_ptr<PatientLook>&) { done(); },
      [done](const QString&) { done(); });  // told when a trial with it is asked for
}

void MainWindow::leave_unwanted(const Choice& wanted) {
  if (made_of(wanted) == ready_asked_) return;
  ready_left_ = true;
  ready_patient_left_ = wanted.patient != ready_asked_of_;  // another scenario of the same patient needs the same look
}

void MainWindow::remember(const std::filesystem::path& path) {
  remember_recent(path);
  if (pages_->currentWidget() == home_) look_around();
}

bool MainWindow::may_open() const {
  const QWidget* page = pages_->currentWidget();
  if (page == import_) return import_->step() == "source" && !import_->work().busy();
  return page != trial_ && page != rating_ && page != prepare_page_ && page != authoring_;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (pages_->currentWidget() != trial_ && !local_files(*event->mimeData()).empty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  open_files(local_files(*event->mimeData()));
}

void MainWindow::open_files(const std::vector<std::filesystem::path>& paths) {
  if (pages_->currentWidget() == authoring_ ? !authoring_->may_leave() : !may_open())
    return tell(tr("Finish or leave what is under way on this page first; then it can be opened."));
  for (const auto& path : paths)  // a trial's file is called as every other's
    path.extension() == ".vtrial" ? program_log::hide(path.string()) : program_log::hide(path);
  run_in_background<Dropped>(
      this, [paths] { return what_was_dropped(paths); }, [this](const Dropped& found) { open_found(found); },
      [this](const QString& message) { tell(message); });
}

void MainWindow::open_found(const Dropped& found) {
  tell_first("");
  switch (found.kind) {
    case DroppedKind::nothing:
      return tell(found.message);
    case DroppedKind::ct:
      return import_series(QString::fromStdString(found.path.string()));
    case DroppedKind::patient:
      start_->take_patient(found.path);
      remember(found.path);
      return show_page(first_);
    case DroppedKind::course:
      return open_course(found.path);
    case DroppedKind::trial:
      if (!records_->desk().who()) remember(found.path);
      return replay(found.path);
  }
}

void MainWindow::open_course(const std::filesystem::path& file) {
  run_in_background<curricula::Curriculum>(
      this, [file] { return curricula::load_curriculum(file); },
      [this, file](curricula::Curriculum course) {
        std::vector<curricula::Curriculum> all = start_->curricula();
        const auto same = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.id == course.id; });
        std::error_code error;
        if (same != all.end() && !std::filesystem::equivalent(same->file, file, error))
          return tell(tr("%1: a course of this id (%2) is there already; give it another id.")
                          .arg(QString::fromStdString(file.filename().string()), QString::fromStdString(course.id)));
        const std::string first = course.scenarios.front().id;
        if (same != all.end()) {
          *same = course;
        } else {
          opened_courses_.push_back(course);
          all.push_back(course);
        }
        records_->set_curricula(all);
        start_->set_curricula(std::move(all));
        start_->show_course(course.id);
        remember(file);
        show_page(start_);
      },
      [this](const QString& message) { tell(message); });
}

void MainWindow::tell_first(const QString& message) {
  told_of_fit_ = false;
  for (QWidget* page : {static_cast<QWidget*>(home_), static_cast<QWidget*>(start_)}) {
    const QString here = page == first_ ? message : QString();
    page == home_ ? home_->set_message(here) : start_->set_message(here);
  }
}

void MainWindow::tell(const QString& message) {
  if (pages_->currentWidget() == first_) return tell_first(message);
  auto* box = new QMessageBox(QMessageBox::Information, windowTitle(), message, QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace vallecula::gui
