// `vallecula import`: a CT series to a patient package, with progress by stage and a quality report.
#include <sys/resource.h>

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
  double seconds = 0.0;
  std::cout << std::fixed << std::setprecision(1) << "stages:";
  for (const pipeline::ImportStage& stage : report.stages) {
    std::cout << " " << stage.name << " " << stage.seconds << " s,";
    seconds += stage.seconds;
  }
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  std::cout << " together " << seconds << " s; most memory " << used.ru_maxrss / 1024 << " MB\n" << std::defaultfloat;
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
    bool replace = false;
    int tetrahedra = pipeline::ImportOptions().tetrahedra;
    std::vector<std::string> seeds;
  };
  auto options = std::make_shared<Options>();
  command->add_option("SERIES", options->series, "Folder with one CT series (DICOM)")->required();
  command->add_option("--out", options->out, "The package to write: NAME.patient")->required();
  command->add_option("--seed", options->seeds,
                      "A point inside a structure that is not found by itself: NAME=x,y,z (mm, LPS)");
  command->add_flag("--replace", options->replace, "Replace a package already there, when the new one is whole");
  command
      ->add_option("--tets", options->tetrahedra, "Tetrahedra of the tongue, about (within 10 %)")
      ->check(CLI::Range(1000, 100000))
      ->capture_default_str();
  command->callback([options, &exit_code] {
    pipeline::ImportOptions import;
    import.series = options->series;
    import.out = options->out;
    import.replace = options->replace;
    import.tetrahedra = options->tetrahedra;
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
