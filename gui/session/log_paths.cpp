#include "gui/session/log_paths.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "gui/session/builtin_patient.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

/// Without symbolic links: only then does ".." mean the same to everyone.
fs::path real(const fs::path& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(fs::absolute(path), error);
  fs::path plain = error ? fs::absolute(path).lexically_normal() : found;
  return plain.has_filename() ? plain : plain.parent_path();  // a trailing slash
}

fs::path common_folder(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end() && *i == *j; ++i, ++j) common /= *i;
  return common;
}

/// Folders whose folders are named after people.
bool holds_peoples_folders(const fs::path& folder) {
  if (folder.empty() || folder == folder.root_path()) return true;
  for (const char* known : {"/home", "/media", "/run/media", "/var/home"})
    if (folder == known) return true;
  const char* home = std::getenv("HOME");
  return home != nullptr && *home != '\0' && folder == real(home).parent_path();
}

}  // namespace

std::string path_for_log(const fs::path& path, const fs::path& log_folder) {
  const fs::path target = real(path), from = real(log_folder);
  if (holds_peoples_folders(common_folder(target, from))) return target.filename().string();
  return target.lexically_relative(from).string();
}

fs::path package_of_log(const std::string& logged, const fs::path& log_folder) {
  const fs::path name = fs::path(logged).filename(), from = real(log_folder);
  std::vector<fs::path> candidates = {from / logged, fs::path(logged)};  // older logs hold the path as it was given
  for (fs::path folder = from; folder != folder.root_path(); folder = folder.parent_path())
    candidates.push_back(folder / name);
  if (const fs::path kept = builtin_patients_folder(); !kept.empty()) candidates.push_back(kept / name);
  std::error_code error;
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&error](const fs::path& candidate) {
    return fs::exists(candidate / "patient.yaml", error);
  });
  return found == candidates.end() ? fs::path() : *found;
}

}  // namespace vallecula::gui
