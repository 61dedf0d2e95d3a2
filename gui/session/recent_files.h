// What was opened lately: patients, courses, trials; kept in the user's settings.
#pragma once

#include <QDateTime>
#include <QString>
#include <filesystem>
#include <vector>

#include "gui/session/dropped_files.h"

namespace vallecula::gui {

constexpr int kMostRecent = 8;

struct RecentFile {
  DroppedKind kind = DroppedKind::nothing;
  std::filesystem::path path;
  QDateTime changed;  ///< when it was written last; of a trial its log
};

/// Puts it first. Throws std::runtime_error when the user's folder is not known.
void remember_recent(const std::filesystem::path& path);
/// Where a dialog that opens a file begins: the folder of what was opened by one last, else the person's documents,
/// else their home: one that is there.
QString folder_to_open();
/// What was chosen in one: a file, or a folder that is opened as a whole.
void keep_opened(const QString& path);
/// The paths as kept, newest first, whether they are there or not.
std::vector<std::filesystem::path> kept_recent();
/// Those of them that are there and can be opened. Asks the disk: not for the window's thread.
std::vector<RecentFile> still_there(const std::vector<std::filesystem::path>& paths);
/// "Patient: NAME", "Trial: first-look, 3 May 2026 14:02".
QString described(const RecentFile& file);

}  // namespace vallecula::gui
