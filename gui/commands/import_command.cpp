// `vallecula import`: a CT series to a patient package, with progress by stage and a quality report.
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "gui/commands/commands.h"
#include "gui/commands/edit_options.h"
#include "gui/commands/interruption.h"
#include "gui/commands/stage_lines.h"
#include "gui/session/play_check.h"
#include "pipeline/import.h"

namespace vallecula::gui {

namespace {

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
    std::string series, out, choose;
    bool generic_face = false, keep_position = false, newborn_size = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("SERIES", options->series, "Folder with a CT series (DICOM), or a NIfTI, NRRD or MetaImage file")->required();
  command->add_option("--series", options->choose, "Which of several: its number in `vallecula series`, or its UID");
  command->add_option("--out", options->out, "The package to write: NAME.patient")->required();
  command->add_flag("--generic-face", options->generic_face,
                    "The shipped infant's face instead of the patient's, which can be recognised");
  command->add_flag("--keep-position", options->keep_position,
                    "Leave a closed mouth closed and the neck as it lies; else the patient is put into the position of an intubation");
  command->add_flag("--scale-to-newborn", options->newborn_size,
                    "Scale all lengths so that the head has a term newborn's size");
  const EditOptions edits(*command);
  command->callback([options, edits, &exit_code] {
    pipeline::ImportOptions import;
    import.series = options->series;
    import.choose = options->choose;
    import.out = options->out;
    import.generic_face = options->generic_face;
    import.keep_position = options->keep_position;
    import.to_newborn_size = options->newborn_size;
    import.check = check_by_playing;
    edits.put_into(import);
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
