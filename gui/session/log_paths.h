// Where a trial's package and curriculum are, as a log may say it: a path of somebody's folders holds their name.
#pragma once

#include <filesystem>
#include <string>

namespace vallecula::gui {

/// `path` as seen from the log's folder, while both lie below a folder that is not the root and in which no person's
/// own folders stand (/home and the like); else the bare name. No folder's name above the two is in it.
std::string path_for_log(const std::filesystem::path& path, const std::filesystem::path& log_folder);

/// The package a log names: seen from the log's folder, beside it, in one of the folders above, or among the built-in
/// patients. Empty when there is none.
std::filesystem::path package_of_log(const std::string& logged, const std::filesystem::path& log_folder);

}  // namespace vallecula::gui
