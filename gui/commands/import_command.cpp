// `vallecula import`: a CT series to a patient package, with progress by stage and a quality report.
#include <sys/resource.h>

#include <iomanip>
#include <iostream>
#include <memory>

#include "gui/commands/commands.h"
#include "gui/commands/edit_options.h"
#include "gui/commands/interruption.h"
#include "gui/commands/stage_lines.h"
#include "gui/session/play_check.h"
#include "pipeline/import.h"
#include "pipeline/quality.h"

namespace vallecula::gui {

namespace {

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
  for (const pipeline::QualityGroup& group : pipeline::in_groups(report.quality)) {
    std::cout << group.title << " (" << group.items.size() << ")\n" << std::left;
    for (const pipeline::QualityItem& item : group.items)
      std::cout << "  " << std::setw(36) << item.name << " " << std::setw(16) << pipeline::value_text(item) << " "
                << item.note << "\n";
  }
}

}  // namespace

void add_import_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("import", "Make a patient package from a CT series");
  struct Options {
    std::string series, out, choose;
    bool generic_face = false, replace = false, window = false;
    int tetrahedra = pipeline::ImportOptions().tetrahedra;
    bool keep_position = false, newborn_size = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("SERIES", options->series, "Folder with a CT series (DICOM), or a NIfTI, NRRD or MetaImage file")->required();
  command->add_option("--series", options->choose, "Which of several: its number in `vallecula series`, or its UID");
  command->add_option("--out", options->out, "The package to write: NAME.patient (needed without --window)");
  command->add_flag("--generic-face", options->generic_face,
                    "The shipped infant's face instead of the patient's, which can be recognised");
  command->add_flag("--replace", options->replace, "Replace a package already there, when the new one is whole");
  command
      ->add_option("--tets", options->tetrahedra, "Tetrahedra of the tongue, about (within 10 %)")
      ->check(CLI::Range(1000, 100000))
      ->capture_default_str();
  command->add_flag("--window", options->window, "Open the trainer's window on this import instead, to do it step by step");
  command->add_flag("--keep-position", options->keep_position,
                    "Leave a closed mouth closed and the neck as it lies; else the patient is put into the position of an intubation");
  command->add_flag("--scale-to-newborn", options->newborn_size,
                    "Scale all lengths so that the head has a term newborn's size");
  const EditOptions edits(*command);
  command->callback([options, edits, command, &exit_code] {
    if (options->window) {
      for (const CLI::Option* option : command->get_options())
        if (option->count() > 0 && option->get_name() != "SERIES" && option->get_name() != "--window")
          throw CLI::ValidationError("--window", "leaves no room for " + option->get_name() + ": it is asked for in the window");
      exit_code = run_window_import(options->series);
      return;
    }
    if (options->out.empty()) throw CLI::RequiredError("--out");
    pipeline::ImportOptions import;
    import.series = options->series;
    import.choose = options->choose;
    import.out = options->out;
    import.generic_face = options->generic_face;
    import.keep_position = options->keep_position;
    import.to_newborn_size = options->newborn_size;
    import.check = check_by_playing;
    import.replace = options->replace;
    import.tetrahedra = options->tetrahedra;
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
