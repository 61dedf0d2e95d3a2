// `vallecula records`: what educators hand on, as tables, statements and pages, and the delivery of statements.
#include <QDateTime>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "curricula/export/delivery.h"
#include "curricula/export/tick_table.h"
#include "curricula/export/trial_table.h"
#include "curricula/records/recovery.h"
#include "gui/commands/commands.h"
#include "gui/commands/headless_application.h"
#include "gui/commands/interruption.h"
#include "gui/commands/number_options.h"
#include "gui/commands/sign_in.h"
#include "gui/report/pdf_report.h"
#include "gui/session/files.h"
#include "gui/session/lrs_settings.h"
#include "gui/session/trial_record.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

struct ExportOptions {
  std::string format, trial, curriculum, since, until, sign_in, cmi5, out;
  long long trainee = -1;
  bool names = false;
};

fs::path log_of(const std::string& trial) {
  const fs::path path = fs::absolute(trial).lexically_normal();
  return fs::is_directory(path) ? path / "trial.vtrial" : path;
}

std::vector<curricula::ExportTrial> trials(curricula::Records& records, const curricula::Who& who,
                                           const ExportOptions& options) {
  curricula::ExportFilter filter;
  if (options.trainee >= 0) filter.trainee_id = options.trainee;
  filter.curriculum_id = options.curriculum;
  filter.since_utc = options.since;
  filter.until_utc = options.until;
  filter.names = options.names;
  std::vector<curricula::ExportTrial> found = curricula::trials_to_export(records, who, filter);
  if (options.trial.empty()) return found;
  // By what is in the log: its folder may have been moved, and on another station the same path is another trial.
  const std::string sha256 = curricula::log_sha256(log_of(options.trial));
  const std::string station = records_location().station;
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const curricula::ExportTrial& one) {
                               return sha256.empty() || one.row.log_sha256 != sha256 || one.row.station != station;
                             }),
              found.end());
  if (found.empty())
    throw std::runtime_error(options.trial + ": these records have no trial of yours there; sign in (--sign-in) as whose "
                             "it is or as an instructor, or check the folder");
  return {found.back()};  // scripts may do the same trial twice, to the byte
}

void hand_out(const std::string& bytes, const std::string& out) {
  if (out.empty())
    std::cout << bytes;
  else
    write_file_whole(out, bytes);
}

curricula::Who signed_in(curricula::Records& records, const ExportOptions& options) {
  if (options.sign_in.empty()) return std::nullopt;
  curricula::People people(records);
  return sign_in(people, options.sign_in);
}

std::string statements(curricula::Records& records, const std::vector<curricula::ExportTrial>& trials,
                       const ExportOptions& options) {
  const auto chosen = chosen_lrs();
  const curricula::XapiSource source = curricula::xapi_source(records, chosen ? chosen->home_page : "");
  std::optional<curricula::Cmi5Launch> launch;
  if (!options.cmi5.empty()) launch = curricula::read_cmi5_launch(read_file(options.cmi5));
  std::vector<curricula::XapiStatement> all;
  for (const curricula::ExportTrial& trial : trials)
    for (curricula::XapiStatement& one : curricula::statements_of(trial.row, source, launch))
      all.push_back(std::move(one));
  return curricula::json_array(all);
}

void write_pdf(const ExportOptions& options) {
  const HeadlessApplication application;
  if (!options.trial.empty()) {
    const curricula::TrialLog log = curricula::read_trial_log(options.trial);
    std::string name;
    if (options.names) {
      curricula::Records records(records_location());
      name = trials(records, signed_in(records, options), options).front().trainee_name;
    }
    write_trial_pdf(options.out, log, name);
    return;
  }
  curricula::Records records(records_location());
  const curricula::Who who = signed_in(records, options);
  const auto found = trials(records, who, options);
  if (found.empty()) throw std::runtime_error("--trainee: there is no trial of theirs; nothing is written");
  write_trainee_pdf(options.out, options.trainee, found.front().trainee_name, found);
}

int export_records(const ExportOptions& options) {
  if (options.format == "pdf") {
    write_pdf(options);
    return 0;
  }
  if (options.format == "csv" && !options.trial.empty()) {
    hand_out(curricula::ticks_csv(curricula::read_trial_log(options.trial)), options.out);
    return 0;
  }
  curricula::Records records(records_location());
  const auto found = trials(records, signed_in(records, options), options);
  hand_out(options.format == "csv" ? curricula::trials_csv(found, options.names) : statements(records, found, options),
           options.out);
  return 0;
}

void check(const ExportOptions& options) {
  const auto refuse = [](bool wrong, const char* option, const char* why) {
    if (wrong) throw CLI::ValidationError(option, why);
  };
  const bool trial = !options.trial.empty(), trainee = options.trainee >= 0;
  refuse(options.format == "pdf" && trial == trainee, "--format", "pdf is of one --trial or of one --trainee");
  refuse(options.format == "pdf" && options.out.empty(), "--out", "is needed: a PDF is written to a file");
  refuse(trial && (trainee || !options.curriculum.empty() || !options.since.empty() || !options.until.empty()),
         "--trial", "is one trial: leave out --trainee, --curriculum, --since and --until");
  const auto a_time = [](const std::string& text) {
    const bool whole_day = text.size() == 10, in_utc = !text.empty() && text.back() == 'Z';
    return text.empty() ||
           ((whole_day || in_utc) && QDateTime::fromString(QString::fromStdString(text), Qt::ISODate).isValid());
  };
  refuse(!a_time(options.since), "--since", "is no time in UTC: give one as 2026-05-03 or 2026-05-03T10:00:00Z");
  refuse(!a_time(options.until), "--until", "is no time in UTC: give one as 2026-05-03 or 2026-05-03T10:00:00Z");
  refuse(options.names && options.sign_in.empty(), "--names", "are for instructors: add --sign-in NAME");
  refuse(options.names && options.format == "xapi", "--names", "are in no statement: leave it out");
  refuse(options.names && trial && options.format == "csv", "--names", "are in no table of ticks: leave it out");
  refuse(!options.cmi5.empty() && (options.format != "xapi" || !trial), "--cmi5", "goes with --format xapi --trial DIR");
}

