#include "gui/commands/stage_lines.h"

#include <unistd.h>

#include <cstdio>

namespace vallecula::gui {

StageLines::StageLines() : terminal_(isatty(STDERR_FILENO) != 0) {}

void StageLines::show(const std::string& stage, double fraction) {
  if (stage != stage_) {
    end_line();
    stage_ = stage;
    if (!terminal_) std::fprintf(stderr, "%3.0f %%  %s\n", 100.0 * fraction, stage.c_str());
  }
  if (terminal_) std::fprintf(stderr, "\r%3.0f %%  %s", 100.0 * fraction, stage.c_str());
}

void StageLines::end_line() {
  if (terminal_ && !stage_.empty()) std::fputc('\n', stderr);
  stage_.clear();
}

}  // namespace vallecula::gui
