// Which curricula there are: those that were shipped and the user's own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "curricula/scenario.h"

namespace vallecula::gui {

/// Where the user's own lie: "curricula" in the user's data folder. Not created here.
std::filesystem::path own_curricula_folder();
bool is_shipped(const std::filesystem::path& file);
/// The shipped file of this id; empty: none, or the folder is not there.
std::filesystem::path shipped_with_id(const std::string& id);
/// All *.yaml of both folders: the default one first, the other shipped ones, then the user's, each by name.
std::vector<std::filesystem::path> curriculum_files();
/// A file of the user's own that is not there yet: ID.yaml, ID-2.yaml, ...
std::filesystem::path free_own_file(const std::string& id);

/// Another file than `except`, of those, whose course has this id; empty: none.
std::filesystem::path course_with_id(const std::string& id, const std::filesystem::path& except);

struct FoundCurricula {
  std::vector<curricula::Curriculum> curricula;
  std::vector<std::string> refused;  ///< what is wrong with the others, one line each
};
/// What can be practised from. Throws CurriculumError when the default one cannot be read.
FoundCurricula find_curricula();

}  // namespace vallecula::gui
