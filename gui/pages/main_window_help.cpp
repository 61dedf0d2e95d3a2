// The window's help, its log, the first steps, and what is found at the start of a program that ended too early.
#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QMetaMethod>
#include <QStackedWidget>
#include <utility>

#include "gui/authoring/authoring_page.h"
#include "gui/authoring/kept_draft.h"
#include "gui/instructor/instructor_window.h"
#include "gui/instructor/station.h"
#include "gui/pages/about_dialog.h"
#include "gui/pages/background.h"
#include "gui/pages/devices_page.h"
#include "gui/pages/first_run.h"
#include "gui/pages/help_dialog.h"
#include "gui/pages/home_page.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/main_window.h"
#include "gui/pages/versions.h"
#include "gui/records_pages/records_page.h"
#include "gui/session/curricula_files.h"
#include "gui/session/languages.h"
#include "gui/session/program_log.h"
#include "gui/session/trial_record.h"
#include "gui/session/user_paths.h"
#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

constexpr const char *kOpenDraft = "draft:open", *kDropDraft = "draft:drop", *kTrialLink = "trial:";

}  // namespace

struct FoundAtStart {
  std::vector<Tidied> tidied;
  std::optional<LeftDraft> draft;
  QString problem;  ///< why it could not be looked for; empty: nothing
};

void MainWindow::connect_help() {
  draft_ = new KeptDraft(authoring_->document(), user_data_folder() / "unsaved", this);
  connect(menu_, &MainMenu::help_wanted, this, &MainWindow::show_help);
  connect(home_, &HomePage::help_wanted, this, &MainWindow::show_help);
  connect(home_, &HomePage::link_followed, this, &MainWindow::follow);
  connect(menu_, &MainMenu::first_steps_wanted, this, [this] { show_first_steps(false); });
  connect(menu_, &MainMenu::about_wanted, this, [this] {
    auto* dialog = new AboutDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
  });
  connect(menu_, &MainMenu::log_wanted, this, [this] {
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save a log to send"), "vallecula-log.txt", tr("Text (*.txt)"));
    if (!file.isEmpty()) save_log(file.toStdString());
  });
  connect(&records_->desk(), &RecordsDesk::changed, this, [this] {
    program_log::hide(records_->desk().person().name);
    program_log::note(records_->desk().who() ? "somebody signed in" : "nobody is signed in");
  });
  connect(this, &MainWindow::prepared, this, [this] {
    const bool ours = is_shipped(prepared_.curriculum);
    program_log::note("trial prepared in " + std::to_string(prepare_time_.elapsed()) +
                      " ms: " + (ours ? prepared_.scenario : "a scenario of an own course") + ", " +
                      (prepared_.mode == curricula::Mode::assessment ? "assessment" : "practice") + ", device " +
                      prepared_.device.substr(0, prepared_.device.find(':')) +
                      (prepared_.second.empty() ? "" : " + " + prepared_.second.substr(0, prepared_.second.find(':'))));
    trial_time_.start();
  });
  connect(this, &MainWindow::trial_finished, this, [this](const TrialOutcome& outcome) {
    program_log::note("trial ended after " + std::to_string(trial_time_.elapsed() / 1000) + " s on its page");
    if (!outcome.fault.empty()) program_log::note("fault: " + outcome.fault);
  });
  // Its kind alone: the message is for who sits there, and may name a patient.
  const auto failed = [this](const char* what) {
    program_log::note(what + (failure_.empty() ? std::string("on its page") : failure_));
  };
  connect(this, &MainWindow::trial_failed, this, [failed] { failed("trial failed: "); });
  connect(this, &MainWindow::replay_opened, this,
          [this] { program_log::note("replay opened in " + std::to_string(prepare_time_.elapsed()) + " ms"); });
  connect(this, &MainWindow::replay_failed, this, [failed] { failed("replay failed: "); });
}

void MainWindow::show_help() {
  if (help_ == nullptr) help_ = new HelpDialog(this);
  help_->show_chapter(help_chapter_of(page_name()));
  help_->show();
  help_->raise();
  help_->activateWindow();
}

void MainWindow::save_log(const std::filesystem::path& to) {
  run_in_background<bool>(
      this,
      [to, head = system_lines()] {
        program_log::save(to, head);
        return true;
      },
      [this](bool) {
        tell(tr("The log is saved. It names no person, no patient and no folder; look through it before you send it."));
      },
      [this](const QString& message) { tell(message); });
}

void MainWindow::welcome() {
  if (is_first_run()) show_first_steps(true);
}

