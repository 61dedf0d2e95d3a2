#include "gui/commands/headless_application.h"

#include <QLocale>
#include <clocale>

#include "gui/commands/commands.h"

namespace vallecula::gui {

ProgramArguments& program_arguments() {
  static ProgramArguments arguments;
  return arguments;
}

HeadlessApplication::HeadlessApplication() {
  // By argument, not by environment: a program this one starts may have a display.
  static char program[] = "vallecula", option[] = "-platform", platform[] = "offscreen";
  static char* arguments[] = {program, option, platform, nullptr};
  static int count = 0;  // Qt keeps a reference, and takes out what it understood
  count = 3;
  arguments[1] = option;
  arguments[2] = platform;
  application_ = std::make_unique<QGuiApplication>(count, arguments);
  write_plain_numbers();
}

void write_plain_numbers() {
  std::setlocale(LC_NUMERIC, "C");  // Qt has taken all of the system's
  QLocale::setDefault(QLocale::c());
}

}  // namespace vallecula::gui
