#include "gui/session/curricula_files.h"

#include <algorithm>
#include <stdexcept>

#include "gui/session/user_paths.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> yaml_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.is_regular_file(none) && entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path own_curricula_folder() { return user_data_folder() / "curricula"; }

bool is_shipped(const fs::path& file) {
  std::error_code none;
  return fs::equivalent(file.parent_path().empty() ? fs::path(".") : file.parent_path(), curricula_folder(), none);
}

fs::path shipped_with_id(const std::string& id) {
  for (const fs::path& file : yaml_files_in(curricula_folder())) try {
      if (curricula::load_curriculum(file).id == id) return file;
    } catch (const std::exception&) {
      continue;  // one that cannot be read is no help here; who opens it is told
    }
  return {};
}

std::vector<fs::path> curriculum_files() {
  const fs::path first = default_curriculum();
  std::vector<fs::path> files = yaml_files_in(first.parent_path());
  std::stable_partition(files.begin(), files.end(), [&](const fs::path& file) { return file == first; });
  for (const fs::path& own : yaml_files_in(own_curricula_folder())) files.push_back(own);
  return files;
}

fs::path free_own_file(const std::string& id) {
  const fs::path folder = own_curricula_folder();
  fs::path file = folder / (id + ".yaml");
  for (int n = 2; fs::exists(file); ++n) file = folder / (id + "-" + std::to_string(n) + ".yaml");
  return file;
}

fs::path course_with_id(const std::string& id, const fs::path& except) {
  std::error_code none;
  for (const fs::path& file : curriculum_files()) try {
      if (!fs::equivalent(file, except, none) && curricula::load_curriculum(file).id == id) return file;
    } catch (const std::exception&) {
      continue;  // one that cannot be read is offered to nobody
    }
  return {};
}

FoundCurricula find_curricula() {
  FoundCurricula found;
  for (const fs::path& file : curriculum_files()) try {
      curricula::Curriculum read = curricula::load_curriculum(file);
      for (const curricula::Curriculum& other : found.curricula)
        if (other.id == read.id)
          throw std::runtime_error(file.string() + ": has the id '" + read.id + "' of " + other.file.filename().string() +
                                   ", and the records would take the two for one; give it another id");
      found.curricula.push_back(std::move(read));
    } catch (const std::exception& error) {
      if (found.curricula.empty()) throw;        // the default one
      found.refused.emplace_back(error.what());  // one that is being written must not keep the others away
    }
  return found;
}

}  // namespace vallecula::gui
