// What Qt needs where no window is opened: fonts for the chart, plugins for the database.
#pragma once

#include <QGuiApplication>
#include <memory>

namespace vallecula::gui {

/// Reports, tables and figures of commands have a decimal point wherever they are made: other programs read them.
void write_plain_numbers();

/// A QGuiApplication on Qt's offscreen platform, which needs no display. Only one Qt application may live at a time.
class HeadlessApplication {
 public:
  HeadlessApplication();

 private:
  std::unique_ptr<QGuiApplication> application_;
};

}  // namespace vallecula::gui
