// A display to draw on where there is none: an own Xvfb for as long as it is needed.
#pragma once

#include <sys/types.h>

#include <string>

namespace vallecula::gui {

/// Why nothing can be drawn on the display the environment names; empty when it answers (or cannot be told from here).
std::string display_problem();

/// Starts Xvfb on a free display number and points DISPLAY at it; the destructor ends it and puts DISPLAY back. The
/// server also ends with this program, however that dies.
class VirtualDisplay {
 public:
  /// Throws std::runtime_error saying how to mend it when Xvfb is missing or does not start.
  VirtualDisplay(int width = 1920, int height = 1200);
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  const std::string& name() const { return name_; }  ///< ":99"
  pid_t process() const { return process_; }

 private:
  void end_server();
  pid_t process_ = -1;
  std::string name_, display_before_, wayland_before_;
  bool had_display_ = false, had_wayland_ = false;
};

}  // namespace vallecula::gui
