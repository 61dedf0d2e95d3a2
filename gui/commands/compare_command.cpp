// `vallecula compare`: two label maps, structure by structure.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

#include "gui/commands/commands.h"
#include "pipeline/exchange/compare.h"
#include "pipeline/exchange/label_names.h"

namespace vallecula::gui {

namespace {

QJsonValue number_or_null(double value) { return std::isfinite(value) ? QJsonValue(value) : QJsonValue(); }

void print_json(const pipeline::Comparison& comparison, int left_out_a, int left_out_b) {
  QJsonArray structures;
  for (const auto& s : comparison.structures) {
    structures.append(QJsonObject{{"name", QString::fromStdString(pipeline::name_of_label(s.label))},
                                  {"voxels_a", static_cast<double>(s.voxels[0])},
                                  {"voxels_b", static_cast<double>(s.voxels[1])},
                                  {"volume_a_ml", s.millilitres[0]},
                                  {"volume_b_ml", s.millilitres[1]},
                                  {"dice", s.dice},
                                  {"hausdorff_mm", number_or_null(s.hausdorff_mm)},
                                  {"hausdorff_95_mm", number_or_null(s.hausdorff_95_mm)},
                                  {"mean_surface_mm", number_or_null(s.mean_surface_mm)}});
  }
  const QJsonObject out{{"resampled", comparison.resampled},
                        {"segments_left_out_a", left_out_a},
                        {"segments_left_out_b", left_out_b},
                        {"structures", structures}};
  std::cout << QJsonDocument(out).toJson(QJsonDocument::Indented).toStdString();
}

void print_table(const pipeline::Comparison& comparison) {
  if (comparison.resampled)
    std::cout << "B lies on another grid than A and was resampled onto A's (nearest neighbour).\n";
  std::cout << std::left << std::setw(15) << "structure" << std::right << std::setw(10) << "A ml" << std::setw(10)
            << "B ml" << std::setw(9) << "Dice" << std::setw(14) << "Hausdorff mm" << std::setw(8) << "95 %"
            << std::setw(8) << "mean"
            << "\n"
            << std::fixed;
  for (const auto& s : comparison.structures) {
    std::cout << std::left << std::setw(15) << pipeline::name_of_label(s.label) << std::right << std::setprecision(3)
              << std::setw(10) << s.millilitres[0] << std::setw(10) << s.millilitres[1] << std::setprecision(4)
              << std::setw(9) << s.dice;
    if (std::isfinite(s.hausdorff_mm)) {
      std::cout << std::setprecision(2) << std::setw(14) << s.hausdorff_mm << std::setw(8) << s.hausdorff_95_mm
                << std::setw(8) << s.mean_surface_mm << "\n";
    } else {
      std::cout << "   only in " << (s.voxels[0] > 0 ? "A" : "B") << "\n";
    }
  }
}

/// Messages may withhold a file's name: which of the two it is must be said.
pipeline::LabelImage read_side(const char* side, const std::string& file) {
  try {
    return pipeline::read_label_image(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(side) + ": " + error.what());
  }
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("compare", "How far two label maps agree: Dice and distances by structure");
  struct Options {
    std::string a, b;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("A", options->a, "Label map: NRRD, .seg.nrrd, NIfTI or DICOM SEG")->required();
  command->add_option("B", options->b, "The one to compare with it")->required();
  command->add_flag("--json", options->json, "Print JSON instead of a table");
  command->callback([options, &exit_code] {
    const auto a = read_side("A", options->a);
    const auto b = read_side("B", options->b);
    const auto comparison = pipeline::compare_labels(a, b);
    exit_code = 0;
    if (options->json) return print_json(comparison, a.left_out, b.left_out);
    for (const auto& [name, left_out] : {std::pair{"A", a.left_out}, std::pair{"B", b.left_out}}) {
      if (left_out > 0)
        std::cout << left_out << " segments of " << name << " have none of the names known and are left out.\n";
    }
    print_table(comparison);
  });
}

}  // namespace vallecula::gui
