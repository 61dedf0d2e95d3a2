// `vallecula import`: a CT series to a patient package, with progress by stage and a quality report.
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "gui/commands/commands.h"
#include "gui/commands/interruption.h"
#include "gui/commands/stage_lines.h"
#include "pipeline/import.h"

namespace vallecula::gui {

namespace {

/// NAME=x,y,z
std::pair<std::string, pipeline::Point> parse_seed(const std::string& text) {
  const std::size_t equals = text.find('=');
  pipeline::Point point{};
  std::istringstream numbers(equals == std::string::npos ? "" : text.substr(equals + 1));
  char comma1 = 0, comma2 = 0;
  numbers >> point[0] >> comma1 >> point[1] >> comma2 >> point[2];
  if (equals == std::string::npos || equals == 0 || !numbers || comma1 != ',' || comma2 != ',' ||
      numbers.peek() != EOF) {
    throw CLI::ValidationError("--seed", "'" + text + "' is not NAME=x,y,z (mm, LPS), for instance tongue=0,-40.5,12");
  }
  return {text.substr(0, equals), point};
}

void print_report(const pipeline::ImportReport& report) {
  std::cout << "package: " << report.package.string() << "\n";
  for (const pipeline::QualityItem& item : report.quality) {
    std::ostringstream value;
    value << std::setprecision(5) << item.value << " " << item.unit;
    const char* verdict = !item.judged ? "     " : item.ok ? "ok   " : "LOOK ";
    std::cout << "  " << verdict << std::left << std::setw(38) << item.name << std::setw(18)
              << value.str() << item.note << "\n";
  }
}

}  // namespace

void add_import_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("import", "Make a patient package from a CT series");
  struct Options {
    std::string series, out;
    std::vector<std::string> seeds;
    bool window = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("SERIES", options->series, "Folder with one CT series (DICOM)")->required();
  command->add_option("--out", options->out, "The package to write: NAME.patient; without --window required");
  command->add_flag("--window", options->window, "Open the trainer's window on this import, to look at it step by step");
  command->add_option("--seed", options->seeds,
                      "A point inside a structure that is not found by itself: NAME=x,y,z (mm, LPS)");
  command->callback([options, &exit_code] {
    if (options->window) {
      if (!options->out.empty() || !options->seeds.empty())
        throw CLI::ValidationError("--window", "takes only SERIES: name and seeds are given in the window");
      exit_code = run_window_import(options->series);
      return;
    }
    if (options->out.empty()) throw CLI::RequiredError("--out");
    pipeline::ImportOptions import;
    import.series = options->series;
    import.out = options->out;
    for (const std::string& seed : options->seeds) import.edits.seeds.insert(parse_seed(seed));
    watch_for_interruption();
    StageLines lines;
    const pipeline::ImportReport report =
        pipeline::import_series(import, [&lines](const std::string& stage, double fraction) {
          if (fraction < 1.0) stop_when_interrupted("the import");  // at 1 the package is in its place
          lines.show(stage, fraction);
        });
    lines.end_line();
    print_report(report);
    exit_code = 0;
  });
}

}  // namespace vallecula::gui
