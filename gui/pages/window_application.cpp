#include "gui/pages/window_application.h"

#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "gui/commands/commands.h"
#include "gui/pages/look_settings.h"
#include "gui/session/languages.h"
#include "gui/session/virtual_display.h"
#include "gui/views/gl_view.h"

namespace vallecula::gui {
namespace {

// Qt makes the same folder where there is no session, and complains about it on every start.
void name_runtime_folder() {
  if (qEnvironmentVariableIsSet("XDG_RUNTIME_DIR")) return;
  const std::string folder = "/tmp/runtime-" + std::to_string(getuid());
  mkdir(folder.c_str(), 0700);
  struct stat found {};
  if (stat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == getuid() &&
      (found.st_mode & 0077) == 0)
    setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
}

}  // namespace

WindowApplication::WindowApplication() {
  const std::string problem = display_problem();
  if (!problem.empty())
    throw std::runtime_error(problem +
                             ", so no window can be opened; start it where there is a screen, or run `vallecula demo` "
                             "or `vallecula trial --headless`, which need none");
  name_runtime_folder();
  prepare_opengl();
  ProgramArguments& arguments = program_arguments();
  static char program[] = "vallecula";
  static char* just_program[] = {program, nullptr};
  static int one = 1;
  application_ = arguments.argv != nullptr ? std::make_unique<QApplication>(arguments.argc, arguments.argv)
                                           : std::make_unique<QApplication>(one, just_program);
  std::setlocale(LC_NUMERIC,
                 "C");  // Qt has taken the system's; what is shown goes by QLocale, what files hold does not
  QApplication::setApplicationName("Vallecula");
  QApplication::setApplicationDisplayName("Vallecula");
  install_language(*application_, language_at_start());
  note_system_palette();
  apply_look(look_settings());
}

}  // namespace vallecula::gui
