#include "pipeline/package/aside.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <vector>

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

std::string tag_of(const fs::path& target) { return "." + target.filename().string() + "."; }

/// The process in ".NAME.patient.PID.part"; 0 when it is something else's name.
pid_t process_in(const std::string& name, const std::string& tag, const std::string& ending) {
  if (name.size() <= tag.size() + ending.size() || name.compare(0, tag.size(), tag) != 0 ||
      name.compare(name.size() - ending.size(), ending.size(), ending) != 0)
    return 0;
  const auto digits = name.substr(tag.size(), name.size() - tag.size() - ending.size());
  if (digits.find_first_not_of("0123456789") != std::string::npos || digits.size() > 9) return 0;
  return static_cast<pid_t>(std::atoi(digits.c_str()));
}

bool gone(pid_t process) { return process > 0 && ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

fs::path package_folder(const fs::path& written) {
  const auto target = fs::absolute(written).lexically_normal();
  return target.filename().empty() ? target.parent_path() : target;
}

Asides asides_of(const fs::path& target) {
  const auto stem = tag_of(target) + std::to_string(::getpid());
  return {target.parent_path() / (stem + ".part"), target.parent_path() / (stem + ".old")};
}

void clean_asides(const fs::path& target) {
  std::error_code ignored;
  std::vector<fs::path> parts;
  std::vector<fs::path> olds;
  for (const auto& entry : fs::directory_iterator(target.parent_path(), ignored)) {
    const auto name = entry.path().filename().string();
    if (gone(process_in(name, tag_of(target), ".part"))) parts.push_back(entry.path());
    if (gone(process_in(name, tag_of(target), ".old"))) olds.push_back(entry.path());
  }
  for (const auto& old : olds) {
    if (!fs::exists(target, ignored)) fs::rename(old, target, ignored);
    fs::remove_all(old, ignored);
  }
  for (const auto& part : parts) fs::remove_all(part, ignored);
}

}  // namespace vallecula::pipeline
