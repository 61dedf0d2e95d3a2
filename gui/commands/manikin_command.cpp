// `vallecula manikin`: the built-in patient as a CT series with its true labels.
#include <cstdio>
#include <iostream>
#include <memory>

#include "gui/commands/commands.h"
#include "gui/commands/interruption.h"
#include "gui/commands/number_options.h"
#include "gui/commands/stage_lines.h"
#include "pipeline/manikin/manikin.h"

namespace vallecula::gui {

void add_manikin_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("manikin", "Write the built-in infant as a CT series (DICOM) with its true labels");
  struct Options {
    pipeline::ManikinOptions manikin;
    std::string out;
  };
  auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "Folder to write: *.dcm and truth.nrrd; new or empty")->required();
  command->add_option("--weight", options->manikin.weight_kg, "Weight, kg")
      ->check(number_within(pipeline::kLightest, pipeline::kHeaviest))
      ->capture_default_str();
  command->add_option("--seed", options->manikin.seed, "Which infant of that weight; 0 is the unvaried design")
      ->check(whole_number_within(0, kLargestSeed))
      ->capture_default_str();
  command->add_option("--noise", options->manikin.noise_hu, "Noise of the scanner, standard deviation, HU")
      ->check(number_within(0.0, 200.0))
      ->capture_default_str();
  command->add_option("--spacing", options->manikin.in_plane_mm, "Voxels in plane, mm (left out: 0.5, below 2 kg 0.4)")
      ->check(number_within(0.4, 0.6));
  command->add_option("--slice", options->manikin.slice_mm, "Slice distance, mm (left out: 0.8, below 2 kg 0.6)")
      ->check(number_within(0.6, 1.0));
  pipeline::ManikinShape& shape = options->manikin.shape;  // left out: what the seed draws
  command->add_option("--mouth-opening", shape.mouth_opening, "Factor on the usual mouth opening, 0.8 to 1.15")
      ->check(number_within(0.8, 1.15));
  command->add_option("--tongue-size", shape.tongue_size, "Factor on the tongue's width and height, 0.9 to 1.1")
      ->check(number_within(0.9, 1.1));
  command->add_option("--larynx-height", shape.larynx_height_mm,
                      "How much higher the larynx lies, mm in a term infant, -3 to 1.5")
      ->check(number_within(-3.0, 1.5));
  command->add_option("--epiglottis-length", shape.epiglottis_length, "Factor on the epiglottis' length, 0.8 to 1.2")
      ->check(number_within(0.8, 1.2));
  command->add_option("--gestation", shape.gestation_weeks, "Weeks, 22 to 44: sets the trachea's length")
      ->check(number_within(22.0, 44.0));
  command->callback([options, &exit_code] {
    watch_for_interruption();
    StageLines lines;
    pipeline::write_manikin(options->manikin, options->out, [&lines](const std::string& stage, double fraction) {
      if (fraction < 1.0) stop_when_interrupted("the manikin");  // at 1 the series is in its place
      lines.show(stage, fraction);
    });
    lines.end_line();
    std::cout << "series: " << options->out << "\n";
    exit_code = 0;
  });
}

}  // namespace vallecula::gui
