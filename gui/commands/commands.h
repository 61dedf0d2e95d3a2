// The subcommands: one file each, gathered here. A subcommand's work is done in its CLI11 callback, which sets
// `exit_code` (0 done, 1 the work failed, 2 wrong usage) or throws std::exception with one line for the person:
// what, where, how to mend. main.cpp prints it as `vallecula: ...` and returns 1.
#pragma once

#include <CLI/CLI.hpp>

#include "gui/session/trial_session.h"

namespace vallecula::gui {

void add_demo_command(CLI::App& app, int& exit_code);
void add_manikin_command(CLI::App& app, int& exit_code);
void add_import_command(CLI::App& app, int& exit_code);
void add_series_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_export_command(CLI::App& app, int& exit_code);
void add_devices_command(CLI::App& app, int& exit_code);
void add_trial_command(CLI::App& app, int& exit_code);
void add_replay_command(CLI::App& app, int& exit_code);
void add_score_command(CLI::App& app, int& exit_code);
void add_curriculum_command(CLI::App& app, int& exit_code);
void add_records_command(CLI::App& app, int& exit_code);
void add_lab_command(CLI::App& app, int& exit_code);

/// No subcommand: the trainer's window. Returns the exit code.
int run_window_command();
/// `vallecula import SERIES --window`: the window, opened on the import of this series. Returns the exit code.
int run_window_import(const std::string& series);
/// `vallecula curriculum edit [FILE]`: the window, opened where courses are written. Returns the exit code.
int run_window_course(const std::string& file);
/// `vallecula trial` without --headless: the same trial, seen and (with a live device) done by a person.
int run_window_trial(const TrialSetup& setup);
/// `vallecula replay TRIAL --window`: the trial, looked at; `at_s` negative: from its beginning. `patient` may be empty.
int run_window_replay(const std::string& trial, double at_s, const std::string& patient);

/// The program's own arguments, for Qt (QApplication keeps references to them). Set once by main().
struct ProgramArguments {
  int argc = 0;
  char** argv = nullptr;
};
ProgramArguments& program_arguments();

}  // namespace vallecula::gui
