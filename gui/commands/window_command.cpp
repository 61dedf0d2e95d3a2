// The trainer's window: without a subcommand, for `vallecula trial` without --headless, and for `vallecula replay
// --window`.
#include <spdlog/spdlog.h>

#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "gui/commands/commands.h"
#include "gui/pages/main_window.h"
#include "gui/pages/versions.h"
#include "gui/pages/window_application.h"
#include "gui/session/curricula_files.h"
#include "gui/session/device_choice.h"
#include "gui/session/program_log.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {

namespace {

int run_window(const std::function<void(MainWindow&)>& opened) {
  WindowApplication application;
  program_log::begin(user_data_folder() / "logs");
  program_log::note("started: " + system_lines().front());
  FoundCurricula found = find_curricula();
  for (const std::string& told : found.refused) spdlog::warn("{}", told);
  std::unique_ptr<MainWindow> window;
  const auto open = [&window, &found] {
    auto next = std::make_unique<MainWindow>();
    next->show_start(found.curricula);
    if (window) next->setGeometry(window->geometry());
    next->show();
    window.swap(next);  // the one before goes once this is seen: the program ends with its last window
  };
  open();
  window->look_back();
  // In another language all of the window is made anew, with the first steps where it was chosen there.
  const std::function<void()> follow_words = [&] {
    QObject::connect(window.get(), &MainWindow::words_changed, &application.qt(), [&](bool first_steps) {
      QTimer::singleShot(0, &application.qt(), [&, first_steps] {
        open();
        follow_words();
        if (first_steps) window->show_first_steps(true);
      });
    });
  };
  follow_words();
  opened(*window);
  const int code = application.qt().exec();
  program_log::note("ended");
  program_log::end();
  return code;
}

}  // namespace

int run_window_command() {
  return run_window([](MainWindow& window) { window.welcome(); });
}

int run_window_course(const std::string& file) {
  return run_window([&](MainWindow& window) { window.write_course(file); });
}

int run_window_import(const std::string& series) {
  return run_window([&](MainWindow& window) { window.import_series(QString::fromStdString(series)); });
}

int run_window_replay(const std::string& trial, double at_s, const std::string& patient) {
  WindowApplication application;
  MainWindow window;
  std::string failure;
  QObject::connect(&window, &MainWindow::replay_failed,
                   [&](const QString& message) { failure = message.toStdString(); });
  window.show();
  window.replay(trial, at_s, patient);
  application.qt().exec();
  if (!failure.empty()) throw std::runtime_error(failure);
  return 0;
}

int run_window_trial(const TrialSetup& setup) {
  WindowApplication application;
  MainWindow window;
  bool finished = false;
  std::string failure;
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome&) { finished = true; });
  QObject::connect(&window, &MainWindow::trial_failed,
                   [&](const QString& message) { failure = message.toStdString(); });
  window.show();
  window.prepare(setup, is_scripted(setup.device));  // a person presses Start; a script waits for nobody
  application.qt().exec();
  if (!failure.empty()) throw std::runtime_error(failure);
  if (!finished)
    throw std::runtime_error("the window was closed before the trial ended; what was recorded until then is in " +
                             setup.out.string());
  return 0;
}

}  // namespace vallecula::gui
