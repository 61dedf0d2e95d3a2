// Qt for windows: the checks and settings that must come before it, in one place.
#pragma once

#include <QApplication>
#include <memory>

namespace vallecula::gui {

/// Throws std::runtime_error where there is no display to open a window on; Qt itself would end the program.
class WindowApplication {
 public:
  WindowApplication();
  QApplication& qt() { return *application_; }

 private:
  std::unique_ptr<QApplication> application_;
};

}  // namespace vallecula::gui
