// Files that another program shows: a report in the browser, a folder in the files' window.
#pragma once

#include <QString>
#include <filesystem>

namespace vallecula::gui {

/// Has the desktop open it. Returns a sentence with its path for whoever waits where no program does; empty: one was
/// asked to.
QString open_outside(const std::filesystem::path& path);

}  // namespace vallecula::gui
