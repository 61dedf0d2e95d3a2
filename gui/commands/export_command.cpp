// `vallecula export`: a package's surfaces for other programs.
#include <iostream>
#include <memory>

#include "gui/commands/commands.h"
#include "pipeline/exchange/stl_files.h"

namespace vallecula::gui {

void add_export_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("export", "Write a patient package's surfaces as STL (mm, LPS)");
  struct Options {
    std::string package, stl;
  };
  auto options = std::make_shared<Options>();
  command->add_option("PACKAGE", options->package, "NAME.patient")->required();
  command->add_option("--stl", options->stl, "Folder for the STL files")->required();
  command->callback([options, &exit_code] {
    const auto package = pipeline::read_package(options->package);
    for (const auto& name : pipeline::write_stl_files(package, options->stl)) std::cout << name << "\n";
    if (package.pose.moved())
      std::cout
          << "The patient was moved after the scan: these lie in the package's frame, labels.nrrd in the scan's.\n";
    exit_code = 0;
  });
}

}  // namespace vallecula::gui
