// Progress by stage on stderr.
#pragma once

#include <string>

namespace vallecula::gui {

/// One line a stage; on a terminal the line counts up while the stage runs. Its destructor ends the open line, so that
/// a message that follows stands on its own.
class StageLines {
 public:
  StageLines();
  ~StageLines() { end_line(); }
  StageLines(const StageLines&) = delete;
  StageLines& operator=(const StageLines&) = delete;
  void show(const std::string& stage, double fraction);
  void end_line();

 private:
  bool terminal_;
  std::string stage_;
};

}  // namespace vallecula::gui