void MainWindow::show_first_steps(bool very_first) {
  auto* dialog = new FirstRun(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(devices_, &DevicesPage::found, dialog, &FirstRun::set_found_devices);
  connect(dialog, &FirstRun::device_chosen, start_, &StartPage::choose_device);
  connect(dialog, &FirstRun::begin_wanted, this, [this](const QString& device) {
    if (start_->curricula().empty()) return;
    start_->select(QString::fromStdString(start_->curricula().front().scenarios.front().id), device);
    practise();
  });
  connect(dialog, &FirstRun::language_chosen, this, [this, dialog, very_first](const QString& code) {
    keep_language(code);
    // Whoever has worked in this window keeps it: somebody may be signed in, something unsaved.
    if (!very_first) return tell(tr("Chosen: the window speaks it from the next start on."));
    install_language(*qApp, code);
    dialog->QDialog::done(QDialog::Rejected);  // not finished: they begin anew
    if (isSignalConnected(QMetaMethod::fromSignal(&MainWindow::words_changed))) return void(emit words_changed(true));
    show_first_steps(true);
  });
  devices_->refresh();
  dialog->open();
}

bool MainWindow::may_be_made_anew() const {
  const QWidget* page = pages_->currentWidget();
  const bool at_rest = page == home_ || page == start_ || page == records_ || page == devices_;
  const InstructorWindow* instructor = station_->instructor_window();
  const bool instructed = instructor != nullptr && instructor->isVisible();
  return at_rest && !working_ && !instructed && !records_->desk().who() && !authoring_->document().modified() &&
         isSignalConnected(QMetaMethod::fromSignal(&MainWindow::words_changed));
}

void MainWindow::follow_language() {
  const QString wanted = language_at_start();  // the one chosen, or the system's
  if (wanted == language()) return;
  if (!may_be_made_anew()) return tell(tr("Chosen: the window speaks it from the next start on."));
  keep_place();
  install_language(*qApp, wanted);
  emit words_changed(false);
}

void MainWindow::look_back() {
  looking_back_ = true;
  const auto over = [this] {
    looking_back_ = false;
    emit looked_back();
  };
  run_in_background<FoundAtStart>(
      this,
      [folder = user_data_folder() / "unsaved"] {
        return FoundAtStart{tidy_records(), left_draft(folder), {}};
      },
      [this, over](const FoundAtStart& found) {
        found_ = std::make_shared<FoundAtStart>(found);
        show_found();
        over();
      },
      [this, over](const QString& message) {
        found_ = std::make_shared<FoundAtStart>();
        found_->problem = message;
        show_found();
        over();
      });
}

void MainWindow::show_found() {
  if (!found_) return home_->set_notice({});
  QStringList lines;
  for (const Tidied& one : found_->tidied) {
    QString line = in_words(one.sentence).toHtmlEscaped();
    if (!line.isEmpty()) line[0] = line[0].toUpper();
    if (!one.log.empty())
      line += QString(". <a href=\"%1%2\">%3</a>")
                  .arg(kTrialLink, QString::fromStdString(one.log.string()).toHtmlEscaped(), tr("Look at it"));
    lines << line;
  }
  if (found_->draft)
    lines << tr("A course was being written when the program ended.") +
                 QString(" <a href=\"%1\">%2</a> &nbsp; <a href=\"%3\">%4</a>")
                     .arg(kOpenDraft, tr("Go on with it"), kDropDraft, tr("Let it go"));
  home_->set_notice(lines.join("<br>"));
  if (!found_->problem.isEmpty()) tell_first(found_->problem);
}

void MainWindow::take_over(MainWindow& before) {
  restoreGeometry(before.saveGeometry());
  found_ = std::move(before.found_);
  show_found();
}

void MainWindow::follow(const QString& link) {
  const auto found = std::exchange(found_, nullptr);
  show_found();
  if (link.startsWith(kTrialLink)) return open_files({link.mid(QString(kTrialLink).size()).toStdString()});
  if (!found || !found->draft) return;
  if (link == kOpenDraft) {
    pages_->setCurrentWidget(authoring_);
    authoring_->recover(found->draft->from, found->draft->text);
  }
  remove_draft(found->draft->kept);
}

void MainWindow::restore_place() {
  const auto kept = user_settings();
  restoreGeometry(kept->value("window/geometry").toByteArray());
  if (kept->value("window/page").toString() == "start") first_ = start_;
}

void MainWindow::keep_place() {
  if (!has_start_) return;
  const auto kept = user_settings();
  kept->setValue("window/geometry", saveGeometry());
  kept->setValue("window/page", first_ == start_ ? "start" : "home");
}

}  // namespace vallecula::gui
