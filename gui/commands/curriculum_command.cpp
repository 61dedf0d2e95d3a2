// `vallecula curriculum check`: is this file a curriculum, and if not, where not.
#include <iostream>
#include <memory>

#include "curricula/scenario.h"
#include "gui/commands/commands.h"

namespace vallecula::gui {

void add_curriculum_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("curriculum", "Work with curriculum files");
  command->require_subcommand(1);
  CLI::App* check =
      command->add_subcommand("check", "Validate a curriculum; errors name file, line, field and what was expected");
  auto file = std::make_shared<std::string>();
  check->add_option("FILE", *file, "Curriculum (YAML)")->required();
  check->callback([file, &exit_code] {
    const curricula::Curriculum curriculum = curricula::load_curriculum(*file);
    std::cout << *file << ": " << curriculum.title << " (" << curriculum.id << "), " << curriculum.scenarios.size()
              << " scenarios, valid\n";
    for (const curricula::Scenario& scenario : curriculum.scenarios) {
      std::cout << "  " << scenario.id << ": " << scenario.title << "\n";
    }
    exit_code = 0;
  });
}

}  // namespace vallecula::gui
