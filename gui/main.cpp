// Vallecula: the trainer's window without arguments, the same work headless with a subcommand.
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <QString>
#include <QtGlobal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "gui/commands/commands.h"
#include "gui/commands/headless_application.h"
#include "gui/session/device_choice.h"

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

int complain(int exit_code, const std::string& message) {
  std::cerr << "vallecula: " << message << std::endl;
  return exit_code;
}

/// CLI11 names what it does not understand; the mend is added here.
int complain_of_usage(const CLI::App& app, const CLI::ParseError& error) {
  std::string command = "vallecula";
  for (const CLI::App* sub = &app; !sub->get_subcommands().empty();) {
    sub = sub->get_subcommands().front();
    command += " " + sub->get_name();
  }
  std::string message = error.what();
  const std::vector<std::string> left = app.remaining(true);
  // `curriculum eat` is told as a missing subcommand, though one was given that does not exist.
  const bool no_subcommand = message.find("subcommand is required") != std::string::npos;
  if ((dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr || no_subcommand) && !left.empty()) {
    const bool option = left.front().rfind('-', 0) == 0;
    message = std::string("unknown ") +
              (option                   ? "option"
               : command == "vallecula" ? "command"
                                        : "argument") +
              " '" + left.front() + "'";
  }
  return complain(kWrongUsage, message + "; see `" + command + " --help`");
}

/// Qt's own remarks (a missing runtime folder, a font it replaced) are not what a person asked for: --verbose shows
/// them.
void log_qt_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
  const bool grave = type == QtCriticalMsg || type == QtFatalMsg;
  spdlog::log(grave ? spdlog::level::err : spdlog::level::debug, "Qt: {}", text.toStdString());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace vallecula::gui;
  program_arguments() = {argc, argv};
  write_plain_numbers();  // a window then has its language's
  spdlog::set_default_logger(spdlog::stderr_logger_mt("vallecula"));
  spdlog::set_pattern("%H:%M:%S %^%l%$ %v");
  spdlog::set_level(spdlog::level::warn);
  qInstallMessageHandler(log_qt_message);

  CLI::App app(
      "Vallecula: a force-true trainer for neonatal endotracheal intubation.\n"
      "Without a command it opens the trainer. A training tool, not a medical device.",
      "vallecula");
  app.set_version_flag("--version", std::string("vallecula ") + VALLECULA_VERSION);
  app.add_flag_function(
      "--verbose", [](std::int64_t) { spdlog::set_level(spdlog::level::debug); }, "Say on stderr what is being done");
  app.require_subcommand(0, 1);
  app.fallthrough();
  app.failure_message([](const CLI::App*, const CLI::Error&) { return std::string(); });
  int exit_code = 0;
  add_demo_command(app, exit_code);
  add_manikin_command(app, exit_code);
  add_import_command(app, exit_code);
  add_series_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_export_command(app, exit_code);
  add_devices_command(app, exit_code);
  add_trial_command(app, exit_code);
  add_replay_command(app, exit_code);
  add_score_command(app, exit_code);
  add_curriculum_command(app, exit_code);
  add_records_command(app, exit_code);
  add_lab_command(app, exit_code);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) exit_code = run_window_command();
    return exit_code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return complain_of_usage(app, error);
  } catch (const UnknownDevice& error) {
    return complain(kWrongUsage, error.what());
  } catch (const std::bad_alloc&) {
    return complain(kFailed, "the memory is not enough for this; close other programs or take a smaller scan");
  } catch (const std::exception& error) {
    return complain(kFailed, error.what());
  }
}
