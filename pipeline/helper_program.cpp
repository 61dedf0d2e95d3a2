#include "pipeline/helper_program.h"

#include <unistd.h>

#include <cstdlib>
#include <vector>

namespace vallecula::pipeline {

namespace fs = std::filesystem;

std::optional<fs::path> find_helper_program(const char* name) {
  std::vector<fs::path> places;
  if (const char* folder = std::getenv("VALLECULA_HELPERS"); folder != nullptr && *folder != '\0')
    places.emplace_back(folder);
  std::error_code error;
  const auto program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    places.push_back(program.parent_path());
    places.push_back(program.parent_path() / ".." / "lib" / "vallecula");
  }
  for (const auto& place : places) {
    const auto helper = place / name;
    if (::access(helper.c_str(), X_OK) == 0) return helper;
  }
  return {};
}

}  // namespace vallecula::pipeline
