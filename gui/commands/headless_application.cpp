#include "gui/commands/headless_application.h"

#include "gui/commands/commands.h"

namespace vallecula::gui {

ProgramArguments& program_arguments() {
  static ProgramArguments arguments;
  return arguments;
}

HeadlessApplication::HeadlessApplication() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  ProgramArguments& arguments = program_arguments();
  application_ = std::make_unique<QGuiApplication>(arguments.argc, arguments.argv);
}

}  // namespace vallecula::gui
