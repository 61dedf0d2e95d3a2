// What a file or folder is that a person drops on the window or opens from its menu.
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

namespace vallecula::gui {

enum class DroppedKind { ct, patient, course, trial, nothing };

struct Dropped {
  DroppedKind kind = DroppedKind::nothing;
  std::filesystem::path path;  ///< what is to be opened: a package's or trial's folder, a scan's file or folder
  QString message;             ///< of `nothing`: why, and what can be used
};

/// Decides by what lies there, not by a name alone: a folder with patient.yaml is a patient, one with trial.vtrial a
/// trial, another folder with files a CT. Several files are one CT where they lie in one folder. Reads folders: not for
/// the window's thread.
Dropped what_was_dropped(const std::vector<std::filesystem::path>& paths);

}  // namespace vallecula::gui
