#include "gui/session/user_paths.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace vallecula::gui {

namespace fs = std::filesystem;

const char* set_variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

fs::path user_data_folder() {
  if (const char* home = set_variable("VALLECULA_HOME")) return home;
  if (const char* data = set_variable("XDG_DATA_HOME")) return fs::path(data) / "vallecula";
  if (const char* home = set_variable("HOME")) return fs::path(home) / ".local" / "share" / "vallecula";
  throw std::runtime_error("no folder for the user's data is known: set VALLECULA_HOME to one");
}

fs::path records_database() {
  const fs::path folder = user_data_folder();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw std::runtime_error(folder.string() + ": the user's data folder cannot be created (" + error.message() +
                             "); set VALLECULA_HOME to a folder you may write to");
  }
  return folder / "records.sqlite";
}

fs::path curricula_folder() {
  if (const char* folder = set_variable("VALLECULA_CURRICULA")) {
    if (!fs::is_directory(folder)) {
      throw std::runtime_error(std::string(folder) + ": VALLECULA_CURRICULA names no folder; correct or unset it");
    }
    return folder;
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "vallecula" / "curricula";
  if (!error && fs::is_directory(installed)) return installed;
  const fs::path source = fs::path(VALLECULA_SOURCE_DIR) / "curricula" / "courses";
  if (fs::is_directory(source)) return source;
  throw std::runtime_error("the shipped curricula were not found beside the program (" + installed.string() +
                           "); set VALLECULA_CURRICULA to the folder that holds them");
}

fs::path default_curriculum() {
  const fs::path folder = curricula_folder();
  if (const fs::path first = folder / "first-steps.yaml"; fs::is_regular_file(first)) return first;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  if (files.empty()) throw std::runtime_error(folder.string() + ": holds no curriculum (*.yaml)");
  return *std::min_element(files.begin(), files.end());
}

}  // namespace vallecula::gui
