#include "gui/session/dropped_files.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace vallecula::gui {
namespace {

namespace fs = std::filesystem;

QString say(const char* text) { return QCoreApplication::translate("DroppedFiles", text); }

QString what_can_be_used() {
  return say(QT_TRANSLATE_NOOP("DroppedFiles",
                               "Drop a CT (its folder, a DICOM, NIfTI, NRRD or MetaImage file), a patient "
                               "(NAME.patient), a course (.yaml) or a trial (its folder or .vtrial)."));
}

Dropped unusable(const QString& why) { return {DroppedKind::nothing, {}, why + " " + what_can_be_used()}; }

QString name_of(const fs::path& path) { return QString::fromStdString(path.filename().string()); }

bool ends_with(const std::string& name, const char* end) {
  const std::string tail = end;
  return name.size() > tail.size() && name.compare(name.size() - tail.size(), tail.size(), tail) == 0;
}

/// DICOM files often have no extension, or a number for one; those that say something else are something else.
bool may_be_ct(const fs::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const char* end : {".dcm", ".dicom", ".ima", ".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"})
    if (ends_with(name, end)) return true;
  const std::string extension = fs::path(name).extension().string();
  return extension.empty() || std::all_of(extension.begin() + 1, extension.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// A scan may lie some folders down, as on a hospital's disc; the search stops at the first file that may be one.
bool holds_ct(const fs::path& folder) {
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  constexpr int kMostLooked = 2000;
  for (int looked = 0; !error && at != fs::recursive_directory_iterator() && looked < kMostLooked; at.increment(error), ++looked)
    if (at->is_regular_file(error) && may_be_ct(at->path())) return true;
  return false;
}

Dropped folder_dropped(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder / "patient.yaml", error)) return {DroppedKind::patient, folder, {}};
  if (fs::exists(folder / "trial.vtrial", error)) return {DroppedKind::trial, folder, {}};
  if (folder.extension() == ".patient")
    return unusable(say(QT_TRANSLATE_NOOP("DroppedFiles", "%1 is no whole patient: it holds no patient.yaml."))
                        .arg(name_of(folder)));
  if (holds_ct(folder)) return {DroppedKind::ct, folder, {}};
  return unusable(say(QT_TRANSLATE_NOOP("DroppedFiles", "%1 holds nothing that can be opened here.")).arg(name_of(folder)));
}

Dropped file_dropped(const fs::path& file) {
  if (file.filename() == "patient.yaml") return {DroppedKind::patient, file.parent_path(), {}};
  if (file.extension() == ".vtrial") return {DroppedKind::trial, file, {}};
  if (file.extension() == ".yaml" || file.extension() == ".yml") return {DroppedKind::course, file, {}};
  if (may_be_ct(file)) return {DroppedKind::ct, file, {}};
  return unusable(say(QT_TRANSLATE_NOOP("DroppedFiles", "%1 cannot be opened here.")).arg(name_of(file)));
}

}  // namespace

Dropped what_was_dropped(const std::vector<fs::path>& paths) {
  if (paths.empty()) return unusable(say(QT_TRANSLATE_NOOP("DroppedFiles", "That is no file.")));
  std::error_code error;
  for (const fs::path& path : paths)
    if (!fs::exists(path, error))
      return unusable(say(QT_TRANSLATE_NOOP("DroppedFiles", "%1 is not there.")).arg(name_of(path)));
  if (paths.size() == 1) {
    // A folder is often given with a slash at its end, and then has no name.
    const fs::path whole = paths.front().has_filename() ? paths.front() : paths.front().parent_path();
    return fs::is_directory(whole, error) ? folder_dropped(whole) : file_dropped(whole);
  }
  const fs::path folder = paths.front().parent_path();
  const bool one_scan = std::all_of(paths.begin(), paths.end(), [&](const fs::path& path) {
    return path.parent_path() == folder && fs::is_regular_file(path, error) && may_be_ct(path);
  });
  if (one_scan) return {DroppedKind::ct, folder, {}};
  return unusable(say(QT_TRANSLATE_NOOP("DroppedFiles", "These cannot be opened together; drop one of them.")));
}

}  // namespace vallecula::gui