/// "1 trial", "3 trials".
std::string trials_in_words(int count) { return std::to_string(count) + (count == 1 ? " trial" : " trials"); }

int send(bool refused_again, bool everything, std::uint64_t tries) {
  const auto chosen = chosen_lrs();
  if (!chosen)
    throw std::runtime_error(
        "no learning record store is set; write address, key and secret into settings.ini in the user's data folder, "
        "under [lrs]");
  const HeadlessApplication application;
  watch_for_interruption();
  curricula::Records records(records_location());
  if (everything) curricula::send_all_again(records);
  if (refused_again) curricula::send_refused_again(records);
  const curricula::XapiSource source = curricula::xapi_source(records, chosen->home_page);
  curricula::Delivery total;
  for (std::uint64_t failures = 1;; ++failures) {
    const curricula::Delivery one = curricula::send_waiting(records, chosen->lrs, source);
    total.sent += one.sent;
    total.refused += one.refused;
    total.left = one.left;
    total.problem = one.problem;
    if (!one.again_later || failures >= tries || interrupted()) break;
    const double pause_s = curricula::pause_after_s(static_cast<int>(failures));
    std::cerr << one.problem << "; again in " << pause_s << " s\n";
    for (double waited_s = 0.0; waited_s < pause_s && !interrupted(); waited_s += 0.1)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  const curricula::Waiting waiting = curricula::waiting_statements(records);
  std::cout << trials_in_words(total.sent) << " sent, " << waiting.waiting << " left, " << waiting.refused
            << " refused\n";
  if (!total.problem.empty()) throw std::runtime_error(total.problem);
  if (total.refused > 0)
    throw std::runtime_error(trials_in_words(total.refused) + " refused and kept aside: " + waiting.last_refusal +
                             "; --again tries them once more");
  return 0;
}

}  // namespace

void add_records_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("records", "Hand on what was recorded: CSV, xAPI statements, PDF reports");
  command->require_subcommand(1);

  auto options = std::make_shared<ExportOptions>();
  CLI::App* exporting = command->add_subcommand("export", "Write trials for other programs and people");
  exporting
      ->add_option("--format", options->format,
                   "csv: a row a trial, of one --trial a row a tick; xapi: statements; pdf: a report")
      ->required()
      ->check(CLI::IsMember({"csv", "xapi", "pdf"}));
  exporting->add_option("--trial", options->trial, "Folder of one trial, or its trial.vtrial");
  exporting->add_option("--trainee", options->trainee, "The trials of the trainee with this number; 0: nobody's")
      ->check(whole_number_within(0, kLargestSeed));
  exporting->add_option("--curriculum", options->curriculum, "Only trials of this curriculum (its id)");
  exporting->add_option("--since", options->since, "Only trials finished at this time or later (2026-05-03T10:00:00Z)");
  exporting->add_option("--until", options->until, "Only trials finished before this time");
  exporting->add_option("--sign-in", options->sign_in,
                        "As this person: an instructor has everybody's trials, a trainee the own; without it those that "
                        "belong to nobody. The PIN is asked for, or read from the input");
  exporting->add_flag("--names", options->names, "With the trainees' names (instructors only); else numbers alone");
  exporting->add_option("--cmi5", options->cmi5,
                        "xapi of one --trial: what the learning management system gave at the launch (JSON)");
  exporting->add_option("--out", options->out, "File to write; left out: the output (not for pdf)");
  exporting->callback([options, &exit_code] {
    check(*options);
    exit_code = export_records(*options);
  });

  auto ticks = std::make_shared<bool>(false);
  CLI::App* columns = command->add_subcommand("columns", "The columns of the CSV files as a Markdown table");
  columns->add_flag("--ticks", *ticks, "Of the table of one trial's ticks");
  columns->callback([ticks, &exit_code] {
    std::cout << (*ticks ? curricula::tick_column_table() : curricula::trial_column_table());
    exit_code = 0;
  });

  struct SendOptions {
    bool again = false, everything = false;
    std::uint64_t tries = 3;
  };
  auto sending = std::make_shared<SendOptions>();
  CLI::App* send_command =
      command->add_subcommand("send", "Send statements that wait to the learning record store of settings.ini");
  send_command->add_flag("--again", sending->again, "Those that were refused as well");
  send_command->add_flag("--everything", sending->everything, "What was sent before as well: for another store");
  send_command->add_option("--tries", sending->tries, "So often, when the store does not answer")
      ->check(whole_number_within(1, 20))
      ->capture_default_str();
  send_command->callback(
      [sending, &exit_code] { exit_code = send(sending->again, sending->everything, sending->tries); });
}

}  // namespace vallecula::gui
